// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>

#include <array>

namespace CGAL::Spherical_parameterization::internal {

/// centre + axes^T diag(radii) sphere_axes x
struct Ellipsoid {
  std::array<double, 3> centre, radii;
  Matrix_3 axes, sphere_axes; ///< by rows
};

/// What the degrees 0 and 1 of three functions are.
Ellipsoid ellipsoid_of(const Harmonic_coefficients& shape);

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/ellipsoid_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_H
