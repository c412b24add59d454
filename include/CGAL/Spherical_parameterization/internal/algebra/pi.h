// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_PI_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_PI_H

namespace CGAL::Spherical_parameterization::internal {

constexpr double pi = 3.14159265358979323846;

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_PI_H
