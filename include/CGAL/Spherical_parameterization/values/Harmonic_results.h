// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_RESULTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_RESULTS_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/Rotation.h>

#include <array>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// The result of `harmonic_analysis()`.
struct Harmonic_analysis {
  Harmonic_coefficients coefficients; ///< of the data
  bool has_converged = true; ///< whether the gradient of least squares, at these coefficients, is within the accuracy
  int iterations = 0;        ///< of least squares
};

/// The shape up to degree 1, an ellipsoid: the points centre + axes^T diag(radii) sphere_axes x for unit vectors
/// x.
struct First_order_ellipsoid {
  std::array<double, 3> centre; ///< mean over the sphere
  std::array<double, 3> radii;  ///< largest first; the last one is negative if the map mirrors the shape
  Rotation axes;                ///< rows: the directions of the half axes in space
  Rotation sphere_axes;         ///< rows: the directions on the sphere that are mapped there
};

/// The alignment of a shape g with another one, f: space g(sphere^-1 x) is most similar to f(x).
struct Shape_alignment {
  Rotation space;     ///< rotates the shape
  Rotation sphere;    ///< rotates its map
  double correlation; ///< of f and the moved g, from -1 to 1, with both centres (degree 0) at the origin
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_RESULTS_H
