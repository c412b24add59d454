// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_IMPL_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/balanced/start_map.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/problem/settle.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Greedy colouring in vertex order: vertices of one colour have no edge between them, so that a Gauss-Seidel sweep may
/// treat them at once, and gives the same result on every backend.
CGAL_SP_INLINE std::vector<Host_array<int>> greedy_colouring(const Weighted_graph& a)
{
  std::vector<Host_array<int>> colours;
  Host_array<int> colour(a.size(), -1);
  std::vector<int> used_by;
  for(int i = 0; i < a.size(); ++i) {
    for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
      if(colour[a.target[k]] >= 0)
        used_by[colour[a.target[k]]] = i;
    const std::size_t c = std::find_if(used_by.begin(), used_by.end(), [i](int u) { return u != i; }) - used_by.begin();
    if(c == colours.size()) {
      colours.emplace_back();
      used_by.push_back(-1);
    }
    colours[c].push_back(i);
    colour[i] = static_cast<int>(c);
  }
  return colours;
}

/// The published method: minimise the spring energy subject to u_i . v_i = 1, normalize, repeat.
///
/// In coordinates of the tangent planes the constrained problem is a symmetric positive definite system with diagonal
/// blocks D_i I. Algorithm 1 is its Jacobi iteration; its block Gauss-Seidel iteration, which converges for relaxation
/// in (0, 2) by the theorem of Ostrowski and Reich, relaxes one vertex after the other by the same formula.
template <class Backend>
Solver_report descend_by_saddle_points(const Backend& backend, const Shared_graph& graph, const Saddle_point& method,
                                       double accuracy, std::size_t maximum_iterations, Monitor& monitor,
                                       typename Backend::Vectors& v)
{
  // The outer iteration contracts slowly or not at all along the boosts; ten of them without progress are a stall.
  constexpr std::size_t patience = 10;
  constexpr double far_below = 1e-2;
  constexpr std::size_t most_sweeps_per_vertex = 100;
  const typename Backend::Matrix matrix = backend.upload(graph);
  const bool is_jacobi = method.splitting == Saddle_point::Splitting::JACOBI;
  typename Backend::Colouring colours;
  if(!is_jacobi)
    colours = backend.colouring(greedy_colouring(*graph));
  const int n = static_cast<int>(v.size());
  typename Backend::Vectors u = backend.vectors(n), w = backend.vectors(n);
  backend.copy(v, u);
  Solver_report report;
  double share = 0;

  // Sweeps until the residual of the saddle-point problem has fallen by the factor `accuracy`, or far below what the
  // outer iteration aims at. Tested every check_interval sweeps, which may be many. Ordinary meshes take some 15 sweeps
  // per vertex for it; weights that differ by many powers of ten do not get there in any time.
  const auto solve_saddle_point = [&] {
    double residual = std::sqrt(backend.saddle_point_residual2(matrix, v, u));
    const double goal = (std::max)(accuracy * residual, far_below * accuracy);
    const std::size_t most = report.sweeps + most_sweeps_per_vertex * static_cast<std::size_t>(n);
    while(residual > goal && report.sweeps < most && monitor.advance(share)) {
      for(std::size_t k = 0; k < method.check_interval && report.sweeps < most && monitor.may_loop_go_on();
          ++k, ++report.sweeps)
        if(is_jacobi) {
          backend.jacobi_sweep(matrix, method.relaxation, v, u, w);
          std::swap(u, w);
        } else
          backend.gauss_seidel_sweep(matrix, colours, method.relaxation, v, u);
      const double next = std::sqrt(backend.saddle_point_residual2(matrix, v, u));
      if(!(next < residual)) // rounding has the last word
        return;
      residual = next;
    }
  };

  double first = 0, best = 0;
  std::size_t best_at = 0;
  for(;; ++report.iterations) {
    report.residual = std::sqrt(backend.barycentric_residual2(matrix, v));
    report.energy = backend.energy(matrix, v);
    monitor.log("saddle point", report.iterations, report.residual, report.energy);
    report.has_converged = report.residual <= accuracy;
    if(report.iterations == 0)
      first = report.residual;
    if(report.iterations == 0 || report.residual < best) {
      best = report.residual;
      best_at = report.iterations;
    }
    report.has_stalled = report.iterations >= best_at + patience;
    share = Monitor::share(report.residual, first, accuracy);
    if(report.has_converged || report.has_stalled || report.iterations == maximum_iterations || !monitor.advance(share))
      return report;
    solve_saddle_point();
    // Any u with u_i . v_i = 1 and lower energy will do (Proposition 1), an interrupted one, too.
    backend.normalize(matrix, u, v);
    backend.copy(v, u);
  }
}

/// Where the published method starts.
template <class Backend>
Host_array<vec3> saddle_point_start(const Backend& backend, Saddle_point::Start choice, const Problem& problem,
                                    Monitor& monitor, std::size_t& iterations)
{
  Host_array<vec3> start;
  if(choice == Saddle_point::Start::HARMONIC)
    start = start_positions(backend, problem, monitor, iterations);
  else if(choice == Saddle_point::Start::GIVEN)
    start = problem.given;
  else {
    vec3 centroid = {0, 0, 0};
    for(const vec3& p : problem.point)
      centroid = add_scaled(centroid, 1. / problem.size(), p);
    for(const vec3& p : problem.point) {
      const vec3 d = scaled_to_unit_box(sub(p, centroid));
      start.push_back(inner(d, d) > 0 ? unit(d) : make_vec3(0, 0, 1));
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
  typename Backend::Vectors v = backend.upload(std::move(start));
  solution.seconds.start_map = watch.seconds();

  const std::size_t of_start = solution.report.start_iterations;
  const double accuracy = accuracy_on(backend, problem, effort, Saddle_point::default_accuracy);
  solution.report = descend_by_saddle_points(
    backend, graph, method_, accuracy, effort.number_of_iterations.value_or(Saddle_point::default_number_of_iterations),
    monitor, v);
  solution.report.start_iterations = of_start;
  solution.seconds.solve = watch.seconds() - solution.seconds.start_map;
  const auto measure = [&](const typename Backend::Vectors& x, Solver_report& report) {
    const typename Backend::Matrix matrix = backend.upload(graph);
    report.residual = std::sqrt(backend.barycentric_residual2(matrix, x));
    report.energy = backend.energy(matrix, x);
  };
  hand_over(backend, problem, std::move(v), false, true, accuracy, measure, monitor, solution);
  return solution;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_IMPL_H
