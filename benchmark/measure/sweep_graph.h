// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_SWEEP_GRAPH_H
#define BENCHMARK_SWEEP_GRAPH_H

#include "measure/backend.h"
#include "meshes/mesh.h"

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>

#include <array>
#include <functional>
#include <vector>

namespace benchmark {

/// The loops whose time everything else is compared with.
enum class Sweep {
  LAPLACIAN, ///< y = L x, for three vectors of doubles
  JACOBI,    ///< lines 2 to 6 of Algorithm 1
  COPY       ///< y = x, for as many bytes as a Jacobi sweep moves at least
};

/// The weighted graph of a mesh as the solvers see it. This class, and its source file, are all of the benchmark that
/// uses the library's internals.
class Sweep_graph {
public:
  template <class T>
  using Array = CGAL::Spherical_parameterization::internal::Host_array<T>;

  /// In the library's order. Throws std::runtime_error.
  Sweep_graph(const Mesh& mesh, Weights weights);

  /// New vertex k is old vertex order[k].
  Sweep_graph renumbered(const std::vector<int>& order) const;

  int size() const { return graph_.size(); }
  /// The vertices of the mesh, as numbers into mesh.vertices(), in the order of the graph.
  const Array<int>& position() const { return position_; }
  std::vector<int> neighbours(int vertex) const;
  std::vector<Point_3> points() const;
  const Array<std::array<int, 3>>& faces() const { return faces_; }

  /// The bytes that a sweep moves between memory and processor at least, every array read or written once.
  double bytes(Sweep sweep) const;

  /// The L2 norm of the residual of eq. (2): sqrt(sum_i |v_i - m_i / |m_i||^2), m_i the weighted mean of the
  /// neighbours. In the library's order only.
  double residual(const Mesh& mesh, Sphere_map sphere) const;

  /// A function that does so many sweeps and returns when they are done.
  std::function<void(int)> sweeps(const Backend& backend, Sweep sweep) const;

private:
  Sweep_graph() = default;

  CGAL::Spherical_parameterization::internal::Weighted_graph graph_;
  Array<CGAL::Spherical_parameterization::internal::vec3> points_;
  Array<std::array<int, 3>> faces_;
  Array<int> position_;
};

/// Seconds for one sweep of each kind, measured in turn: medians of 11 batches of 10 ms or more.
std::vector<double> seconds_per_sweep(const std::vector<std::function<void(int)>>& sweeps);

} // namespace benchmark

#endif // BENCHMARK_SWEEP_GRAPH_H
