// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_RUN_BALANCED_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_RUN_BALANCED_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/Failure.h>
#include <CGAL/Spherical_parameterization/internal/problem/Map_task.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solver_report.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/balanced_solver.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/start_map.h>
#include <CGAL/Spherical_parameterization/internal/driver/verdict.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <string>
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

inline std::string name(const Balanced& method)
{
  return method.spring_exponent == 2 ? "balanced" : "balanced with exponent " + to_string(method.spring_exponent);
}

/// Reads the weights, without which there is no map. Throws Failure.
template <class Set_weights>
std::string weigh(const Balanced&, Set_weights set_weights)
{
  set_weights();
  return {};
}

/// Where a converged map has flipped faces, the accuracy is tightened by this factor as long as doubles allow it: the
/// residual is measured on the whole sphere, and a limb of size 1e-12 is right only when it is far below that.
constexpr double refinement = 1e-2;
constexpr double limit = 1e-15;

/// Solves from `start(v)`, and does what can be done where faces are flipped in the end:
/// - tightens the accuracy;
/// - starts again with short steps: on coarse meshes the balanced critical point may be a degenerate map, with faces on
///   a great circle, that a careful descent approaches from the valid side, and an eager one from both.
/// `descend(options, v)` is the descent.
template <class Backend, class Start, class Descend>
Solver_report solve_until_valid(const Backend& backend, Map_task& task, Start start, Descend descend, double accuracy,
                                std::size_t maximum_iterations, typename Backend::Vectors& v)
{
  constexpr std::size_t patience_at_the_limit = 3;
  const auto is_valid = [&] {
    const Stopwatch watch;
    const bool result = certify(backend.host_loop(), task.faces, backend.download(v)).is_valid();
    task.result.seconds.certify += watch.seconds();
    return result;
  };

  std::size_t done = 0;
  Solver_report report;
  for(double longest_factor : {1000., 1.}) {
    start(v);
    Descent_options options = {accuracy, maximum_iterations - done, 30, longest_factor, start_share, 1};
    report = descend(options, v);
    done += report.iterations;
    report.iterations = done;
    options.patience = patience_at_the_limit;
    bool valid = report.has_converged && is_valid();
    for(Solver_report refined = report; refined.has_converged && options.accuracy > limit && !valid;) {
      options.accuracy *= refinement;
      options.maximum_iterations = maximum_iterations - done;
      refined = descend(options, v);
      done += refined.iterations;
      report.iterations = done;
      report.residual = refined.residual;
      report.energy = refined.energy;
      valid = is_valid();
    }
    if(valid || done >= maximum_iterations || task.monitor.is_interrupted())
      break;
  }
  report.has_converged = report.residual <= accuracy;
  return report;
}

/// Springs of exponent p > 2, with the factors of E_p = 1/p sum w l^2 (|v_i - v_j| / l)^p that do not depend on v as
/// weights. Lengths are relative to a source of area 4 pi.
inline Weighted_graph stiffening_springs(const Map_task& task, double exponent)
{
  const double area = std::accumulate(task.area.begin(), task.area.end(), 0.);
  const double unit_length = std::sqrt(area / (4 * std::acos(-1.)));
  Weighted_graph springs = *task.graph;
  for(int i = 0; i < springs.size(); ++i)
    for(int k = springs.offset[i]; k < springs.offset[i + 1]; ++k) {
      const vec3 e = sub(task.points[i], task.points[springs.target[k]]);
      springs.weight[k] *= std::pow(std::sqrt(inner(e, e)) / unit_length, 2 - exponent);
      if(!std::isfinite(springs.weight[k]))
        throw Failure{Error_code::DEGENERATE_FACE, "an edge has no length, which spring exponents above 2 need"};
    }
  return springs;
}

/// The quadratic springs that pull like `springs` at v, with the energy densities on the diagonal: the preconditioner.
inline Weighted_graph springs_at(const Weighted_graph& springs, double exponent, const Host_array<vec3>& v,
                                 const std::vector<char>& is_fixed)
{
  Weighted_graph result = springs;
  result.excess.resize(springs.size());
  for(int i = 0; i < springs.size(); ++i) {
    result.excess[i] = spring_density(i, springs.view(), exponent, v.data());
    for(int k = springs.offset[i]; k < springs.offset[i + 1]; ++k) {
      const vec3 e = sub(v[i], v[springs.target[k]]);
      result.weight[k] = spring_weight(springs.weight[k], inner(e, e), exponent);
    }
  }
  result.update_diagonal(is_fixed);
  return result;
}

/// Exponents above 2: the springs stiffen as they are stretched, and the map cannot slip off along a boost any more
/// (above the dimension 2 maps are held continuous by their energy). Nothing is balanced. The preconditioner is set up
/// anew whenever the springs have changed much. Where faces are flipped in the end, the accuracy is tightened.
template <class Backend>
Solver_report solve_stiffening(const Backend& backend, const Map_task& task, double exponent, double accuracy,
                               std::size_t maximum_iterations, typename Backend::Vectors& v)
{
  // Far from the solution the springs change by orders of magnitude in a step; near it they are constant.
  const auto iterations_per_hierarchy = [](double residual) -> std::size_t {
    return residual > 1e-2 ? 1 : residual > 1e-5 ? 4 : 12;
  };
  const Gauge gauge = task.has_fixed() ? Gauge::FIXED : Gauge::ROTATED;
  const auto springs = std::make_shared<Weighted_graph>(stiffening_springs(task, exponent));
  typename Backend::Scalars mass = backend.scalars(task.size());
  Solver_report report;
  double goal = accuracy;
  for(std::size_t done = 0, made = 1;; done += made) {
    const Host_array<vec3>& position = backend.download(v); // all set-up is the host's
    const auto current = std::make_shared<Weighted_graph>(springs_at(*springs, exponent, position, task.is_fixed));
    Multigrid<Backend> multigrid(backend, current);
    report.residual = std::sqrt(backend.barycentric_residual2(multigrid.matrix(0), v));
    report.iterations = done;
    if(report.has_converged) {
      const bool is_accurate = report.residual <= accuracy;
      if(goal < limit || (is_accurate && certify(backend.host_loop(), task.faces, position).is_valid()))
        break;
      goal *= is_accurate ? refinement : 0.1;
    }
    if(made == 0 || done >= maximum_iterations || task.monitor.is_interrupted())
      break;
    springs->inverse_diagonal = current->inverse_diagonal;
    const typename Backend::Matrix matrix = backend.upload(Shared_graph(springs));
    backend.spring_masses(backend.upload(Shared_graph(task.graph)), v, mass);
    Balanced_solver<Backend> solver(backend, matrix, multigrid, 0, exponent, gauge, mass);
    const std::size_t round = (std::min)(iterations_per_hierarchy(report.residual), maximum_iterations - done);
    report = solver.solve({goal, round, 30, 1000, start_share, 1}, task.monitor, v);
    made = report.iterations;
  }
  report.has_converged = report.residual <= accuracy;
  return report;
}

/// With fixed vertices: nothing is balanced, since nothing is free.
template <class Backend>
Solver_report solve_fixed(const Backend& backend, Map_task& task, double accuracy, std::size_t maximum_iterations,
                          typename Backend::Vectors& v)
{
  const Stopwatch watch;
  const Host_array<vec3> positions = start_positions(backend, task);
  task.graph->update_diagonal(task.is_fixed, backend.host_loop());
  Multigrid<Backend> multigrid(backend, task.graph);
  typename Backend::Scalars mass = backend.scalars(task.size());
  task.result.seconds.start_map = watch.seconds();

  const auto start = [&](typename Backend::Vectors& x) {
    x = backend.upload(positions);
    backend.spring_masses(multigrid.matrix(0), x, mass);
  };
  const auto descend = [&](const Descent_options& options, typename Backend::Vectors& x) {
    Balanced_solver<Backend> solver(backend, multigrid.matrix(0), multigrid, 0, 2, Gauge::FIXED, mass);
    return solver.solve(options, task.monitor, x);
  };
  // The residual of eq. (2) is that of the descent times D_i / |sum w_ij v_j|: 1 on fine meshes, up to 3 on coarse
  // ones.
  Solver_report report = solve_until_valid(backend, task, start, descend, accuracy / 3, maximum_iterations, v);
  report.residual = std::sqrt(backend.barycentric_residual2(multigrid.matrix(0), v));
  report.has_converged = report.residual <= accuracy;
  return report;
}

/// Without fixed vertices, exponent 2: the balanced critical point.
///
/// The masses of the balance are the spring densities of a reference map, the solution itself to 1e-4, with the
/// centroid of the source area at the centre. (On a conformal map the density of energy is that of area.) The reference
/// is taken early and renewed, so that it is a small change each time, and the descent goes on as if nothing had
/// happened.
template <class Backend>
Solver_report solve_balanced(const Backend& backend, Map_task& task, double accuracy, std::size_t maximum_iterations,
                             typename Backend::Vectors& v)
{
  const Stopwatch watch;
  task.graph->update_diagonal({}, backend.host_loop());
  Multigrid<Backend> multigrid(backend, task.graph);
  const typename Backend::Scalars area = backend.upload(task.area);
  typename Backend::Scalars mass = backend.scalars(task.size());
  const auto refer_to = [&](typename Backend::Vectors& x) {
    centre(backend, area, x, multigrid.scratch(0));
    backend.spring_masses(multigrid.matrix(0), x, mass);
  };
  Balanced_solver<Backend> solver(backend, multigrid.matrix(0), multigrid, 0, 2, Gauge::BALANCED, mass);

  std::vector<double> references;
  const auto start = [&](typename Backend::Vectors& x) {
    const Stopwatch start_watch;
    x = start_map(backend, multigrid, task);
    refer_to(x);
    references = {1e-2, 1e-4};
    task.result.seconds.start_map = start_watch.seconds();
  };
  const auto descend = [&](const Descent_options& options, typename Backend::Vectors& x) {
    return solver.solve(options, task.monitor, std::exchange(references, {}), refer_to, x);
  };
  const double set_up = watch.seconds();
  Solver_report report = solve_until_valid(backend, task, start, descend, accuracy, maximum_iterations, v);
  task.result.seconds.start_map += set_up;
  return report;
}

template <class Backend>
Host_array<vec3> run(const Backend& backend, const Balanced& method, Map_task& task, Solver_report& report)
{
  const double accuracy = accuracy_on(backend, task, Balanced::default_accuracy);
  const std::size_t maximum_iterations = task.number_of_iterations.value_or(Balanced::default_number_of_iterations);
  const Stopwatch watch;
  typename Backend::Vectors v;
  if(method.spring_exponent != 2) {
    v = backend.upload(start_positions(backend, task));
    task.result.seconds.start_map = watch.seconds();
    report = solve_stiffening(backend, task, method.spring_exponent, accuracy, maximum_iterations, v);
  } else if(task.has_fixed())
    report = solve_fixed(backend, task, accuracy, maximum_iterations, v);
  else
    report = solve_balanced(backend, task, accuracy, maximum_iterations, v);
  report.energy *= task.weight_unit;
  task.result.seconds.solve = watch.seconds() - task.result.seconds.start_map - task.result.seconds.certify;
  return backend.download(std::move(v));
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_RUN_BALANCED_H
