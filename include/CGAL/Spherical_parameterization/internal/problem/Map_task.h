// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_MAP_TASK_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_MAP_TASK_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/Result.h>
#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/predicates/spherical_triangles.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// A checked mesh as arrays, and what the caller asked for: from here on nothing depends on the type of the mesh.
struct Map_task {
  std::shared_ptr<Weighted_graph> graph;
  const Host_array<std::array<int, 3>>& faces;
  const Host_array<vec3>& points;
  const Host_array<double>& area;    ///< source area of the vertices
  const std::vector<char>& is_fixed; ///< empty: no fixed vertex
  Host_array<vec3> given;            ///< positions the caller's map held on entry, where they are needed; else empty
  std::optional<double> accuracy;
  std::optional<std::size_t> number_of_iterations;
  Monitor& monitor;
  Result& result;
  std::string missing_weights; ///< why the graph has no weights though the method could use them; else empty
  double weight_unit;          ///< what a weight of 1 in the graph is to the caller
  bool is_on_sphere = false;   ///< the map handed over is certified as it is, to the last bit

  bool has_fixed() const { return !is_fixed.empty(); }
  int size() const { return graph->size(); }
};

/// What the caller asked for, or the default of the method; not more than the backend can give.
template <class Backend>
double accuracy_on(const Backend& backend, const Map_task& task, double by_default)
{
  return (std::max)(task.accuracy.value_or(by_default), backend.best_accuracy(task.size()));
}

/// The share of the whole work that the start map takes, for the progress callback.
constexpr double start_share = 0.4;

/// Normal of a face, as long as twice its area.
inline vec3 normal(const Host_array<vec3>& points, const std::array<int, 3>& f)
{
  return outer(sub(points[f[1]], points[f[0]]), sub(points[f[2]], points[f[0]]));
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_MAP_TASK_H
