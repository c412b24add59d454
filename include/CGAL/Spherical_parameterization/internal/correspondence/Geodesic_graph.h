// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_GEODESIC_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_GEODESIC_GRAPH_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
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
      mean_length_ += way.length / static_cast<double>(ways.size());
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

  /// Of all vertices from one of them, by E. W. Dijkstra's algorithm. In buckets as wide as the mean way, each of them
  /// a heap, which is faster than one heap: R. Dial, "Shortest path forest with topological ordering", CACM 12 (1969).
  std::vector<double> distances(int from) const
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> distance(offset_.size() - 1, infinity);
    distance[from] = 0;
    std::vector<std::vector<std::pair<double, int>>> bucket(1, {{0., from}});
    for(std::size_t b = 0; b < bucket.size(); ++b)
      while(!bucket[b].empty()) {
        std::pop_heap(bucket[b].begin(), bucket[b].end(), std::greater<>());
        const auto [way, i] = bucket[b].back();
        bucket[b].pop_back();
        if(way > distance[i]) // a shorter one was found later
          continue;
        for_each_way(i, [&, way = way](int j, double length) {
          if(way + length < distance[j]) {
            distance[j] = way + length;
            const auto its_bucket = static_cast<std::size_t>(distance[j] / mean_length_);
            bucket.resize((std::max)(bucket.size(), its_bucket + 1));
            bucket[its_bucket].emplace_back(distance[j], j);
            std::push_heap(bucket[its_bucket].begin(), bucket[its_bucket].end(), std::greater<>());
          }
        });
      }
    return distance;
  }

private:
  std::vector<int> offset_;
  std::vector<std::pair<int, double>> way_; ///< of every vertex: to which one, how far
  double mean_length_ = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_GEODESIC_GRAPH_H
