// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_RUN_ISOMETRIC_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_RUN_ISOMETRIC_H

#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Coarse_to_fine_map.h>
#include <CGAL/Spherical_parameterization/internal/base/Failure.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/problem/Map_task.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solver_report.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <CGAL/assertions.h>

#include <string>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline void check_options(const Isometric& method)
{
  CGAL_precondition(method.area_exponent >= 0);
  CGAL_USE(method);
}

inline bool needs_given_start(const Isometric&) { return false; }
inline std::string name(const Isometric&) { return "isometric"; }

/// There are none.
template <class Set_weights>
std::string weigh(const Isometric&, Set_weights)
{
  return {};
}

/// Throws the Failure if there is no map whose edges are geodesic: these are determined by their ends.
inline void check_simplicial(const Weighted_graph& graph)
{
  const char* const problem = "there is no map with geodesic edges: ";
  if(graph.size() < 4)
    throw Failure{Error_code::NOT_BIJECTIVE, std::string(problem) + "the mesh has fewer than four vertices"};
  for(int i = 0; i < graph.size(); ++i)
    for(int k = graph.offset[i]; k < graph.offset[i + 1]; ++k)
      if(graph.target[k] == i || (k > graph.offset[i] && graph.target[k] == graph.target[k - 1]))
        throw Failure{Error_code::NOT_BIJECTIVE, std::string(problem) + "two edges of the mesh have the same ends"};
}

template <class Backend>
Host_array<vec3> run(const Backend& backend, const Isometric& method, Map_task& task, Solver_report& report)
{
  if(task.has_fixed())
    throw Failure{Error_code::BAD_CONSTRAINTS, "the isometric method cannot keep vertices fixed"};
  check_simplicial(*task.graph);
  const Stopwatch watch;
  Coarse_to_fine_map<typename Backend::Host_loop> map(backend.host_loop(), method, task);
  map.run(report);
  task.is_on_sphere = true;
  task.result.seconds.solve = watch.seconds();
  return map.positions();
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_RUN_ISOMETRIC_H
