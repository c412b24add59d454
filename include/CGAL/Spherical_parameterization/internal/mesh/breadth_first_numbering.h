// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_BREADTH_FIRST_NUMBERING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_BREADTH_FIRST_NUMBERING_H

#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/base/text.h>
#include <CGAL/Spherical_parameterization/internal/mesh/check_face_graph.h>

#include <algorithm>
#include <cstddef>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// Numbers the vertices of a connected mesh in breadth-first order. Fills `position`, by new number; returns the new
/// number by position.
inline Host_array<int> number_breadth_first(const Neighbours& neighbours, Host_array<int>& position)
{
  const int n = static_cast<int>(neighbours.offset.size()) - 1;
  Host_array<int> index(n, -1);
  position.reserve(n);
  const auto visit = [&](int p) {
    if(index[p] < 0) {
      index[p] = static_cast<int>(position.size());
      position.push_back(p);
    }
  };
  std::size_t components = 0;
  for(int seed = 0; seed < n; ++seed) {
    if(index[seed] >= 0)
      continue;
    ++components;
    std::size_t head = position.size();
    visit(seed);
    for(; head < position.size(); ++head)
      for(int k = neighbours.offset[position[head]]; k < neighbours.offset[position[head] + 1]; ++k)
        visit(neighbours.target[k]);
  }
  if(components > 1)
    throw Input_error(Error_code::SEVERAL_COMPONENTS,
                      counted(components, "component", "components") + "; map them one by one");
  return index;
}

/// Throws Error unless the surface is of genus 0.
inline void check_topology(std::size_t number_of_vertices, std::size_t number_of_faces)
{
  // V - E + F = 2 - 2g, and 2E = 3F since all faces are triangles.
  const long long characteristic =
    static_cast<long long>(number_of_vertices) - static_cast<long long>(number_of_faces / 2);
  if(characteristic != 2)
    throw Input_error(Error_code::WRONG_GENUS, "genus " + std::to_string((2 - characteristic) / 2) +
                                                 "; only surfaces without handles map to the sphere");
}

/// Fills the rows of `graph`, in ascending order.
template <class Loop>
void renumber(const Loop& loop, const Neighbours& neighbours, const Host_array<int>& index,
              const Host_array<int>& position, Weighted_graph& graph)
{
  const int n = static_cast<int>(position.size());
  graph.offset.resize(n + 1);
  for(int i = 0; i < n; ++i)
    graph.offset[i + 1] = graph.offset[i] + neighbours.offset[position[i] + 1] - neighbours.offset[position[i]];
  graph.target.resize(neighbours.target.size());
  for_each_part(loop, n, [&](int begin, int end) {
    for(int i = begin; i < end; ++i) {
      const auto row = graph.target.begin() + graph.offset[i];
      const auto from = neighbours.target.begin() + neighbours.offset[position[i]];
      const auto last = std::transform(from, neighbours.target.begin() + neighbours.offset[position[i] + 1], row,
                                       [&](int p) { return index[p]; });
      std::sort(row, last);
    }
  });
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_BREADTH_FIRST_NUMBERING_H
