// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_SWEEP_GRAPH_H
#define BENCHMARK_SWEEP_GRAPH_H

#include "measure/backend.h"
#include "meshes/mesh.h"

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace benchmark {

/// The loops whose time everything else is compared with.
enum class Sweep {
  LAPLACIAN, ///< y = L x, for three vectors of doubles
  JACOBI,    ///< lines 2 to 6 of Algorithm 1
  COPY       ///< y = x, for as many bytes as a Jacobi sweep moves at least
};

/// The weighted graph of a mesh as the solvers see it.
struct Sweep_graph {
  CGAL::Spherical_parameterization::internal::Weighted_graph graph;
  std::vector<Point_3> point;
  std::vector<std::array<int, 3>> face;
  std::vector<int> position; ///< the vertices of the mesh, in the order of the graph

  Sweep_graph() = default;
  /// In the library's order. Throws std::runtime_error.
  Sweep_graph(const Mesh& mesh, Weights weights);

  /// New vertex k is old vertex order[k].
  Sweep_graph renumbered(const std::vector<int>& order) const;

  int size() const { return graph.size(); }

  /// The bytes that a Jacobi sweep moves between memory and processor at least, every array read or written once.
  double bytes_of_jacobi_sweep() const;

  /// The L2 norm of the residual of eq. (2): sqrt(sum_i |v_i - m_i / |m_i||^2), m_i the weighted mean of the
  /// neighbours.
  double residual(Sphere_map sphere) const;

  /// A function that does so many sweeps and returns when they are done.
  std::function<void(int)> sweeps(const Backend& backend, Sweep sweep) const;
};

/// Seconds for one sweep of each kind, measured in turn: medians of 11 batches of 10 ms or more.
std::vector<double> seconds_per_sweep(const std::vector<std::function<void(int)>>& sweeps);

/// A way to number vertices: entry k is the vertex of the graph, which has the library's order, that becomes vertex k.
typedef std::vector<int> (*Vertex_order)(const Sweep_graph&);

/// All that this build knows; "breadth-first" is that of the library.
extern const std::map<std::string, Vertex_order> vertex_orders;

} // namespace benchmark

#endif // BENCHMARK_SWEEP_GRAPH_H
