// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_H

#include <CGAL/Spherical_parameterization/internal/coarsening.h>

#include <Eigen/Dense>

#include <algorithm>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

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
  /// `fine` is the host's copy of `matrix`; `matrix` must outlive the hierarchy.
  Multigrid(const Backend& backend, const Weighted_graph& fine, const Matrix& matrix)
    : backend_(backend), fine_matrix_(&matrix)
  {
    bool is_singular = fine.excess.empty();
    for(int i = 0; is_singular && i < fine.size(); ++i)
      is_singular = fine.inverse_diagonal[i] > 0;

    const Weighted_graph* a = &fine;
    Weighted_graph coarse;
    while(a->size() > bottom_size) {
      const double radius = spectral_radius(*a);
      Aggregates aggregates = aggregate(*a, strength_threshold);
      if(aggregates.count > slow_coarsening * a->size())
        aggregates = aggregate(*a, 0);
      Sparse_matrix p = smoothed_prolongation(*a, aggregates, prolongation_damping / radius);
      Sparse_matrix r = p.transposed(aggregates.count);
      Weighted_graph next = galerkin_product(*a, p, r, is_singular);

      Level level;
      level.largest_eigenvalue = radius;
      level.prolongation = backend.upload(std::move(p));
      level.restriction = backend.upload(std::move(r));
      level.x = backend.vectors(levels_.empty() ? 0 : a->size());
      level.y = backend.vectors(a->size());
      level.d = backend.vectors(a->size());
      level.b = backend.vectors(levels_.empty() ? 0 : a->size());
      if(!levels_.empty())
        level.matrix = backend.upload(std::move(coarse));
      levels_.push_back(std::move(level));
      coarse = std::move(next);
      a = &coarse;
    }
    bottom_inverse_ = backend.upload(inverse(*a, is_singular));
    bottom_b_ = backend.vectors(a->size());
    bottom_x_ = backend.vectors(a->size());
  }

  /// x = M^-1 b
  void apply(const Vectors& b, Vectors& x) { cycle(0, b, x); }

private:
  static constexpr int bottom_size = 100;
  static constexpr double strength_threshold = 0.05;
  static constexpr double slow_coarsening = 0.4;
  static constexpr double prolongation_damping = 4. / 3;
  static constexpr double smoothed_range = 8; // the smoother handles the eigenvalues from 1/8 of the largest one on

  /// Coarse levels cost little: they can afford the second Chebyshev step, the finest level cannot.
  static int smoothing_steps(std::size_t k) { return k == 0 ? 1 : 2; }

  struct Level {
    Matrix matrix; ///< unused on the finest level
    typename Backend::Transfer prolongation, restriction;
    double largest_eigenvalue;
    Vectors b, x, y, d;
  };

  const Matrix& matrix(std::size_t k) const { return k == 0 ? *fine_matrix_ : levels_[k].matrix; }

  void cycle(std::size_t k, const Vectors& b, Vectors& x)
  {
    if(k == levels_.size()) {
      backend_.multiply_dense(bottom_inverse_, b, x);
      return;
    }
    Level& level = levels_[k];
    const bool next_is_bottom = k + 1 == levels_.size();
    Vectors& coarse_b = next_is_bottom ? bottom_b_ : levels_[k + 1].b;
    Vectors& coarse_x = next_is_bottom ? bottom_x_ : levels_[k + 1].x;

    smooth(k, b, x, true);
    backend_.residual(matrix(k), b, x, level.y);
    backend_.transfer(level.restriction, level.y, coarse_b);
    cycle(k + 1, coarse_b, coarse_x);
    backend_.transfer_add(level.prolongation, coarse_x, x);
    smooth(k, b, x, false);
  }

  /// Chebyshev iteration on the upper part of the spectrum of D^-1 A.
  void smooth(std::size_t k, const Vectors& b, Vectors& x, bool from_zero)
  {
    Level& level = levels_[k];
    const double high = 1.05 * level.largest_eigenvalue;
    const double low = high / smoothed_range;
    const double centre = (high + low) / 2;
    const double half_width = (high - low) / 2;
    const double sigma = centre / half_width;
    double rho = 1 / sigma;
    for(int step = 0; step < smoothing_steps(k); ++step) {
      double keep = 0;
      double gain = 1 / centre;
      if(step > 0) {
        const double next = 1 / (2 * sigma - rho);
        keep = next * rho;
        gain = 2 * next / half_width;
        rho = next;
      }
      if(step == 0 && from_zero)
        backend_.start_chebyshev(matrix(k), gain, b, level.d, x);
      else {
        backend_.continue_chebyshev(matrix(k), keep, gain, b, x, level.d, level.y);
        std::swap(x, level.y);
      }
    }
  }

  /// Dense inverse. Of a singular matrix, whose kernel are the constants, that of A plus a multiple of 1 1^T: on
  /// right-hand sides that sum to zero it makes no difference which.
  static std::vector<double> inverse(const Weighted_graph& a, bool is_singular)
  {
    const int n = a.size();
    if(n == 0)
      return {};
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    double scale = 0;
    for(int i = 0; i < n; ++i) {
      if(a.inverse_diagonal[i] == 0) {
        m(i, i) = 1;
        continue;
      }
      m(i, i) = 1 / a.inverse_diagonal[i];
      scale = (std::max)(scale, m(i, i));
      for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
        if(a.inverse_diagonal[a.target[k]] > 0)
          m(i, a.target[k]) -= a.weight[k];
    }
    if(is_singular)
      m.array() += scale / n;
    m = m.ldlt().solve(Eigen::MatrixXd::Identity(n, n)).eval();
    for(int i = 0; i < n; ++i)
      if(a.inverse_diagonal[i] == 0)
        m(i, i) = 0;
    std::vector<double> rows(std::size_t(n) * n);
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j)
        rows[std::size_t(i) * n + j] = (m(i, j) + m(j, i)) / 2;
    return rows;
  }

  const Backend& backend_;
  const Matrix* fine_matrix_;
  std::vector<Level> levels_;
  typename Backend::Scalars bottom_inverse_;
  Vectors bottom_b_, bottom_x_;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_H
