// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_RUN_SADDLE_POINT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_RUN_SADDLE_POINT_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/problem/Map_task.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solver_report.h>
#include <CGAL/Spherical_parameterization/internal/mesh/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/saddle_point_solver.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/start_map.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <CGAL/assertions.h>

#include <string>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline void check_options(const Saddle_point& method)
{
  CGAL_precondition(method.relaxation > 0);
  CGAL_precondition(method.relaxation < (method.splitting == Saddle_point::Splitting::JACOBI ? 1 : 2));
  CGAL_precondition(method.check_interval > 0);
  CGAL_USE(method);
}

inline bool needs_given_start(const Saddle_point& method) { return method.start == Saddle_point::Start::GIVEN; }
inline std::string name(const Saddle_point&) { return "saddle-point"; }

/// Reads the weights, without which there is no map. Throws Failure.
template <class Set_weights>
std::string weigh(const Saddle_point&, Set_weights set_weights)
{
  set_weights();
  return {};
}

template <class Backend>
Host_array<vec3> run(const Backend& backend, const Saddle_point& method, Map_task& task, Solver_report& report)
{
  Stopwatch watch;
  Host_array<vec3> start;
  switch(method.start) {
  case Saddle_point::Start::HARMONIC: start = start_positions(backend, task); break;
  case Saddle_point::Start::GIVEN: start = task.given; break;
  case Saddle_point::Start::CENTROID: {
    vec3 centroid = {0, 0, 0};
    for(const vec3& p : task.points)
      centroid = add_scaled(centroid, 1. / task.size(), p);
    for(const vec3& p : task.points) {
      const vec3 d = scaled_to_unit_box(sub(p, centroid));
      start.push_back(inner(d, d) > 0 ? unit(d) : make_vec3(0, 0, 1));
    }
    break;
  }
  }
  if(task.has_fixed())
    for(int i = 0; i < task.size(); ++i)
      if(task.is_fixed[i])
        start[i] = task.given[i];
  task.graph->update_diagonal(task.is_fixed, backend.host_loop());
  const typename Backend::Matrix matrix = backend.upload(Shared_graph(task.graph));
  typename Backend::Vectors v = backend.upload(std::move(start));
  task.result.seconds.start_map = watch.seconds();
  Saddle_point_solver<Backend> solver(backend, matrix, *task.graph, method);
  report = solver.solve(v, accuracy_on(backend, task, Saddle_point::default_accuracy),
                        task.number_of_iterations.value_or(Saddle_point::default_number_of_iterations), task.monitor);
  report.energy *= task.weight_unit;
  task.result.seconds.solve = watch.seconds() - task.result.seconds.start_map;
  return backend.download(std::move(v));
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_RUN_SADDLE_POINT_H
