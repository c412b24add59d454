// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A grid of circles of latitude, from the north pole to the south pole and symmetric to the equator, with equidistant
/// longitudes from 0 on.
struct Latitude_rows {
  std::vector<double> cos, sin; ///< of the angle of every row from the north pole
  std::vector<double> weight;   ///< of the quadrature, with the longitudes: their sum times the columns is 4 pi
  int columns;

  vec3 direction(int row, int column) const
  {
    const double longitude = 2 * pi * column / columns;
    return {sin[row] * std::cos(longitude), sin[row] * std::sin(longitude), cos[row]};
  }

  /// Of all points, row after row.
  Host_array<vec3> directions() const
  {
    Host_array<vec3> result;
    for(int row = 0; row < static_cast<int>(cos.size()); ++row)
      for(int column = 0; column < columns; ++column)
        result.push_back(direction(row, column));
    return result;
  }
};

/// The Legendre polynomial of degree n and its derivative, for x in (-1, 1).
inline std::pair<double, double> legendre_polynomial(int n, double x)
{
  double value = 1, before = 0; // of degrees k and k - 1
  for(int k = 0; k < n; ++k)
    before = std::exchange(value, ((2 * k + 1) * x * value - k * before) / (k + 1));
  return {value, n * (before - x * value) / ((1 - x) * (1 + x))};
}

/// The Gauss rule of n points on [-1, 1]: positions, increasing, and weights.
CGAL_SP_INLINE std::vector<std::pair<double, double>> gauss_rule(int n)
{
  std::vector<std::pair<double, double>> rule(n);
  for(int i = 0; i < (n + 1) / 2; ++i) {
    double x = 2 * i + 1 == n ? 0 : std::cos(pi * (i + 0.75) / (n + 0.5)); // near a zero, by F. Tricomi
    for(int step = 0; step < 4; ++step) {                                  // of Newton's method: 2, 4, 8, 16 digits
      const auto [value, slope] = legendre_polynomial(n, x);
      x -= value / slope;
    }
    const double slope = legendre_polynomial(n, x).second;
    const double weight = 2 / ((1 - x) * (1 + x) * slope * slope);
    rule[i] = {-x, weight};
    rule[n - 1 - i] = {x, weight};
  }
  return rule;
}

/// The least multiple of 4 that is not less than n and has no prime factor above 5: Fourier transforms like it.
CGAL_SP_INLINE int fourier_size(int n)
{
  for(int size = n + (4 - n % 4) % 4;; size += 4) {
    int rest = size;
    for(int p : {2, 3, 5})
      while(rest % p == 0)
        rest /= p;
    if(rest == 1)
      return size;
  }
}

/// The zeros of the Legendre polynomial of this number of rows (C. F. Gauss, 1814), and so many columns or a few more,
/// of a number that Fourier transforms like.
CGAL_SP_INLINE Latitude_rows gauss_legendre_rows(int rows, int columns)
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

/// Twice as fine as functions of this degree ask for: of what is sampled there, details alias less.
CGAL_SP_INLINE Latitude_rows grid_to_sample(int degree) { return gauss_legendre_rows(2 * degree + 2, 4 * degree + 4); }

/// Equidistant rows with both poles (C. Clenshaw, A. Curtis, 1960).
CGAL_SP_INLINE Latitude_rows equidistant_rows(int rows, int columns)
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

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_H
