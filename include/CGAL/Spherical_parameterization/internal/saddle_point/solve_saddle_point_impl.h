// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_IMPL_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/start_map.h>
#include <CGAL/Spherical_parameterization/internal/mesh/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/saddle_point_solver.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point.h>

#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// Where the published method starts.
template <class Backend>
Host_array<vec3> saddle_point_start(const Backend& backend, Saddle_point::Start choice, const Problem& problem,
                                    Monitor& monitor, std::size_t& iterations)
{
  Host_array<vec3> start;
  switch(choice) {
  case Saddle_point::Start::HARMONIC: start = start_positions(backend, problem, monitor, iterations); break;
  case Saddle_point::Start::GIVEN: start = problem.given; break;
  case Saddle_point::Start::CENTROID: {
    vec3 centroid = {0, 0, 0};
    for(const vec3& p : problem.point)
      centroid = add_scaled(centroid, 1. / problem.size(), p);
    for(const vec3& p : problem.point) {
      const vec3 d = scaled_to_unit_box(sub(p, centroid));
      start.push_back(inner(d, d) > 0 ? unit(d) : make_vec3(0, 0, 1));
    }
    break;
  }
  }
  if(problem.has_fixed())
    for(int i = 0; i < problem.size(); ++i)
      if(problem.is_fixed[i])
        start[i] = problem.given[i];
  return start;
}

template <class Backend>
Solution Method_solver<Saddle_point>::solve(const Backend& backend, const Problem& problem, const Effort& effort,
                                            Monitor& monitor) const
{
  const Stopwatch watch;
  Solution solution;
  Host_array<vec3> start =
    saddle_point_start(backend, method_.start, problem, monitor, solution.report.start_iterations);
  const Shared_graph graph = with_fixed_vertices(backend.host_loop(), problem);
  const typename Backend::Matrix matrix = backend.upload(graph);
  typename Backend::Vectors v = backend.upload(std::move(start));
  solution.seconds.start_map = watch.seconds();

  Saddle_point_solver<Backend> solver(backend, matrix, *graph, method_);
  const std::size_t of_start = solution.report.start_iterations;
  solution.report =
    solver.solve(v, accuracy_on(backend, problem, effort, Saddle_point::default_accuracy),
                 effort.number_of_iterations.value_or(Saddle_point::default_number_of_iterations), monitor);
  solution.report.start_iterations = of_start;
  solution.report.energy *= problem.weight_unit;
  solution.seconds.solve = watch.seconds() - solution.seconds.start_map;
  finish(backend, problem, std::move(v), false, solution);
  return solution;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_IMPL_H
