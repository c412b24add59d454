// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "output/write_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace tool {

/// The places of the vertices of a mesh in a texture, each once: a vertex has several at seams.
struct Texture_places {
  std::vector<int> vertex;
  std::vector<Uv> place;
  std::vector<std::uint32_t> number; ///< by halfedge, of the place at its target

  /// Triangles of any kind will do: there need be no order round a vertex.
  Texture_places(const Mesh& mesh, const std::vector<Uv>& uv) : number(uv.size())
  {
    const auto key = [&](std::size_t h) {
      return std::pair(target(Mesh::Halfedge_index(static_cast<int>(h)), mesh).idx(), uv[h]);
    };
    std::vector<std::size_t> end(mesh.number_of_vertices() + 1, 0), order(uv.size()); // by vertex, then by place
    for(std::size_t h = 0; h < uv.size(); ++h)
      ++end[key(h).first + 1];
    std::partial_sum(end.begin(), end.end(), end.begin());
    for(std::size_t h = 0; h < uv.size(); ++h)
      order[end[key(h).first]++] = h;
    for(std::size_t begin = 0, v = 0; v < mesh.number_of_vertices(); begin = end[v++])
      std::sort(order.data() + begin, order.data() + end[v],
                [&](std::size_t g, std::size_t h) { return std::pair(uv[g], g) < std::pair(uv[h], h); });
    for(std::size_t i = 0; i < order.size(); ++i) {
      if(i == 0 || key(order[i]) != key(order[i - 1])) {
        vertex.push_back(static_cast<int>(key(order[i]).first));
        place.push_back(uv[order[i]]);
      }
      number[order[i]] = static_cast<std::uint32_t>(place.size() - 1);
    }
  }
};

} // namespace tool
