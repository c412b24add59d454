// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/harmonics_methods.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Mapped_faces.h>

#include <array>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Functions on the sphere at some points: field after field.
struct Sampled_fields {
  int number_of_fields = 0;
  Host_array<double> value;
};

/// How a fit went.
struct Fit {
  Harmonic_coefficients coefficients;
  bool has_converged = true;
  int iterations = 0;
};

/// Least squares with a weight for every point, none of them negative.
template <class Loop>
Fit fit_harmonics(const Loop& loop, const Host_array<vec3>& directions, const Sampled_fields& fields,
                  const Host_array<double>& weights, int degree, const Least_squares& method);

/// Integrals over the faces of the sphere of fields that are linear on them. `weights` is not used.
template <class Loop>
Harmonic_coefficients integrate_harmonics(const Loop& loop, const Mapped_faces& map, const Sampled_fields& fields,
                                          int degree, double accuracy);

/// The values of the functions, field after field. \param directions  of any length but 0
template <class Loop>
Host_array<double> evaluate_harmonics(const Loop& loop, const Harmonic_coefficients& coefficients,
                                      const Host_array<vec3>& directions);

/// A grid of circles of latitude, from the north pole to the south pole and symmetric to the equator, with equidistant
/// longitudes from 0 on.
struct Latitude_rows {
  std::vector<double> cos, sin; ///< of the angle of every row from the north pole
  std::vector<double> weight;   ///< of the quadrature, with the longitudes: their sum times the columns is 4 pi
  int columns;
};

/// The zeros of the Legendre polynomial of this number of rows (C. F. Gauss, 1814), and so many columns or a few more,
/// of a number that Fourier transforms like.
Latitude_rows gauss_legendre_rows(int rows, int columns);
/// Equidistant rows with both poles (C. Clenshaw, A. Curtis, 1960).
Latitude_rows equidistant_rows(int rows, int columns);

/// The functions on a grid: field after field, row after row.
template <class Loop>
Host_array<double> synthesize_on_rows(const Loop& loop, const Harmonic_coefficients& coefficients,
                                      const Latitude_rows& grid);

/// The quadrature of the grid.
template <class Loop>
Harmonic_coefficients analyze_rows(const Loop& loop, const Latitude_rows& grid, const Sampled_fields& fields,
                                   int degree);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ANALYSIS_H
