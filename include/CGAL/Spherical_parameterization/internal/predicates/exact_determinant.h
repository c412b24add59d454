// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>

#include <array>

namespace CGAL::Spherical_parameterization::internal {

/// The sign of det(a, b, c) in exact arithmetic: no rounding, no overflow, no underflow, no rounding mode.
/// \pre all coordinates are finite
CGAL_SP_CORE int sign_of_exact_determinant(vec3 a, vec3 b, vec3 c);

/// The determinants det(v_1, v_2, q), det(v_2, v_0, q), det(v_0, v_1, q), each taken as 0 where it is negative, over
/// the sum of all three, to a few units in the last place. \pre all coordinates are finite, and the exact sum is not 0
CGAL_SP_CORE std::array<double, 3> exact_barycentric_coordinates(const std::array<vec3, 3>& v, vec3 q);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/predicates/exact_determinant_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_H
