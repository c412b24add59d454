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
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// The springs of the conformal map: cotangent weights of the intrinsic Delaunay triangulation of the surface, which
/// are not negative, whatever the triangles of the mesh. A. Bobenko, B. Springborn, "A discrete Laplace-Beltrami
/// operator for simplicial surfaces", Discrete & Computational Geometry 38 (2007).
///
/// Two edges between the same vertices are one spring of their mean length; an edge from a vertex to itself pulls at
/// nothing. The edges of cocircular points have weight 0 and get `smallest_weight`, which keeps the graph connected.
/// \param length  gets the length of every spring, inside the surface
inline Weighted_graph conformal_graph(const Host_loop& loop, Corner_table table, const Host_array<vec3>& point,
                                      Host_array<double>& length)
{
  constexpr double smallest_weight = 1e-6;
  const int n = static_cast<int>(point.size());
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
  for_each_index(loop, m, [&](int h) {
    const int t = surface.twin[h];
    const double cotangents = surface.cotangent((std::min)(h, t)) + surface.cotangent((std::max)(h, t));
    weight[h] = (std::max)(smallest_weight, cotangents / 2); // also where all points are one: 0/0
  });

  // Rows in order of their targets; equal ones in an order that both ends see alike.
  Weighted_graph graph;
  graph.offset.assign(n + 1, 0);
  const auto is_new = [&](int i, int k) { // spring, or part of the one before
    const int j = surface.target(halfedge[k]);
    return j != i && (k == first[i] || surface.target(halfedge[k - 1]) != j);
  };
  for_each_index(loop, n, [&](int i) {
    std::sort(halfedge.begin() + first[i], halfedge.begin() + first[i + 1], [&](int g, int h) {
      return std::make_pair(surface.target(g), (std::min)(g, surface.twin[g])) <
             std::make_pair(surface.target(h), (std::min)(h, surface.twin[h]));
    });
    for(int k = first[i]; k < first[i + 1]; ++k)
      graph.offset[i + 1] += is_new(i, k);
  });
  for(int i = 0; i < n; ++i)
    graph.offset[i + 1] += graph.offset[i];
  graph.target.resize(graph.offset[n]);
  graph.weight.resize(graph.offset[n]);
  length.resize(graph.offset[n]);
  for_each_index(loop, n, [&](int i) {
    int last = graph.offset[i] - 1;
    for(int k = first[i]; k < first[i + 1]; ++k) {
      const int h = halfedge[k];
      if(surface.target(h) == i)
        continue;
      if(is_new(i, k)) {
        graph.target[++last] = surface.target(h);
        graph.weight[last] = weight[h];
        length[last] = surface.length(h);
      } else {
        const double sum = graph.weight[last] + weight[h];
        length[last] = (graph.weight[last] * length[last] + weight[h] * surface.length(h)) / sum;
        graph.weight[last] = sum;
      }
    }
  });
  return graph;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CONFORMAL_GRAPH_H
