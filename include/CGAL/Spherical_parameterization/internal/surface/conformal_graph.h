// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CONFORMAL_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CONFORMAL_GRAPH_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Intrinsic_triangulation.h>
#include <CGAL/Spherical_parameterization/internal/surface/Spring_lengths.h>
#include <CGAL/Spherical_parameterization/internal/surface/fans.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The springs of the conformal map: cotangent weights of the intrinsic Delaunay triangulation of the surface, which
/// are not negative, whatever the triangles of the mesh. A. Bobenko, B. Springborn, "A discrete Laplace-Beltrami
/// operator for simplicial surfaces", Discrete & Computational Geometry 38 (2007).
///
/// Two edges between the same vertices are one spring of their mean length; an edge from a vertex to itself pulls at
/// nothing. The edges of cocircular points have weight 0 and get `smallest_weight`, which keeps the graph connected.
/// \param loop     a Host_loop or a Watched_loop
/// \param lengths  gets the lengths of the springs
template <class Loop>
Weighted_graph conformal_graph(const Loop& loop, Corner_table table, const Host_array<vec3>& point,
                               Spring_lengths& lengths)
{
  constexpr double smallest_weight = 1e-6;
  const int n = static_cast<int>(point.size());
  const Intrinsic_triangulation surface(std::move(table), point, loop);
  const int m = surface.number_of_halfedges();
  Host_array<double> weight(m); // of the edge of a halfedge
  for_each_index(loop, m, [&](int h) {
    constexpr int ahead = 32;
    surface.prefetch_cotangent(surface.twin[h < m - ahead ? h + ahead : h]);
    const int t = surface.twin[h];
    const double cotangents = surface.cotangent((std::min)(h, t)) + surface.cotangent((std::max)(h, t));
    weight[h] = (std::max)(smallest_weight, cotangents / 2); // also where all points are one: 0/0
  });

  // Every halfedge is an entry of the row of its origin. Rows are in order of their targets; equal ones in an order
  // that both ends see alike.
  Weighted_graph graph;
  graph.offset.resize(n + 1);
  graph.offset[n] = m;
  graph.target.resize(m);
  graph.weight.resize(m);
  Host_array<int> springs(n); // in a row, whose other entries are of no use
  struct Other {              // a spring that is no edge
    int row, place;
    double length;
  };
  struct Part {
    std::vector<std::pair<int, int>> row; // targets, halfedges
    std::vector<Other> others;
  };
  const double slack = surface.slack();
  const auto add_row = [&](Part& part, const Fan& fan) {
    auto& row = part.row;
    row.clear();
    for(int h : fan)
      row.emplace_back(surface.target(h), h);
    std::sort(row.begin(), row.end(), [&](const auto& g, const auto& h) {
      return g.first != h.first
               ? g.first < h.first
               : (std::min)(g.second, surface.twin[g.second]) < (std::min)(h.second, surface.twin[h.second]);
    });
    graph.offset[fan.vertex] = fan.first;
    int k = fan.first;
    for(auto it = row.begin(); it != row.end();) {
      const int j = it->first;
      const bool is_edge = !surface.may_be_new(it->second) && (it + 1 == row.end() || it[1].first != j);
      double sum = weight[it->second], length = is_edge ? 0 : surface.length(it->second);
      for(++it; it != row.end() && it->first == j; ++it) {
        const double its_weight = weight[it->second], new_sum = sum + its_weight;
        length = (sum * length + its_weight * surface.length(it->second)) / new_sum;
        sum = new_sum;
      }
      if(j == fan.vertex)
        continue;
      graph.target[k] = j;
      graph.weight[k] = sum;
      if(!is_edge && fan.vertex < j && length != Spring_lengths::of_edge(point[fan.vertex], point[j], slack))
        part.others.push_back({fan.vertex, k - fan.first, length});
      ++k;
    }
    springs[fan.vertex] = k - fan.first;
  };
  const auto parts = parts_of_fans<Part>(loop, surface.face, n, add_row, [&](int h) {
    __builtin_prefetch(&surface.face[h / 3]);
    __builtin_prefetch(&weight[h]);
    surface.prefetch_may_be_new(h);
  });

  // Rows move together where some are shorter.
  int end = 0;
  for(int i = 0; i < n; ++i) {
    const int begin = std::exchange(graph.offset[i], end);
    if(begin != end)
      for(int k = 0; k < springs[i]; ++k) {
        graph.target[end + k] = graph.target[begin + k];
        graph.weight[end + k] = graph.weight[begin + k];
      }
    end += springs[i];
  }
  graph.offset[n] = end;
  graph.target.resize(end);
  graph.weight.resize(end);
  lengths.slack = slack;
  std::size_t others = 0;
  for(const Part& part : parts)
    others += part.others.size();
  lengths.spring.reserve(others);
  lengths.length.reserve(others);
  for(const Part& part : parts)
    for(const Other& other : part.others) {
      lengths.spring.push_back(graph.offset[other.row] + other.place);
      lengths.length.push_back(other.length);
    }
  return graph;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CONFORMAL_GRAPH_H
