// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_IMPL_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/balanced/solve_balanced.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Float_cycle.h>
#include <CGAL/Spherical_parameterization/internal/problem/settle.h>
#include <CGAL/Spherical_parameterization/internal/balanced/balanced_solver.h>
#include <CGAL/Spherical_parameterization/internal/balanced/start_map.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Where a converged map has flipped faces, the accuracy is tightened by this factor as long as doubles allow it: the
/// residual is measured on the whole sphere, and a limb of size 1e-12 is right only when it is far below that.
constexpr double accuracy_refinement = 1e-2;
constexpr double finest_accuracy = 1e-15;

/// Solves from `start(v)`, and does what can be done where faces are flipped in the end:
/// - mends them, if the map is conformal, and they are few or get no fewer, and other bad faces with them;
/// - tightens the accuracy;
/// - starts again with short steps: on coarse meshes the balanced critical point may be a degenerate map, with faces on
///   a great circle, that a careful descent approaches from the valid side, and an eager one from both.
/// `descend(options, v)` is the descent. Nothing is done where many are flipped and `rejects(x)`, if it is there, is
/// true. Fills in report, certificate and seconds of `solution`; returns whether the certificate is that of v.
template <class Backend, class Start, class Descend, class Rejection>
bool solve_until_valid(const Backend& backend, const Problem& problem, Start start, Descend descend,
                       const Rejection& rejects, double accuracy, std::size_t maximum_iterations, Monitor& monitor,
                       typename Backend::Vectors& v, Solution& solution)
{
  constexpr std::size_t patience_at_the_limit = 3;
  // More than few flipped faces are of limbs that are not right yet. These are not mended as long as their number
  // falls. Bad faces are mended where they are large beside the accuracy, or that is as fine as is of use.
  constexpr double few = 1e-3, least_fall = 0.5, no_fall = 0.02; // of the faces; of their number
  constexpr double large = 100, finest_of_use = 1e-12;
  constexpr double many = 0.1; // of the faces; fewer can still be mended
  const bool is_rough = backend.best_accuracy(problem.size()) > 0;
  double flipped_before = 0;
  // Rejected, or fixed vertices contradict each other: what they flip does not depend on the accuracy.
  bool is_hopeless = false;
  bool is_stuck = false; // nor does what noise flips all over the surface: another start may help
  const auto settle_at = [&](double current, bool is_last) {
    const auto resolution = [&](const Certificate& certificate, const Host_array<vec3>& x) {
      const double flipped = static_cast<double>(certificate.flipped_faces);
      const double before = std::exchange(flipped_before, flipped);
      const bool are_few = flipped < few * static_cast<double>(problem.face.size());
      const bool are_no_fewer = before > 0 && flipped > least_fall * before;
      const bool is_rejected = rejects && flipped > many * static_cast<double>(problem.face.size()) && rejects(x);
      is_hopeless = is_rejected || (problem.has_fixed() && are_no_fewer && !are_few);
      is_stuck = before > 0 && flipped > (1 - no_fall) * before;
      if(is_rejected)
        return std::numeric_limits<double>::infinity();
      if(is_last)
        return 0.;
      if(!are_few && !are_no_fewer)
        return std::numeric_limits<double>::infinity();
      return current > finest_of_use && !is_rough ? large * current : 0.;
    };
    return settle(backend, problem, v, true, resolution, monitor, solution);
  };

  struct Certified {
    typename Backend::Vectors v;
    Solver_report report;
    Certificate certificate;
  };
  std::optional<Certified> best; // of those that were left
  const auto badness = [](const Certificate& c) { return std::pair(c.degree != 1, c.flipped_faces); };
  const auto leave = [&](typename Backend::Vectors&& x, const Solver_report& its_report, const Certificate& its) {
    if(!best || badness(its) < badness(best->certificate))
      best = Certified{std::move(x), its_report, its};
  };

  std::size_t done = 0;
  Solver_report& report = solution.report;
  bool is_certified = false;
  Settled settled = Settled::NOT_YET;
  for(double longest_factor : {1000., 1.}) {
    start(v);
    Descent_options options = {accuracy, maximum_iterations - done};
    options.longest_factor = longest_factor;
    const std::size_t of_start = report.start_iterations;
    report = descend(options, v);
    report.start_iterations = of_start;
    done += report.iterations;
    report.iterations = done;
    options.patience = patience_at_the_limit;
    is_certified = report.has_converged;
    flipped_before = 0;
    settled = is_certified ? settle_at(options.accuracy, options.accuracy <= finest_accuracy) : Settled::NOT_YET;
    for(Solver_report refined = report; refined.has_converged && options.accuracy > finest_accuracy &&
                                        settled != Settled::YES && !is_hopeless &&
                                        !(is_stuck && settled == Settled::BEYOND_MENDING);) {
      options.accuracy *= accuracy_refinement;
      options.maximum_iterations = maximum_iterations - done;
      typename Backend::Vectors before = backend.vectors(problem.size());
      backend.copy(v, before);
      const Solver_report report_before = report;
      const Certificate certificate_before = solution.certificate;
      refined = descend(options, v);
      done += refined.iterations;
      report.iterations = done;
      if(refined.residual <= report.residual) {
        report.residual = refined.residual;
        report.energy = refined.energy;
      } else { // it has ended above where it began
        std::swap(v, before);
        flipped_before = 0; // the same faces will be flipped: that says nothing
      }
      settled = settle_at(options.accuracy, !refined.has_converged || options.accuracy <= finest_accuracy);
      if(badness(certificate_before) < badness(solution.certificate))
        leave(std::move(before), report_before, certificate_before);
    }
    if(settled == Settled::YES || is_hopeless || done >= maximum_iterations || monitor.is_interrupted())
      break;
    if(is_certified && longest_factor > 1)
      leave(std::move(v), report, solution.certificate);
  }
  if(!is_certified && best)
    solution.certificate = certify_as_stored(backend.host_loop(), problem, in_doubles(backend, problem, v));
  if(settled != Settled::YES && best && badness(best->certificate) < badness(solution.certificate)) {
    std::swap(v, best->v);
    report.residual = best->report.residual;
    report.energy = best->report.energy;
    report.has_stalled = best->report.has_stalled;
    is_certified = false; // to be mended whatever its faces are
  }
  report.has_converged = report.residual <= accuracy;
  return is_certified;
}

/// Springs of exponent p > 2, with the factors of E_p = 1/p sum w l^2 (|v_i - v_j| / l)^p that do not depend on v as
/// weights. Lengths are relative to a source of area 4 pi.
CGAL_SP_INLINE Weighted_graph stiffening_springs(const Host_loop& loop, const Problem& problem, double exponent)
{
  const Host_array<double>& of_vertices = problem.vertex_area(loop);
  const double area = std::accumulate(of_vertices.begin(), of_vertices.end(), 0.);
  const double unit_length = std::sqrt(area / (4 * pi));
  Weighted_graph springs = *problem.graph;
  const Host_array<double> lengths =
    (problem.is_intrinsic() ? *problem.spring_lengths : Spring_lengths()).of_all(springs, problem.point);
  for(int i = 0; i < springs.size(); ++i)
    for(int k = springs.offset[i]; k < springs.offset[i + 1]; ++k) {
      const double length = lengths[k] / unit_length;
      if(!(length > 0 && std::isfinite(length)))
        throw Input_error(Error_code::DEGENERATE_FACE, "an edge has no length, which spring exponents above 2 need");
      springs.weight[k] *= power(length, 2 - exponent);
      if(!(springs.weight[k] > 0 && std::isfinite(springs.weight[k])))
        throw Input_error(Error_code::BAD_WEIGHT, "springs of the exponent " + to_string(exponent) +
                                                    " exceed the range of doubles; choose a smaller one");
    }
  return springs;
}

/// The quadratic springs that pull like `springs` at v, with the energy densities on the diagonal: the preconditioner.
template <class Loop>
Weighted_graph springs_at(const Loop& loop, const Weighted_graph& springs, double exponent, const Host_array<vec3>& v,
                          const std::vector<char>& is_fixed)
{
  Weighted_graph result = springs;
  result.excess.resize(springs.size());
  for_each_index(loop, springs.size(), [&](int i) {
    result.excess[i] = spring_density(i, springs.view(), exponent, v.data());
    for(int k = springs.offset[i]; k < springs.offset[i + 1]; ++k) {
      const vec3 e = sub(v[i], v[springs.target[k]]);
      result.weight[k] = spring_weight(springs.weight[k], inner(e, e), exponent);
    }
  });
  result.update_diagonal(is_fixed);
  return result;
}

/// The energy of a map, with exponents above 2. \param current  the springs at this map
template <class Backend>
double stiffening_energy(const Backend& backend, const std::shared_ptr<Weighted_graph>& springs,
                         const Weighted_graph& current, double exponent, const typename Backend::Vectors& v)
{
  springs->inverse_diagonal = current.inverse_diagonal;
  const typename Backend::Matrix matrix = backend.upload(Shared_graph(springs));
  typename Backend::Vectors g = backend.vectors(current.size());
  typename Backend::Scalars density = backend.scalars(current.size());
  return backend.gradient(matrix, exponent, v, g, density)[0] / exponent;
}

/// Exponents above 2: the springs stiffen as they are stretched, and the map cannot slip off along a boost any more
/// (above the dimension 2 maps are held continuous by their energy, if the mesh is fine enough for the exponent: on
/// coarse ones they may collapse with small exponents). Nothing is balanced. The preconditioner is set up anew whenever
/// the springs have changed much. Where faces are flipped in the end, the accuracy is tightened.
/// Returns whether the certificate is that of v.
template <class Backend>
bool solve_stiffening(const Backend& backend, const Problem& problem, double exponent, double accuracy,
                      std::size_t maximum_iterations, Monitor& monitor, typename Backend::Vectors& v,
                      Solution& solution)
{
  // Far from the solution the springs change by orders of magnitude in a step; near it they are constant.
  const auto iterations_per_hierarchy = [](double residual) -> std::size_t {
    return residual > 1e-2 ? 1 : residual > 1e-5 ? 4 : 12;
  };
  const Stopwatch start_watch;
  v = backend.upload(start_positions(backend, problem, monitor, solution.report.start_iterations));
  solution.seconds.start_map = start_watch.seconds();

  const Gauge gauge = problem.has_fixed() ? Gauge::FIXED : Gauge::ROTATED;
  const auto springs = std::make_shared<Weighted_graph>(stiffening_springs(backend.host_loop(), problem, exponent));
  typename Backend::Scalars mass = backend.scalars(problem.size());
  Solver_report& report = solution.report;
  const std::size_t of_start = report.start_iterations;
  bool is_certified = false;
  double goal = accuracy;
  for(std::size_t done = 0, made = 1;; done += made) {
    const Host_array<vec3>& position = backend.download(v); // all set-up is the host's
    const auto current =
      std::make_shared<Weighted_graph>(springs_at(backend.host_loop(), *springs, exponent, position, problem.is_fixed));
    Multigrid<Backend> multigrid(backend, current);
    report.residual = std::sqrt(backend.barycentric_residual2(multigrid.matrix(0), v));
    report.iterations = done;
    if(report.has_converged) {
      const bool is_accurate = report.residual <= accuracy;
      if(goal < finest_accuracy)
        break;
      if(is_accurate) {
        is_certified = true;
        const auto resolution = [](const Certificate&, const Host_array<vec3>&) { return 0.; };
        if(settle(backend, problem, v, false, resolution, monitor, solution) == Settled::YES)
          break;
      }
      goal *= is_accurate ? accuracy_refinement : 0.1;
    }
    if((made == 0 && !report.has_converged) || done >= maximum_iterations || monitor.is_interrupted()) {
      if(done == 0) // no step has measured the energy
        report.energy = stiffening_energy(backend, springs, *current, exponent, v);
      break;
    }
    springs->inverse_diagonal = current->inverse_diagonal;
    const typename Backend::Matrix matrix = backend.upload(Shared_graph(springs));
    backend.spring_masses(backend.upload(problem.graph), v, mass);
    Float_cycle<Backend> cycle(backend, multigrid);
    Balanced_solver<Backend> solver(backend, matrix, cycle, 0, exponent, gauge, mass);
    const std::size_t round = (std::min)(iterations_per_hierarchy(report.residual), maximum_iterations - done);
    is_certified = false;
    report = solver.solve({goal, round}, monitor, v);
    report.start_iterations = of_start;
    made = report.iterations;
  }
  report.has_converged = report.residual <= accuracy;
  return is_certified;
}

/// Exponent 2: the balanced critical point or, with fixed vertices, the harmonic map, of which nothing is free to be
/// balanced. Returns whether the certificate is that of v.
///
/// The masses of the balance are the spring densities of a reference map, the solution itself, with the centroid of the
/// source area at the centre. (On a conformal map the density of energy is that of area.) They are tilted by a linear
/// function, so that this map is balanced. The reference is taken early and renewed as the residual falls: it is a
/// small change each time, and the descent goes on as if nothing had happened. Each renewal reduces the influence of
/// the start map, which depends on the numbering, some forty times.
template <class Backend, class Rejection>
bool solve_harmonic(const Backend& backend, const Problem& problem, const Rejection& rejects, double accuracy,
                    std::size_t maximum_iterations, Monitor& monitor, typename Backend::Vectors& v, Solution& solution)
{
  const Stopwatch watch;
  const bool is_free = !problem.has_fixed();
  Host_array<vec3> positions;
  if(!is_free)
    positions = start_positions(backend, problem, monitor, solution.report.start_iterations);
  Multigrid<Backend> multigrid(backend, with_fixed_vertices(backend.host_loop(), problem), &monitor);
  const typename Backend::Matrix& matrix = multigrid.matrix(0);
  const typename Backend::Scalars& area = backend.upload(problem.vertex_area(backend.host_loop()));
  typename Backend::Scalars mass = backend.scalars(problem.size());
  const Gauge gauge = is_free ? Gauge::BALANCED : Gauge::FIXED;
  Float_cycle<Backend> cycle(backend, multigrid);
  Balanced_solver<Backend> solver(backend, matrix, cycle, 0, 2, gauge, mass);
  solution.seconds.start_map = watch.seconds();

  const auto start = [&](typename Backend::Vectors& x) {
    const Stopwatch start_watch;
    x = is_free ? start_map(backend, multigrid, cycle, problem, monitor, solution.report.start_iterations)
                : backend.upload(positions);
    if(!is_free)
      backend.spring_masses(matrix, x, mass);
    solution.seconds.start_map += start_watch.seconds();
  };
  const auto descend = [&](const Descent_options& options, typename Backend::Vectors& x) {
    return solver.solve(options, monitor, x, is_free ? &area : nullptr);
  };
  // The residual of eq. (2) is that of the descent times D_i / |sum w_ij v_j|: 1 on fine meshes, up to 3 on coarse
  // ones.
  const double goal = is_free ? accuracy : accuracy / 3;
  const bool is_certified =
    solve_until_valid(backend, problem, start, descend, rejects, goal, maximum_iterations, monitor, v, solution);
  if(!is_free) {
    solution.report.residual = std::sqrt(backend.barycentric_residual2(matrix, v));
    solution.report.has_converged = solution.report.residual <= accuracy;
  }
  return is_certified;
}

/// Sets residual and energy of a map to those by which the solver goes.
template <class Backend>
void measure_balanced(const Backend& backend, const Problem& problem, double exponent,
                      const typename Backend::Vectors& v, Solver_report& report)
{
  if(exponent > 2) {
    const auto springs = std::make_shared<Weighted_graph>(stiffening_springs(backend.host_loop(), problem, exponent));
    const Host_array<vec3>& position = backend.download(v);
    const auto current =
      std::make_shared<Weighted_graph>(springs_at(backend.host_loop(), *springs, exponent, position, problem.is_fixed));
    const typename Backend::Matrix pulling = backend.upload(Shared_graph(current));
    report.residual = std::sqrt(backend.barycentric_residual2(pulling, v));
    report.energy = stiffening_energy(backend, springs, *current, exponent, v);
    return;
  }
  const int n = problem.size();
  typename Backend::Vectors g = backend.vectors(n);
  typename Backend::Scalars density = backend.scalars(n), mass = backend.scalars(n);
  const typename Backend::Matrix matrix = backend.upload(with_fixed_vertices(backend.host_loop(), problem));
  const std::array<double, 4> sums = backend.gradient(matrix, 2, v, g, density);
  report.energy = sums[0] / 2;
  if(problem.has_fixed()) {
    report.residual = std::sqrt(backend.barycentric_residual2(matrix, v));
    return;
  }
  const Moments moments = backend.tilt_masses(density, balancing_tilt(backend.moments(density, v)), v, mass);
  const vec3 mu = solve(boost_matrix(moments), {sums[1], sums[2], sums[3]});
  typename Backend::Steps b = backend.steps(n); // not needed, and no step was made
  report.residual = std::sqrt(backend.balance_gradient(matrix, mass, mu, v, g, backend.steps(n), b)[0]);
}

template <class Backend>
Solution Method_solver<Balanced>::solve(const Backend& backend, const Problem& problem, const Effort& effort,
                                        Monitor& monitor) const
{
  const double accuracy = accuracy_on(backend, problem, effort, Balanced::default_accuracy);
  const std::size_t maximum_iterations = effort.number_of_iterations.value_or(Balanced::default_number_of_iterations);
  const Stopwatch watch;
  Solution solution;
  typename Backend::Vectors v;
  const bool is_certified =
    method_.spring_exponent == 2
      ? solve_harmonic(backend, problem, rejects_, accuracy, maximum_iterations, monitor, v, solution)
      : solve_stiffening(backend, problem, method_.spring_exponent, accuracy, maximum_iterations, monitor, v, solution);
  solution.seconds.solve = watch.seconds() - solution.seconds.start_map - solution.seconds.certify;
  const auto measure = [&](const typename Backend::Vectors& x, Solver_report& report) {
    measure_balanced(backend, problem, method_.spring_exponent, x, report);
  };
  hand_over(backend, problem, std::move(v), is_certified, method_.spring_exponent == 2, accuracy, measure, monitor,
            solution);
  return solution;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_IMPL_H
