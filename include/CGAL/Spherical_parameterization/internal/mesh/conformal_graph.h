// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CONFORMAL_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CONFORMAL_GRAPH_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Intrinsic_triangulation.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The springs of the conformal map: cotangent weights of the intrinsic Delaunay triangulation of the surface, which
/// are not negative, whatever the triangles of the mesh. A. Bobenko, B. Springborn, "A discrete Laplace-Beltrami
/// operator for simplicial surfaces", Discrete & Computational Geometry 38 (2007).
///
/// Two edges between the same vertices are one spring; an edge from a vertex to itself pulls at nothing. The edges of
/// cocircular points have weight 0 and get `smallest_weight`, which keeps the graph connected.
template <class Loop>
Weighted_graph conformal_graph(const Loop& loop, const Host_array<std::array<int, 3>>& face,
                               const Host_array<vec3>& point)
{
  constexpr double smallest_weight = 1e-6;
  const int n = static_cast<int>(point.size());
  Corner_table table;
  table.face = face;
  match_halfedges(loop, face, n, table.twin);
  const Intrinsic_triangulation surface(std::move(table), point);
  const int m = surface.number_of_halfedges();

  Host_array<int> first(n + 1, 0), halfedge(m); // the halfedges from every vertex
  for(int h = 0; h < m; ++h)
    ++first[surface.origin(h) + 1];
  for(int i = 0; i < n; ++i)
    first[i + 1] += first[i];
  Host_array<int> place(first.begin(), first.end() - 1);
  for(int h = 0; h < m; ++h)
    halfedge[place[surface.origin(h)]++] = h;
  Host_array<double> weight(m);
  for_each_part(loop, m, [&](int begin, int end) {
    for(int h = begin; h < end; ++h) {
      const int t = surface.twin(h);
      weight[h] = (surface.cotangent((std::min)(h, t)) + surface.cotangent((std::max)(h, t))) / 2;
    }
  });

  Weighted_graph graph;
  graph.offset.resize(n + 1);
  graph.target.reserve(m);
  graph.weight.reserve(m);
  graph.offset[0] = 0;
  for(int i = 0; i < n; ++i) {
    const auto begin = halfedge.begin() + first[i], end = halfedge.begin() + first[i + 1];
    // by target; equal ones in an order that both ends see alike
    std::sort(begin, end, [&](int g, int h) {
      return std::make_pair(surface.target(g), (std::min)(g, surface.twin(g))) <
             std::make_pair(surface.target(h), (std::min)(h, surface.twin(h)));
    });
    for(auto it = begin; it != end; ++it) {
      const int j = surface.target(*it);
      if(j == i)
        continue;
      if(static_cast<int>(graph.target.size()) > graph.offset[i] && graph.target.back() == j)
        graph.weight.back() += weight[*it];
      else {
        graph.target.push_back(j);
        graph.weight.push_back(weight[*it]);
      }
    }
    for(int k = graph.offset[i]; k < static_cast<int>(graph.weight.size()); ++k)
      graph.weight[k] = (std::max)(graph.weight[k], smallest_weight);
    graph.offset[i + 1] = static_cast<int>(graph.target.size());
  }
  return graph;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CONFORMAL_GRAPH_H
