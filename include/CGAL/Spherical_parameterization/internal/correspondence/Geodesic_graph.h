// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_GEODESIC_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_GEODESIC_GRAPH_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The edges of a surface, and the diagonals of the pairs of faces beside them, unfolded into a plane: ways along them
/// are not shorter than the geodesics, and a few per cent longer.
class Geodesic_graph {
public:
  Geodesic_graph(const Corner_table& surface, const Host_array<vec3>& point) : offset_(point.size() + 1, 0)
  {
    struct Way {
      int from, to;
      double length;
    };
    std::vector<Way> ways;
    for(int h = 0; h < surface.number_of_halfedges(); ++h) {
      const int t = surface.twin[h];
      if(t < h)
        continue;
      const int i = surface.origin(h), j = surface.target(h), left = surface.apex(h), right = surface.apex(t);
      const vec3 edge = sub(point[j], point[i]);
      const double length = std::sqrt(inner(edge, edge));
      ways.push_back({i, j, length});
      if(!(length > 0))
        continue;
      const vec3 to_left = sub(point[left], point[i]), to_right = sub(point[right], point[i]);
      const double x = inner(to_left, edge) / length, y = norm(outer(edge, to_left)) / length,
                   u = inner(to_right, edge) / length, v = norm(outer(edge, to_right)) / length;
      const double crossing = y + v > 0 ? x + (u - x) * y / (y + v) : -1;
      if(crossing >= 0 && crossing <= length)
        ways.push_back({left, right, std::hypot(u - x, y + v)});
    }
    for(const Way& way : ways) {
      ++offset_[way.from + 1];
      ++offset_[way.to + 1];
    }
    for(std::size_t i = 1; i < offset_.size(); ++i)
      offset_[i] += offset_[i - 1];
    way_.resize(offset_.back());
    std::vector<int> end(offset_.begin(), offset_.end() - 1);
    for(const Way& way : ways) {
      way_[end[way.from]++] = {way.to, way.length};
      way_[end[way.to]++] = {way.from, way.length};
    }
  }

  /// Calls f(neighbour, length of the way to it).
  template <class F>
  void for_each_way(int from, F f) const
  {
    for(int k = offset_[from]; k < offset_[from + 1]; ++k)
      f(way_[k].first, way_[k].second);
  }

  /// Of all vertices from one of them: E. Dijkstra, "A note on two problems in connexion with graphs", 1959.
  std::vector<double> distances(int from) const
  {
    std::vector<double> distance(offset_.size() - 1, std::numeric_limits<double>::infinity());
    typedef std::pair<double, int> Entry;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    distance[from] = 0;
    queue.emplace(0, from);
    while(!queue.empty()) {
      const auto [way, i] = queue.top();
      queue.pop();
      if(way > distance[i])
        continue;
      for_each_way(i, [&, so_far = way](int j, double length) {
        if(so_far + length < distance[j]) {
          distance[j] = so_far + length;
          queue.emplace(distance[j], j);
        }
      });
    }
    return distance;
  }

private:
  std::vector<int> offset_;
  std::vector<std::pair<int, double>> way_; ///< of every vertex: to which one, how far
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_GEODESIC_GRAPH_H
