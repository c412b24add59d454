// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_CHEBYSHEV_SMOOTHER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_CHEBYSHEV_SMOOTHER_H

#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// The smoother of the V-cycle: two damped Jacobi steps whose gains make them the Chebyshev iteration of degree 2 on
/// the upper part of the spectrum of D^-1 A. After the coarse correction the gains come in reverse order, which keeps
/// the cycle symmetric. The formula of a step is smooth_at() in backend/formulas/linear_algebra.h.
class Chebyshev_smoother {
public:
  explicit Chebyshev_smoother(double spectral_radius = 1)
  {
    constexpr double smoothed_range = 6; // the smoother handles the eigenvalues from 1/6 of the largest one on
    const double high = 1.05 * spectral_radius;
    const double low = high / smoothed_range;
    const double centre = (high + low) / 2;
    const double deviation = (high - low) / 2 * std::sqrt(0.5);
    first_ = 1 / (centre + deviation);
    second_ = 1 / (centre - deviation);
  }

  /// y = the smoothed solution of A y = b from 0; x is scratch.
  template <class Backend>
  void smooth_from_zero(const Backend& backend, const typename Backend::Matrix& a, const typename Backend::Vectors& b,
                        typename Backend::Vectors& x, typename Backend::Vectors& y) const
  {
    backend.start_smoothing(a, first_, b, x);
    backend.smooth(a, second_, b, x, y);
  }

  /// Smooths y in place; x is scratch.
  template <class Backend>
  void smooth_backwards(const Backend& backend, const typename Backend::Matrix& a, const typename Backend::Vectors& b,
                        typename Backend::Vectors& y, typename Backend::Vectors& x) const
  {
    backend.smooth(a, second_, b, y, x);
    backend.smooth(a, first_, b, x, y);
  }

private:
  double first_, second_; ///< gains
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_CHEBYSHEV_SMOOTHER_H
