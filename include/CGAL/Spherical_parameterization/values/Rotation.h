// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ROTATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ROTATION_H

#include <array>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationInverse
/// A rotation by its rows, orthonormal, determinant 1.
typedef std::array<std::array<double, 3>, 3> Rotation;

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_ROTATION_H
