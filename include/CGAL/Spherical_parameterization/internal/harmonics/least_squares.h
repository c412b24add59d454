// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONICS_LEAST_SQUARES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONICS_LEAST_SQUARES_H

#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/harmonics/Grid_transform.h>
#include <CGAL/Spherical_parameterization/internal/harmonics/Scattered_points.h>
#include <CGAL/Spherical_parameterization/internal/harmonics/analysis.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Conjugate gradients for least squares (CGLS): every field for itself, in step, so that they share the transforms.
template <class Loop>
class Conjugate_gradients {
public:
  Conjugate_gradients(const Loop& loop, const Host_array<vec3>& directions, const Host_array<double>& weights,
                      int degree, int fields)
    : loop_(loop), transform_(degree), grid_(transform_.grid(fields)), points_(loop, grid_, directions),
      weights_(weights), n_(points_.size()), fields_(fields),
      scratch_(static_cast<std::size_t>(n_) * static_cast<std::size_t>(fields))
  {}

  /// \param values  field after field; becomes the residual
  Fit solve(Host_array<double>& values, const Least_squares& method)
  {
    Fit fit;
    fit.coefficients = Harmonic_coefficients(transform_.degree(), fields_);
    Harmonic_coefficients& x = fit.coefficients;
    Harmonic_coefficients s = x;
    gradient(values, s);
    Harmonic_coefficients p = s;
    const std::vector<double> first = squares(s);
    std::vector<double> square = first;
    Host_array<double> q(values.size());
    const auto goes_on = [&](int field) { return square[field] > method.accuracy * method.accuracy * first[field]; };
    const auto any_goes_on = [&] {
      for(int field = 0; field < fields_; ++field)
        if(goes_on(field))
          return true;
      return false;
    };
    while(any_goes_on()) {
      if(fit.iterations == method.iterations) {
        fit.has_converged = false;
        break;
      }
      ++fit.iterations;
      transform_.synthesize(loop_, p, grid_);
      points_.interpolate(loop_, grid_, q.data());
      for(int field = 0; field < fields_; ++field) {
        double* const r = values.data() + static_cast<std::size_t>(field) * n_;
        const double* const qf = q.data() + static_cast<std::size_t>(field) * n_;
        const double curvature = sum_by_parts(loop_, n_, [&](int i) { return weights_[i] * qf[i] * qf[i]; });
        const double step = goes_on(field) && curvature > 0 ? square[field] / curvature : 0;
        for(int i = 0; i < x.size(); ++i)
          x.field_begin(field)[i] += step * p.field_begin(field)[i];
        for_each_index(loop_, n_, [&](int i) { r[i] -= step * qf[i]; });
      }
      gradient(values, s);
      const std::vector<double> now = squares(s);
      for(int field = 0; field < fields_; ++field) {
        const double share = square[field] > 0 ? now[field] / square[field] : 0;
        for(int i = 0; i < p.size(); ++i)
          p.field_begin(field)[i] = s.field_begin(field)[i] + share * p.field_begin(field)[i];
      }
      square = now;
    }
    return fit;
  }

private:
  /// The inner products of the weighted residual with the harmonics.
  void gradient(const Host_array<double>& residual, Harmonic_coefficients& s)
  {
    for_each_index(loop_, n_, [&](int i) {
      for(int field = 0; field < fields_; ++field) {
        const std::size_t at = static_cast<std::size_t>(field) * n_ + i;
        scratch_[at] = weights_[i] * residual[at];
      }
    });
    std::fill(grid_.value.begin(), grid_.value.end(), 0);
    points_.spread(loop_, scratch_.data(), grid_);
    transform_.analyze(loop_, grid_, s);
  }

  static std::vector<double> squares(const Harmonic_coefficients& s)
  {
    std::vector<double> result;
    for(int field = 0; field < s.number_of_fields(); ++field)
      result.push_back(
        std::inner_product(s.field_begin(field), s.field_begin(field) + s.size(), s.field_begin(field), 0.));
    return result;
  }

  const Loop& loop_;
  Grid_transform transform_;
  Angular_grid grid_;
  Scattered_points points_;
  const Host_array<double>& weights_;
  int n_, fields_;
  Host_array<double> scratch_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONICS_LEAST_SQUARES_H
