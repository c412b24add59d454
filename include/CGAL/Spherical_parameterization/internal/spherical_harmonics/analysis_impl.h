// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_IMPL_H

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/Grid_transform.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/Legendre_transform.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/Scattered_points.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/face_quadrature.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/fourier.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/least_squares.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

template <class Loop>
Fit fit_harmonics(const Loop& loop, const Host_array<vec3>& directions, const Sampled_fields& fields,
                  const Host_array<double>& weights, int degree, const Least_squares& method)
{
  return conjugate_gradients(Normal_equations<Loop>(loop, directions, fields, weights, degree), method);
}

template <class Loop>
Harmonic_coefficients integrate_harmonics(const Loop& loop, const Mapped_faces& map, const Sampled_fields& fields,
                                          int degree, double accuracy)
{
  constexpr int chunk = 1 << 14; // faces at a time: their points need memory
  constexpr int part = 256;      // faces on a thread at a time
  const int d = fields.number_of_fields;
  const std::size_t vertices = map.image.size();
  const Face_quadrature quadrature(degree, accuracy);
  const Grid_transform transform(degree);
  Angular_grid grid = transform.grid(d);
  std::fill(grid.value.begin(), grid.value.end(), 0);
  struct Samples {
    std::vector<vec3> direction;
    std::vector<double> value; ///< of all fields, point after point
  };
  for(int begin = 0; begin < map.number_of_faces(); begin += chunk) {
    const int faces = (std::min)(chunk, map.number_of_faces() - begin);
    const std::vector<Samples> parts = results_of_parts<part>(loop, faces, [&](int first, int last) {
      Samples samples;
      for(int f = begin + first; f < begin + last; ++f)
        quadrature.for_each_point(map.on_sphere(f), [&](const Quadrature_point& point) {
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
  Harmonic_coefficients result(degree, d);
  transform.analyze(loop, grid, result);
  return result;
}

template <class Loop>
Host_array<double> evaluate_harmonics(const Loop& loop, const Harmonic_coefficients& coefficients,
                                      const Host_array<vec3>& directions)
{
  constexpr int chunk = 1 << 18; // directions at a time: their kernels need memory
  const int d = coefficients.number_of_fields(), n = static_cast<int>(directions.size());
  Host_array<double> values(directions.size() * d);
  const Grid_transform transform(coefficients.degree());
  Angular_grid grid = transform.grid(d);
  transform.synthesize(loop, coefficients, grid);
  for(int begin = 0; begin < n; begin += chunk) {
    const int end = (std::min)(n, begin + chunk);
    const Host_array<vec3> some(directions.begin() + begin, directions.begin() + end);
    Host_array<double> result(some.size() * d);
    Scattered_points(loop, grid, some).interpolate(loop, grid, result.data());
    for(int field = 0; field < d; ++field)
      std::copy_n(result.data() + field * some.size(), some.size(), values.data() + field * directions.size() + begin);
  }
  return values;
}

CGAL_SP_CORE Latitude_rows gauss_legendre_rows(int rows, int columns)
{
  Latitude_rows grid;
  grid.columns = fourier_size(columns);
  const auto rule = gauss_rule(rows);
  for(auto row = rule.rbegin(); row != rule.rend(); ++row) {
    grid.cos.push_back(row->first);
    grid.sin.push_back(std::sqrt((1 - row->first) * (1 + row->first)));
    grid.weight.push_back(row->second * 2 * pi / grid.columns);
  }
  return grid;
}

CGAL_SP_CORE Latitude_rows equidistant_rows(int rows, int columns)
{
  Latitude_rows grid;
  grid.columns = columns;
  const int n = rows - 1;
  for(int i = 0; i <= n; ++i) {
    grid.cos.push_back(std::sin(pi * (n - 2 * i) / (2 * n)));
    grid.sin.push_back(std::sin(pi * (std::min)(i, n - i) / n));
    double sum = 1;
    for(int k = 1; k <= n / 2; ++k)
      sum -= (2 * k == n ? 1 : 2) * std::cos(2 * pi * k * i / n) / (4. * k * k - 1);
    grid.weight.push_back((i == 0 || i == n ? 1 : 2) * sum / n * 2 * pi / columns);
  }
  return grid;
}

/// The northern half of a grid.
inline Legendre_transform legendre_transform(const Latitude_rows& grid, int degree)
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
inline int longitudes(const Latitude_rows& grid, int degree)
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
    Fourier fourier;
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
    Fourier fourier;
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
