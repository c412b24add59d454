// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_MULTIGRID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_MULTIGRID_H

#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/coarsening.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/dense_inverse.h>

#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The gains of the two damped Jacobi steps that smooth. With them the steps are the Chebyshev iteration of degree 2 on
/// the upper part of the spectrum of D^-1 A.
inline std::pair<double, double> chebyshev_gains(double spectral_radius)
{
  constexpr double smoothed_range = 6; // the smoother handles the eigenvalues from 1/6 of the largest one on
  const double high = 1.05 * spectral_radius;
  const double low = high / smoothed_range;
  const double centre = (high + low) / 2;
  const double deviation = (high - low) / 2 * std::sqrt(0.5);
  return {1 / (centre + deviation), 1 / (centre - deviation)};
}

/// One symmetric V-cycle of smoothed aggregation as a preconditioner for the Laplacian of a weighted graph, applied to
/// three right-hand sides at once. Fixed vertices stay 0. Without fixed vertices and excess the matrix is singular; its
/// right-hand sides have to sum to zero, and the solution is then defined up to a constant.
///
/// Set up on the host; the cycle is written over the verbs of `Backend`. O(n) time and memory in both.
template <class Backend>
class Multigrid {
  typedef typename Backend::Vectors Vectors;
  typedef typename Backend::Matrix Matrix;

public:
  struct Level {
    Shared_graph graph;
    Matrix matrix;
    // of all levels but the last one
    Shared_aggregates aggregates = {};
    typename Backend::Aggregates on_backend = {};
    double damping = 0; ///< of the prolongation: omega
    std::pair<double, double> gains = {};
    Vectors scratch = {}, coarse_b = {}, coarse_x = {}; ///< empty before the first cycle

    int size() const { return graph->size(); }
  };

  /// `monitor`, if any, is asked before each level. Throws Error if the computation has to end.
  /// \pre the weights of `fine` are not negative
  Multigrid(const Backend& backend, Shared_graph fine, Monitor* monitor = nullptr) : backend_(backend)
  {
    bool is_singular = fine->excess.empty();
    for(int i = 0; is_singular && i < fine->size(); ++i)
      is_singular = fine->inverse_diagonal[i] > 0;

    const auto& loop = backend.host_loop();
    Shared_graph a = std::move(fine);
    while(a->size() > bottom_size) {
      if(monitor)
        monitor->advance_or_throw();
      const double radius = spectral_radius(*a);
      Aggregates aggregates = aggregate(loop, *a, strength_threshold);
      if(aggregates.count() > slow_coarsening * a->size())
        aggregates = aggregate(loop, *a, 0);
      if(aggregates.count() > no_coarsening * a->size()) // the excess is all that counts from here on
        break;
      const double damping = prolongation_damping / radius;
      const auto coarse = std::make_shared<Weighted_graph>();
      {
        const Sparse_matrix p = smoothed_prolongation(loop, *a, aggregates, damping);
        const Sparse_matrix r = transposed(loop, p, aggregates.count());
        *coarse = galerkin_product(loop, *a, p, r, is_singular);
      }
      drop_weak_edges(loop, weakest_edge, *coarse);

      const auto shared = std::make_shared<const Aggregates>(std::move(aggregates));
      levels_.push_back({a, backend.upload(a), shared, backend.upload(shared), damping, chebyshev_gains(radius)});
      a = coarse;
    }
    if(a->size() <= bottom_size)
      bottom_inverse_ = backend.upload(dense_inverse(*a, is_singular));
    levels_.push_back({a, backend.upload(a)});
  }

  /// Level 0 is the finest, the last one the smallest.
  std::size_t number_of_levels() const { return levels_.size(); }
  const Level& level(std::size_t k) const { return levels_[k]; }
  int size(std::size_t k) const { return levels_[k].size(); }
  const Matrix& matrix(std::size_t k) const { return levels_[k].matrix; }
  /// The inverse of the last level, if that is small enough to have one; else empty: it is as good as diagonal.
  const typename Backend::Scalars& bottom_inverse() const { return bottom_inverse_; }

  /// Interpolates x, of level k + 1, on level k: a Jacobi step smooths the values of the aggregates.
  void prolong(std::size_t k, const Vectors& x, Vectors& y) const
  {
    const Level& level = levels_[k];
    Vectors aggregated = backend_.vectors(level.size());
    const Vectors zero = backend_.vectors(level.size());
    backend_.correct(level.on_backend, x, aggregated);
    backend_.smooth(level.matrix, level.damping, zero, aggregated, y);
  }

  /// x = M^-1 b on level k
  void apply(std::size_t k, const Vectors& b, Vectors& x)
  {
    Level& level = levels_[k];
    if(k + 1 == levels_.size()) {
      if(bottom_inverse_.size() > 0)
        backend_.multiply_dense(bottom_inverse_, b, x);
      else
        backend_.start_smoothing(level.matrix, 1, b, x);
      return;
    }
    if(level.scratch.size() == 0) {
      level.scratch = backend_.vectors(level.size());
      level.coarse_b = backend_.vectors(size(k + 1));
      level.coarse_x = backend_.vectors(size(k + 1));
    }
    // See smoothed_prolongation(). After a Jacobi step of gain omega the residual is (I - omega A D^-1) r, r the one
    // before, and its sum over an aggregate P^T r; after the correction by T e such a step makes it one by P e. So
    // steps that smooth anyway apply both (and smooth where P does not). They come in reverse order then, which keeps
    // the cycle symmetric.
    const auto [first, second] = level.gains;
    Vectors& y = level.scratch;
    backend_.start_smoothing(level.matrix, first, b, x);
    backend_.smooth(level.matrix, second, b, x, y);
    backend_.smooth(level.matrix, level.damping, b, y, x);
    backend_.residual(level.matrix, b, x, y);
    backend_.restrict(level.on_backend, y, level.coarse_b);
    apply(k + 1, level.coarse_b, level.coarse_x);
    backend_.correct(level.on_backend, level.coarse_x, x);
    backend_.smooth(level.matrix, level.damping, b, x, y);
    backend_.smooth(level.matrix, second, b, y, x);
    backend_.smooth(level.matrix, first, b, x, y);
    std::swap(x, y);
  }

private:
  static constexpr int bottom_size = 100;
  static constexpr double strength_threshold = 0.07;
  static constexpr double weakest_edge = 0.01;
  static constexpr double slow_coarsening = 0.4;
  static constexpr double no_coarsening = 0.9;
  static constexpr double prolongation_damping = 1.6;

  const Backend& backend_;
  std::vector<Level> levels_;
  typename Backend::Scalars bottom_inverse_; ///< of the last level
};

/// Solves A x = b on level k of the hierarchy, for three right-hand sides, by conjugate gradients with one multigrid
/// cycle as the preconditioner, to a relative error of about `accuracy` in the energy norm. `x` is 0 on entry. Returns
/// the number of iterations.
template <class Backend>
std::size_t conjugate_gradients(const Backend& backend, Multigrid<Backend>& multigrid, std::size_t k,
                                typename Backend::Vectors r, double accuracy, Monitor& monitor, double share_of_work,
                                typename Backend::Vectors& x)
{
  constexpr std::size_t maximum_iterations = 200;
  const typename Backend::Matrix& a = multigrid.matrix(k);
  const int n = multigrid.size(k);
  typename Backend::Vectors s = backend.vectors(n), p = backend.vectors(n), q = backend.vectors(n);
  double rs = 0;
  double energy = 0, first = 0;
  for(std::size_t it = 0; it < maximum_iterations; ++it) {
    multigrid.apply(k, r, s);
    const double previous = rs;
    rs = backend.dot(r, s);
    backend.conjugate(it > 0 ? rs / previous : 0, s, p);
    const double curvature = backend.multiply(a, p, q);
    if(!(curvature > 0)) // r is exactly zero, or rounding has eaten it
      return it;
    const double alpha = rs / curvature;
    backend.descend(alpha, p, q, x, r);
    // alpha rs is by how much the squared energy norm of the error has fallen in this step.
    const double gain = alpha * rs;
    energy += gain;
    if(it == 0)
      first = gain;
    monitor.log("start map", it, std::sqrt(gain / energy), energy);
    const double goal = accuracy * accuracy * energy;
    if(!monitor.advance(share_of_work * Monitor::share(gain, first, goal)) || gain <= goal)
      return it + 1;
  }
  return maximum_iterations;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_MULTIGRID_H
