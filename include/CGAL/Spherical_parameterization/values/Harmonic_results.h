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

/// What `harmonic_analysis()` has found.
struct Harmonic_analysis {
  Harmonic_coefficients coefficients; ///< of the data
  bool has_converged = true; ///< whether the gradient of least squares, at these coefficients, is within the accuracy
  int iterations = 0;        ///< of least squares
};

/// The ellipsoid that a shape is up to degree 1: the points centre + axes^T diag(radii) sphere_axes x of the unit
/// vectors x.
struct First_order_ellipsoid {
  std::array<double, 3> centre; ///< mean over the sphere
  std::array<double, 3> radii;  ///< largest first; the last one is negative if the map mirrors the shape
  Rotation axes;                ///< rows: the directions of the half axes in space
  Rotation sphere_axes;         ///< rows: the directions on the sphere that are mapped there
};

/// How a shape g is brought to another one, f: space g(sphere^-1 x) is most like f(x).
struct Shape_alignment {
  Rotation space;     ///< turns the shape
  Rotation sphere;    ///< turns its map
  double correlation; ///< of f and the moved g, from -1 to 1, with both centres (degree 0) at the origin
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_HARMONIC_RESULTS_H
