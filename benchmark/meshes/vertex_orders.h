// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_VERTEX_ORDERS_H
#define BENCHMARK_VERTEX_ORDERS_H

#include "measure/sweep_graph.h"

#include <functional>
#include <string>
#include <vector>

namespace benchmark {

/// A way to number vertices: entry k of what `compute` returns is the vertex of `graph`, which has the library's order,
/// that becomes vertex k.
struct Vertex_order {
  std::string name;
  std::function<std::vector<int>(const Sweep_graph& graph)> compute;
};

/// All orders that this build knows; the first one is "breadth-first", that of the library.
const std::vector<Vertex_order>& vertex_orders();

/// The candidates that this build had to leave out, and why; empty if there are none.
std::string missing_vertex_orders();

/// Throws std::runtime_error if there is none of this name.
const Vertex_order& vertex_order(const std::string& name);

} // namespace benchmark

#endif // BENCHMARK_VERTEX_ORDERS_H
