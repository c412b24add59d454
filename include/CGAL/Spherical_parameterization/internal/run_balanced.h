// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_BALANCED_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_BALANCED_H

#include <CGAL/Spherical_parameterization/internal/Failure.h>
#include <CGAL/Spherical_parameterization/internal/Map_task.h>
#include <CGAL/Spherical_parameterization/internal/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/Solver_report.h>
#include <CGAL/Spherical_parameterization/internal/balanced_solver.h>
#include <CGAL/Spherical_parameterization/internal/start_map.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline void check_options(const Balanced& method)
{
  CGAL_precondition(method.spring_exponent >= 2);
  CGAL_USE(method);
}

inline bool needs_given_start(const Balanced&) { return false; }

/// Where a converged map has flipped faces, the accuracy is tightened by this factor as long as doubles allow it: the
/// residual is measured on the whole sphere, and a limb of size 1e-12 is right only when it is far below that.
constexpr double refinement = 1e-2;
constexpr double limit = 1e-15;

/// Solves from `start`, and does what can be done where faces are flipped in the end:
/// - tightens the accuracy;
/// - starts again with short steps: on coarse meshes the balanced critical point may be a degenerate map, with faces on a
///   great circle, that a careful descent approaches from the valid side, and an eager one from both.
template <class Backend>
Solver_report solve_until_valid(const Backend& backend, Balanced_solver<Backend>& solver, Map_task& task,
                                const std::vector<vec3>& start, double accuracy, std::size_t maximum_iterations,
                                typename Backend::Vectors& v)
{
  constexpr std::size_t patience_at_the_limit = 3;
  const auto is_valid = [&] { return certify(task.faces, backend.download(v)).is_valid(); };

  std::size_t done = 0;
  Solver_report report;
  for(double longest_factor : {1000., 1.}) {
    v = backend.upload(start);
    Descent_options options = {accuracy, maximum_iterations - done, 30, longest_factor};
    report = solver.solve(options, task.monitor, start_share, v);
    done += report.iterations;
    report.iterations = done;
    options.patience = patience_at_the_limit;
    for(Solver_report refined = report; refined.has_converged && options.accuracy > limit && !is_valid();) {
      options.accuracy *= refinement;
      options.maximum_iterations = maximum_iterations - done;
      refined = solver.solve(options, task.monitor, start_share, v);
      done += refined.iterations;
      report.iterations = done;
      report.residual = refined.residual;
      report.energy = refined.energy;
    }
    if(done >= maximum_iterations || task.monitor.is_interrupted() || is_valid())
      break;
  }
  report.has_converged = report.residual <= accuracy;
  return report;
}

/// Exponents above 2: the springs stiffen as they are stretched, and the map cannot slip off along a boost any more
/// (above the dimension 2 maps are held continuous by their energy). Nothing is balanced; the preconditioner is
/// L(w(v)) + diag(density), set up anew whenever the weights have changed much.
template <class Backend>
std::vector<vec3> run_stiffening(const Backend& backend, double exponent, double accuracy,
                                 std::size_t maximum_iterations, Map_task& task, Solver_report& report)
{
  constexpr std::size_t iterations_per_hierarchy = 12;
  const int n = task.size();
  Stopwatch watch;
  std::vector<vec3> start = harmonic_start(backend, task, start_share);
  task.result.seconds.start_map = watch.seconds();

  const double area = std::accumulate(task.area.begin(), task.area.end(), 0.);
  const double unit_length = std::sqrt(area / (4 * std::acos(-1.)));
  // E_p = 1/p sum w l^2 (|v_i - v_j| / l)^p: the factors that do not depend on v go into the weights.
  for(int i = 0; i < n; ++i)
    for(int k = task.graph.offset[i]; k < task.graph.offset[i + 1]; ++k) {
      const vec3 e = sub(task.points[i], task.points[task.graph.target[k]]);
      const double length = std::sqrt(inner(e, e)) / unit_length;
      task.graph.weight[k] *= std::pow(length, 2 - exponent);
      if(!std::isfinite(task.graph.weight[k]))
        throw Failure{Error_code::DEGENERATE_FACE, "an edge has no length, which spring exponents above 2 need"};
    }

  Weighted_graph current = task.graph;
  current.excess.resize(n);
  const typename Backend::Scalars mass = backend.upload(spherical_masses(task, start));
  typename Backend::Vectors v = backend.upload(std::move(start));
  double residual = 0;
  double goal = accuracy;
  for(std::size_t done = 0;;) {
    // The weights at v, on the host as all set-up.
    const std::vector<vec3> position = backend.download(v);
    const graph_view springs = task.graph.view();
    for(int i = 0; i < n; ++i) {
      current.excess[i] = spring_density(i, springs, exponent, position.data());
      for(int k = current.offset[i]; k < current.offset[i + 1]; ++k) {
        const vec3 e = sub(position[i], position[current.target[k]]);
        current.weight[k] = spring_weight(task.graph.weight[k], inner(e, e), exponent);
      }
    }
    current.update_diagonal(task.is_fixed);
    task.graph.inverse_diagonal = current.inverse_diagonal;
    const typename Backend::Matrix preconditioner = backend.upload(current);
    residual = std::sqrt(backend.barycentric_residual2(preconditioner, v));
    if(done > 0 && (report.has_stalled || done >= maximum_iterations || task.monitor.is_interrupted()))
      break;
    if(report.has_converged) {
      if(goal < limit || certify(task.faces, position).is_valid())
        break;
      goal *= refinement;
    }
    const typename Backend::Matrix matrix = backend.upload(task.graph);
    Multigrid<Backend> multigrid(backend, current, preconditioner);
    Balanced_solver<Backend> solver(backend, matrix, multigrid, exponent, false, mass);
    report = solver.solve({goal, (std::min)(iterations_per_hierarchy, maximum_iterations - done)}, task.monitor,
                          start_share, v);
    done += (std::max)(std::size_t(1), report.iterations);
    report.iterations = done;
  }
  report.residual = residual;
  report.has_converged = residual <= accuracy;
  task.result.seconds.solve = watch.seconds() - task.result.seconds.start_map;
  return backend.download(v);
}

template <class Backend>
std::vector<vec3> run(const Backend& backend, const Balanced& method, Map_task& task, Solver_report& report)
{
  const double accuracy = task.accuracy.value_or(1e-9);
  const std::size_t maximum_iterations = task.number_of_iterations.value_or(500);
  Stopwatch watch;

  if(method.spring_exponent != 2)
    return run_stiffening(backend, method.spring_exponent, accuracy, maximum_iterations, task, report);

  if(task.has_fixed()) {
    std::vector<vec3> start = harmonic_start(backend, task, start_share);
    const typename Backend::Scalars mass = backend.upload(spherical_masses(task, start));
    typename Backend::Vectors v;
    task.graph.update_diagonal(task.is_fixed);
    const typename Backend::Matrix matrix = backend.upload(task.graph);
    Multigrid<Backend> multigrid(backend, task.graph, matrix);
    task.result.seconds.start_map = watch.seconds();
    Balanced_solver<Backend> solver(backend, matrix, multigrid, 2, false, mass);
    report = solve_until_valid(backend, solver, task, start, accuracy, maximum_iterations, v);
    report.residual = std::sqrt(backend.barycentric_residual2(matrix, v));
    task.result.seconds.solve = watch.seconds() - task.result.seconds.start_map;
    return backend.download(v);
  }

  task.graph.update_diagonal({});
  const typename Backend::Matrix matrix = backend.upload(task.graph);
  Multigrid<Backend> multigrid(backend, task.graph, matrix);
  std::vector<vec3> start = harmonic_start(backend, matrix, multigrid, task, start_share);
  const typename Backend::Scalars mass = backend.upload(spherical_masses(task, start));
  typename Backend::Vectors v;
  task.result.seconds.start_map = watch.seconds();
  Balanced_solver<Backend> solver(backend, matrix, multigrid, 2, true, mass);
  report = solve_until_valid(backend, solver, task, start, accuracy, maximum_iterations, v);
  task.result.seconds.solve = watch.seconds() - task.result.seconds.start_map;
  return backend.download(v);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RUN_BALANCED_H
