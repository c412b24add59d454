// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_IMPL_H

#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/face_quadrature.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/fourier.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/grids.h>

#include <algorithm>

namespace CGAL::Spherical_parameterization::internal {

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

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_IMPL_H
