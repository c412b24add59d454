// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_IMPL_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/Scattered_points.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/face_quadrature.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Throws Error for what cannot be analyzed.
CGAL_SP_INLINE Valid_map checked(const Watched_loop<Host_loop>& loop, Mapped_surface map, const Sampled_fields& fields)
{
  check_directions(map.image);
  for(std::size_t i = 0; i < fields.value.size(); ++i)
    if(!std::isfinite(fields.value[i]))
      throw Input_error(Error_code::NON_FINITE_COORDINATE,
                        "the value of vertex " + std::to_string(i % map.image.size()));
  return {std::move(map), loop.bare()};
}

/// What each vertex counts in least squares: none of the numbers is negative, and they are finite.
CGAL_SP_INLINE Host_array<double> vertex_weights(const Watched_loop<Host_loop>& loop, const Valid_map& map,
                                                 Vertex_weights weights)
{
  if(weights == Vertex_weights::EQUAL)
    return Host_array<double>(map.image.size(), 1.);
  const auto area_on_sphere = [&](int f) {
    const auto [a, b, c] = map.of_image(f);
    // that of a valid map is below 0 by rounding at most
    return (std::max)(0., spherical_area(unit(a), unit(b), unit(c)));
  };
  const Host_array<double> result =
    weights == Vertex_weights::SURFACE_AREA
      ? map.vertex_area(loop.bare())
      : thirds_at_vertices(loop.bare(), map.face, map.number_of_vertices, area_on_sphere);
  const double total = std::accumulate(result.begin(), result.end(), 0.);
  if(!(total > 0) || !std::isfinite(total))
    throw Input_error(Error_code::DEGENERATE_FACE, "the area of all faces is " + std::to_string(total));
  return result;
}

/// Takes the middle of its range out of every field, which keeps the digits of surfaces far from the origin.
CGAL_SP_INLINE std::vector<double> take_out_middles(Sampled_fields& fields)
{
  const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(fields.value.size()) / fields.number_of_fields;
  std::vector<double> middles;
  for(auto begin = fields.value.begin(); begin != fields.value.end(); begin += n) {
    const auto [low, high] = std::minmax_element(begin, begin + n);
    const double middle = *low / 2 + *high / 2;
    std::for_each(begin, begin + n, [middle](double& x) { x -= middle; });
    middles.push_back(middle);
  }
  return middles;
}

/// The harmonic of degree 0 is 1 / sqrt(4 pi).
CGAL_SP_INLINE void put_back(const std::vector<double>& middles, Harmonic_coefficients& coefficients)
{
  for(std::size_t field = 0; field < middles.size(); ++field)
    coefficients.field_begin(static_cast<int>(field))[0] += std::sqrt(4 * pi) * middles[field];
}

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

template <class Loop>
Harmonic_analysis analyze_vertices(const Loop& loop, Mapped_surface given, Sampled_fields fields, int degree,
                                   const Least_squares& method)
{
  const std::size_t n = given.image.size(), size = static_cast<std::size_t>(degree + 1);
  CGAL_SP_PRECONDITION(method.accuracy >= 0, "the accuracy of least squares must not be negative");
  CGAL_SP_PRECONDITION(method.iterations >= 0, "the number of iterations must not be negative");
  CGAL_SP_PRECONDITION(size * size <= n,
                       "least squares need (degree + 1)^2 vertices or more: take a smaller degree, or Integration");
  CGAL_SP_PRECONDITION(2 * degree <= largest_harmonic_degree, "the degree of least squares is at most 8191");
  constexpr double share_of_sums = 0.3;
  const Valid_map map = checked(loop, std::move(given), fields);
  loop.begin_stage(0, share_of_sums);
  Host_array<double> weights = vertex_weights(loop, map, method.weights);
  scale_to_one(weights.data(), weights.data() + n);
  const std::vector<double> middles = take_out_middles(fields);
  std::vector<int> exponent;
  for(int field = 0; field < fields.number_of_fields; ++field)
    exponent.push_back(scale_to_one(fields.value.data() + field * n, fields.value.data() + (field + 1) * n));
  const Normal_equations<Loop> equations(loop, map.image, fields, weights, degree);
  loop.begin_stage(share_of_sums, 1);
  Harmonic_analysis result = conjugate_gradients(loop, equations, method);
  for(int field = 0; field < fields.number_of_fields; ++field)
    for(int i = 0; i < result.coefficients.size(); ++i)
      result.coefficients.field_begin(field)[i] =
        std::ldexp(result.coefficients.field_begin(field)[i], exponent[static_cast<std::size_t>(field)]);
  put_back(middles, result.coefficients);
  return result;
}

template <class Loop>
Harmonic_analysis analyze_vertices(const Loop& loop, Mapped_surface given, Sampled_fields fields, int degree,
                                   const Integration& method)
{
  CGAL_SP_PRECONDITION(method.accuracy > 0, "the accuracy of a quadrature is positive");
  const Valid_map map = checked(loop, std::move(given), fields);
  constexpr int chunk = 1 << 14; // faces at a time: their points need memory
  constexpr int part = 256;      // faces on a thread at a time
  const int d = fields.number_of_fields;
  const std::vector<double> middles = take_out_middles(fields);
  const std::size_t vertices = map.image.size();
  const Face_quadrature<> quadrature(degree, method.accuracy);
  const Grid_transform<> transform(degree);
  Angular_grid grid = transform.grid(d);
  std::fill(grid.value.begin(), grid.value.end(), 0);
  struct Samples {
    std::vector<vec3> direction;
    std::vector<double> value; ///< of all fields, point after point
  };
  for(int begin = 0; begin < map.number_of_faces(); begin += chunk) {
    loop.advance(static_cast<double>(begin) / map.number_of_faces());
    const int faces = (std::min)(chunk, map.number_of_faces() - begin);
    const std::vector<Samples> parts = results_of_parts<part>(loop, faces, [&](int first, int last) {
      Samples samples;
      for(int f = begin + first; f < begin + last; ++f)
        quadrature.for_each_point(map.of_unit_image(f), [&](const Quadrature_point& point) {
          samples.direction.push_back(point.direction);
          for(int field = 0; field < d; ++field) {
            const double* const value = fields.value.data() + field * vertices;
            double mean = 0;
            for(int k = 0; k < 3; ++k)
              mean += point.barycentric[k] * value[map.face[f][k]];
            samples.value.push_back(point.weight * mean);
          }
        });
      return samples;
    });
    Host_array<vec3> direction;
    for(const Samples& samples : parts)
      direction.insert(direction.end(), samples.direction.begin(), samples.direction.end());
    Host_array<double> value(direction.size() * d);
    std::size_t i = 0;
    for(const Samples& samples : parts)
      for(std::size_t j = 0; j < samples.direction.size(); ++j, ++i)
        for(int field = 0; field < d; ++field)
          value[field * direction.size() + i] = samples.value[j * d + field];
    Scattered_points(loop, grid, direction).spread(loop, value.data(), grid);
  }
  Harmonic_analysis result;
  result.coefficients = Harmonic_coefficients(degree, d);
  transform.analyze(loop, grid, result.coefficients);
  put_back(middles, result.coefficients);
  return result;
}

template <class Loop>
Host_array<double> evaluate_harmonics(const Loop& loop, const Harmonic_coefficients& coefficients,
                                      const Host_array<vec3>& directions)
{
  constexpr int chunk = 1 << 18; // directions at a time: their kernels need memory
  const int d = coefficients.number_of_fields(), n = static_cast<int>(directions.size());
  Host_array<double> values(directions.size() * d);
  if(values.empty())
    return values;
  const Grid_transform<> transform(coefficients.degree());
  Angular_grid grid = transform.grid(d);
  transform.synthesize(loop, coefficients, grid);
  for(int begin = 0; begin < n; begin += chunk) {
    loop.advance(static_cast<double>(begin) / n);
    const int end = (std::min)(n, begin + chunk);
    const Host_array<vec3> some(directions.begin() + begin, directions.begin() + end);
    Host_array<double> result(some.size() * d);
    Scattered_points(loop, grid, some).interpolate(loop, grid, result.data());
    for(std::size_t i = 0; i < result.size(); ++i)
      values[(begin + i % some.size()) * d + i / some.size()] = result[i];
  }
  return values;
}

/// The northern half of a grid.
CGAL_SP_INLINE Legendre_transform legendre_transform(const Latitude_rows& grid, int degree)
{
  const int rows = static_cast<int>(grid.cos.size());
  std::vector<Latitude> north;
  for(int i = 0; 2 * i < rows; ++i)
    north.push_back({2 * i + 1 == rows ? 0 : grid.cos[i], grid.sin[i]});
  return Legendre_transform(degree, north, rows);
}

// Columns of a grid may be any number, fewer than twice the degree, too: frequencies m and m + columns are the same
// there. The Fourier transform is then one of a multiple of the columns.

/// A multiple of the columns, and of 4, that tells all frequencies up to the degree from each other.
CGAL_SP_INLINE int longitudes(const Latitude_rows& grid, int degree)
{
  int n = grid.columns;
  while(n % 4 != 0 || n < 2 * degree + 2)
    n += grid.columns;
  return n;
}

template <class Loop>
Host_array<double> synthesize_on_rows(const Loop& loop, const Harmonic_coefficients& coefficients,
                                      const Latitude_rows& grid)
{
  const int rows = static_cast<int>(grid.cos.size()), d = coefficients.number_of_fields();
  const int degree = coefficients.degree(), n = longitudes(grid, degree);
  Latitude_series series(degree + 1, d, rows);
  legendre_transform(grid, degree).synthesize(loop, coefficients, series);
  Host_array<double> values(static_cast<std::size_t>(d) * rows * grid.columns);
  for_each_range(loop, d * rows, [&](int begin, int end) {
    Fourier<> fourier;
    std::vector<std::complex<double>> spectrum(n / 2 + 1);
    std::vector<double> circle(n);
    for(int i = begin; i < end; ++i) {
      const int field = i / rows, row = i % rows;
      for(int m = 0; m <= degree; ++m)
        spectrum[m] = {(m == 0 ? 1 : 0.5) * series.column(m, 2 * field)[row],
                       m == 0 ? 0 : -0.5 * series.column(m, 2 * field + 1)[row]};
      fourier.backward(circle.data(), spectrum, n);
      for(int j = 0; j < grid.columns; ++j)
        values[static_cast<std::size_t>(i) * grid.columns + j] = circle[j * (n / grid.columns)];
    }
  });
  return values;
}

template <class Loop>
Harmonic_coefficients analyze_rows(const Loop& loop, const Latitude_rows& grid, const Sampled_fields& fields,
                                   int degree)
{
  const int rows = static_cast<int>(grid.cos.size()), d = fields.number_of_fields, n = longitudes(grid, degree);
  Latitude_series series(degree + 1, d, rows);
  for_each_range(loop, d * rows, [&](int begin, int end) {
    Fourier<> fourier;
    std::vector<std::complex<double>> spectrum;
    std::vector<double> circle(n);
    for(int i = begin; i < end; ++i) {
      const int field = i / rows, row = i % rows;
      for(int j = 0; j < grid.columns; ++j)
        circle[j * (n / grid.columns)] =
          grid.weight[row] * fields.value[static_cast<std::size_t>(i) * grid.columns + j];
      fourier.forward(spectrum, circle.data(), n);
      for(int m = 0; m <= degree; ++m) {
        series.column(m, 2 * field)[row] = spectrum[m].real();
        series.column(m, 2 * field + 1)[row] = -spectrum[m].imag();
      }
    }
  });
  Harmonic_coefficients result(degree, d);
  legendre_transform(grid, degree).analyze(loop, series, result);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_IMPL_H
