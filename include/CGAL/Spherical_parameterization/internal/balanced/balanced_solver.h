// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_BALANCED_SOLVER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_BALANCED_SOLVER_H

#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Float_cycle.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>
#include <CGAL/Spherical_parameterization/internal/moebius/moebius.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// The share of the whole work that the start map takes, for the progress callback.
constexpr double start_share = 0.4;

/// When a descent ends, and how far it steps.
struct Descent_options {
  double accuracy;
  std::size_t maximum_iterations;
  double work_before = start_share; ///< share of the whole work that has been done before, for the progress callback
  double work_after = 1;            ///< ... and afterwards
  std::size_t patience = 30;        ///< so many iterations without progress are taken for a stall
  double longest_factor = 1000;     ///< bound of the step length; 1 is the step of an exact preconditioner
};

/// What is left of the freedom to move a solution by a Moebius transformation.
enum class Gauge {
  FIXED,   ///< nothing: there are fixed vertices
  ROTATED, ///< rotations, which are kept out of the descent: exponents above 2
  BALANCED ///< rotations; boosts would change the energy but little, and are held by sum m_i v_i = 0
};

/// Riemannian conjugate gradients on the product of spheres (F. Alouges, "A new algorithm for computing liquid crystal
/// stable configurations: the harmonic mapping case", SIAM J. Numer. Anal. 34, 1997, descends on the same energy; the
/// preconditioner and the treatment of the Moebius freedom are ours).
///
/// `Gauge::BALANCED` minimises the spring energy subject to sum m_i v_i = 0. Both the multiplier and the way back
/// to the constraint use the boost fields b_k = P e_k, along which the energy of a smooth map is flat:
///   mu = N^-1 sum g_i,  r = g - m P mu,  d <- d - P N^-1 sum m_i d_i,  N = sum m_i P_i.
/// The projection Q = 1 - b N^-1 (m b)^T is applied to r as Q^T, to the direction as Q, so that Q M^-1 Q^T stays
/// symmetric. Moreover sum r_i = 0: r is a right-hand side for which the *singular* Laplacian is solvable, and the
/// constant that the solution leaves open is a boost and a rotation, which Q and the energy do not see. Hence one
/// multigrid hierarchy, that of L itself, serves start map and solve, and no shift floods the limbs.
template <class Backend>
class Balanced_solver {
  typedef typename Backend::Vectors Vectors;
  typedef typename Backend::Scalars Scalars;
  typedef typename Backend::Steps Steps;

public:
  /// `matrix`: the springs on level k of the hierarchy, which preconditions; `mass`: areas on the sphere, which bound
  /// the steps, and define the balance.
  Balanced_solver(const Backend& backend, const typename Backend::Matrix& matrix, Float_cycle<Backend>& cycle,
                  std::size_t k, double spring_exponent, Gauge gauge, Scalars& mass)
    : backend_(backend), matrix_(matrix), cycle_(cycle), level_(k), exponent_(spring_exponent), gauge_(gauge),
      mass_(mass)
  {}

  /// Descends from v, unit vectors that need not be balanced. Given the areas of the source, the masses are those of
  /// references (exponent 2): v itself, at the start, when the residual has come down to 1e-2, and whenever it has
  /// fallen to a third since. There v is boosted until the centroid of the area is at the centre, the masses become its
  /// spring densities, and a linear factor balances them.
  Solver_report solve(const Descent_options& options, Monitor& monitor, Vectors& v, const Scalars* area = nullptr) const
  {
    constexpr double longest_step = 0.25; // root mean square over the sphere of the angles by which vertices move
    constexpr double progress = 0.8;      // at the limit of rounding the residual falls no more
    constexpr double balance_tolerance = 1e-4, per_residual = 1e-2; // the steps undo what is left
    constexpr int balance_steps = 10;
    constexpr double fall_between_references = 0.3, largest_rise = 100;
    constexpr int most_references = 16;
    double next_reference = 1e-2;
    int references = 0;
    const int n = static_cast<int>(v.size());
    Vectors g = backend_.vectors(n), w = backend_.vectors(n);
    Steps s = backend_.steps(n), d = backend_.steps(n);
    Steps scratch = backend_.steps_in(g); // g is free once the forces are balanced
    Scalars density = backend_.scalars(n);
    Solver_report report;

    Moments moments{};
    std::array<double, 4> sums;
    const auto begin = [&](double tolerance) {
      moments = backend_.moments(mass_, v);
      if(gauge_ == Gauge::BALANCED)
        balance(backend_, mass_, tolerance, balance_steps, v, w, moments);
      sums = backend_.gradient(matrix_, exponent_, v, g, density);
    };
    const auto refer = [&](double tolerance) {
      centre(backend_, *area, tolerance, v, w);
      sums = backend_.gradient(matrix_, exponent_, v, g, density);
      moments = backend_.tilt_masses(density, balancing_tilt(backend_.moments(density, v)), v, mass_);
      if(norm(first_moment(moments)) > tolerance * total_mass(moments)) // no factor balances masses so uneven
        begin(tolerance);
    };
    Symmetric_solver<3> boosts = boost_matrix({});
    vec3 mu = {0, 0, 0};
    double along_last_step = 0; // s . g, s the preconditioned gradient of the point before
    // The right-hand side of the cycle lies in w, until references and line search use that.
    const auto balance_forces = [&] {
      boosts = boost_matrix(moments);
      if(gauge_ == Gauge::BALANCED)
        mu = internal::solve(boosts, force(sums));
      report.energy = sums[0] / exponent_;
      Steps b = backend_.steps_in(w);
      const std::array<double, 2> products = backend_.balance_gradient(matrix_, mass_, mu, v, g, s, b);
      report.residual = std::sqrt(products[0]);
      along_last_step = products[1];
      return b;
    };
    area ? refer(balance_tolerance) : begin(balance_tolerance);
    double gs = 0;
    double first = 0, best = 0;
    std::size_t best_at = 0;
    for(;; ++report.iterations) {
      Steps b = balance_forces();
      if(area && references < most_references && report.residual <= next_reference) {
        const double before = report.residual;
        next_reference = fall_between_references * before;
        ++references;
        refer((std::min)(balance_tolerance, per_residual * before));
        b = balance_forces();
        if(report.residual > largest_rise * before) { // the map collapses, and each reference is another one
          references = most_references;
          best = report.residual; // of the last one
          best_at = report.iterations;
        }
      }
      if(report.iterations == 0)
        first = best = report.residual;
      if(report.residual < progress * best) {
        best = report.residual;
        best_at = report.iterations;
      }
      report.has_stalled = report.iterations >= best_at + options.patience;
      monitor.log("solve", report.iterations, report.residual, report.energy);
      report.has_converged = report.residual <= options.accuracy;
      const double share = Monitor::share(report.residual, first, options.accuracy);
      if(report.has_converged || report.has_stalled || report.iterations == options.maximum_iterations ||
         !monitor.advance(options.work_before + (options.work_after - options.work_before) * share))
        return report;

      cycle_.apply(level_, b, scratch, s);
      // What a direction does is linear in it, so that one pass over step and last direction tells it of all betas.
      const std::array<double, 14> products = backend_.direction_products(matrix_, mass_, v, b, s, d);
      // Polak and Ribiere's beta. M^-1 is symmetric: the gradient before needs not be kept.
      double beta = report.iterations == 0 ? 0 : (std::max)(0., (products[0] - along_last_step) / gs);
      gs = products[0];
      if(!(beta * products[7] - products[0] < 0))
        beta = 0;
      std::array<double, 7> of_next; // product with the gradient; momentum; angular momentum
      for(int k = 0; k < 7; ++k)
        of_next[k] = beta == 0 ? -products[k] : beta * products[7 + k] - products[k];
      const double slope = of_next[0];
      if(!(slope < 0)) { // rounding has eaten the gradient: no direction of descent is left
        report.has_stalled = true;
        return report;
      }
      // The slope does not see the projection: the energy does not see rotations, and a balanced gradient sums to zero.
      vec3 boost = {0, 0, 0}, rotation = {0, 0, 0};
      if(gauge_ == Gauge::BALANCED)
        boost = internal::solve(boosts, {of_next[1], of_next[2], of_next[3]});
      if(gauge_ != Gauge::FIXED)
        rotation = internal::solve(boosts, {of_next[4], of_next[5], of_next[6]});
      backend_.next_direction(beta, boost, rotation, v, s, d);

      const std::array<double, 5> model = backend_.curvature(matrix_, exponent_, mass_, mu, v, d, density);
      const double longest = longest_step * std::sqrt(total_mass(moments) / model[1]);
      const double alpha = (std::min)({model[0] > 0 ? -slope / model[0] : 1, longest, options.longest_factor});
      report.has_stalled =
        !line_search(alpha, slope, boosts, {model[2], model[3], model[4]}, d, v, w, g, density, moments, sums);
      if(report.has_stalled)
        return report;
    }
  }

private:
  /// Of the four sums of Backend::gradient(), the sum of the gradient.
  static vec3 force(const std::array<double, 4>& sums) { return {sums[1], sums[2], sums[3]}; }

  /// Armijo's rule from the step of the quadratic model. On success v, g, density, moments and sums are those of the
  /// new point; on failure v is unchanged.
  ///
  /// A step alpha along d takes the map off balance by -alpha^2/2 sum m_i |d_i|^2 v_i up to third order; the sum is
  /// `drift`. A boost in the same pass undoes that, and what the step before has left.
  bool line_search(double alpha, double slope, const Symmetric_solver<3>& boosts, vec3 drift, const Steps& d,
                   Vectors& v, Vectors& w, Vectors& g, Scalars& density, Moments& moments,
                   std::array<double, 4>& sums) const
  {
    constexpr int maximum_halvings = 20;
    constexpr double sufficient = 1e-4;
    constexpr double longest_boost = 0.5;
    const bool is_balanced = gauge_ == Gauge::BALANCED;
    const vec3 left = is_balanced ? scale(0.5, internal::solve(boosts, first_moment(moments))) : make_vec3(0, 0, 0);
    // A boost with centre c has the velocity -2 P c: this is what undoing the imbalance that is left may cost.
    const double energy = sums[0] / exponent_ + (std::max)(0., -2 * inner(left, force(sums)));
    for(int h = 0; h < maximum_halvings; ++h, alpha /= 2) {
      vec3 c = left;
      if(is_balanced)
        c = sub(c, internal::solve(boosts, scale(alpha * alpha / 4, drift)));
      if(norm(c) > longest_boost)
        c = scale(longest_boost / norm(c), c);
      const Moments next = backend_.retract(mass_, alpha, c, v, d, w);
      const std::array<double, 4> next_sums = backend_.gradient(matrix_, exponent_, w, g, density);
      if(next_sums[0] / exponent_ <= energy + sufficient * alpha * slope + backend_.rounding() * energy) {
        std::swap(v, w);
        moments = next;
        sums = next_sums;
        return true;
      }
    }
    return false;
  }

  const Backend& backend_;
  const typename Backend::Matrix& matrix_;
  Float_cycle<Backend>& cycle_;
  std::size_t level_;
  double exponent_;
  Gauge gauge_;
  Scalars& mass_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_BALANCED_SOLVER_H
