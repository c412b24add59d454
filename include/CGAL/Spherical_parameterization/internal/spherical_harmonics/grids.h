// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <cmath>
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

/// The zeros of the Legendre polynomial of this number of rows (C. F. Gauss, 1814), and so many columns or a few more,
/// of a number that Fourier transforms like.
CGAL_SP_CORE Latitude_rows gauss_legendre_rows(int rows, int columns);
/// Twice as fine as functions of this degree ask for: of what is sampled there, details alias less.
CGAL_SP_INLINE Latitude_rows grid_to_sample(int degree) { return gauss_legendre_rows(2 * degree + 2, 4 * degree + 4); }
/// Equidistant rows with both poles (C. Clenshaw, A. Curtis, 1960).
CGAL_SP_CORE Latitude_rows equidistant_rows(int rows, int columns);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/grids_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_GRIDS_H
