// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_LEAST_SQUARES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_LEAST_SQUARES_H

#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/Scattered_points.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The normal equations of least squares at points x_i with weights w_i, in coefficients alone. The product of two
/// harmonics of degree L is a function of degree 2L; so what the normal matrix has of the points are the inner products
/// of their weights with the harmonics of degree up to 2L. They make up a density on the sphere, and the matrix is:
/// synthesis on a grid, times the density there, analysis, exact to rounding by a quadrature for degree 4L. The points
/// are looked at once, not in every iteration (H. Feichtinger, K. Groechenig, T. Strohmer, "Efficient numerical methods
/// in non-uniform sampling theory", Numer. Math. 69, 1995, on the circle).
template <class Loop>
class Normal_equations {
public:
  Normal_equations(const Loop& loop, const Host_array<vec3>& directions, const Sampled_fields& fields,
                   const Host_array<double>& weights, int degree)
    : loop_(loop), rows_(gauss_legendre_rows(2 * degree + 1, 4 * degree + 2)),
      right_hand_side_(degree, fields.number_of_fields)
  {
    const int n = static_cast<int>(directions.size());
    const Grid_transform<> of_density(2 * degree), of_fields(degree, 2 * degree);
    Angular_grid grid = of_density.grid(1); // one field at a time: for high degrees this is the most memory
    const Scattered_points points(loop, grid, directions);
    const auto inner_products = [&](const Host_array<double>& values, const Grid_transform<>& transform) {
      Harmonic_coefficients c(transform.degree(), 1);
      std::fill(grid.value.begin(), grid.value.end(), 0);
      points.spread(loop, values.data(), grid);
      transform.analyze(loop, grid, c);
      return c;
    };
    density_ = synthesize_on_rows(loop, inner_products(weights, of_density), rows_);
    Host_array<double> weighted(weights.size());
    for(int field = 0; field < fields.number_of_fields; ++field) {
      const double* const value = fields.value.data() + static_cast<std::size_t>(field) * n;
      for_each_index(loop, n, [&](int i) { weighted[i] = weights[i] * value[i]; });
      const Harmonic_coefficients c = inner_products(weighted, of_fields);
      std::copy_n(c.field_begin(0), c.size(), right_hand_side_.field_begin(field));
    }
  }

  const Harmonic_coefficients& right_hand_side() const { return right_hand_side_; }

  /// The matrix times every field.
  Harmonic_coefficients operator*(const Harmonic_coefficients& x) const
  {
    Sampled_fields values = {x.number_of_fields(), synthesize_on_rows(loop_, x, rows_)};
    for(std::size_t i = 0; i < values.value.size(); ++i)
      values.value[i] *= density_[i % density_.size()];
    return analyze_rows(loop_, rows_, values, x.degree());
  }

private:
  const Loop& loop_;
  Latitude_rows rows_;
  Host_array<double> density_;
  Harmonic_coefficients right_hand_side_;
};

/// Conjugate gradients: every field for itself, in step, so that they share the transforms. Where the residual that was
/// carried along is within the accuracy, that of the coefficients is looked at, and taken from there on if it is not.
template <class Loop, class Matrix>
Harmonic_analysis conjugate_gradients(const Loop& loop, const Matrix& matrix, const Least_squares& method)
{
  const int fields = matrix.right_hand_side().number_of_fields(), size = matrix.right_hand_side().size();
  const auto inner = [=](const Harmonic_coefficients& a, const Harmonic_coefficients& b, int field) {
    return std::inner_product(a.field_begin(field), a.field_begin(field) + size, b.field_begin(field), 0.);
  };
  Harmonic_analysis fit;
  fit.coefficients = Harmonic_coefficients(matrix.right_hand_side().degree(), fields);
  fit.has_converged = false;
  Harmonic_coefficients residual = matrix.right_hand_side(), direction = residual;
  std::vector<double> square;
  for(int field = 0; field < fields; ++field)
    square.push_back(inner(residual, residual, field));
  const std::vector<double> first = square;
  const double wanted = method.accuracy * method.accuracy;
  const auto goes_on = [&](int field) { return square[field] > wanted * first[field]; };
  /// The largest square of a residual, as a part of the first one.
  const auto worst = [&] {
    double result = 0;
    for(int field = 0; field < fields; ++field)
      if(goes_on(field))
        result = (std::max)(result, square[field] / first[field]);
    return result;
  };
  double last = std::numeric_limits<double>::infinity();
  for(;; ++fit.iterations) {
    if(worst() == 0) {
      if(fit.iterations > 0) {
        const Harmonic_coefficients product = matrix * fit.coefficients;
        for(std::size_t i = 0; i < residual.values().size(); ++i)
          residual.values()[i] = matrix.right_hand_side().values()[i] - product.values()[i];
        direction = residual;
        for(int field = 0; field < fields; ++field)
          square[field] = inner(residual, residual, field);
      }
      constexpr double rounding = 0.25; // what does not become that much less is all that rounding lets through
      const double now = worst();
      fit.has_converged = now == 0;
      if(fit.has_converged || now > rounding * last)
        break;
      last = now;
    }
    if(fit.iterations == method.iterations)
      break;
    loop.advance(
      (std::max)(static_cast<double>(fit.iterations) / method.iterations, Monitor::share(worst(), 1, wanted)));
    const Harmonic_coefficients product = matrix * direction;
    for(int field = 0; field < fields; ++field) {
      double* const x = fit.coefficients.field_begin(field);
      double* const r = residual.field_begin(field);
      double* const p = direction.field_begin(field);
      const double curvature = inner(direction, product, field);
      const double step = goes_on(field) && curvature > 0 ? square[field] / curvature : 0;
      for(int i = 0; i < size; ++i) {
        x[i] += step * p[i];
        r[i] -= step * product.field_begin(field)[i];
      }
      const double before = std::exchange(square[field], inner(residual, residual, field));
      const double share = before > 0 ? square[field] / before : 0;
      for(int i = 0; i < size; ++i)
        p[i] = r[i] + share * p[i];
    }
  }
  return fit;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_LEAST_SQUARES_H
