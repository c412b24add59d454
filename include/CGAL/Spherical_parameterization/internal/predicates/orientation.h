// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_ORIENTATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_ORIENTATION_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>

#include <array>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// The sign of det(a, b, c) in exact arithmetic: no rounding, no overflow, no underflow, no rounding mode.
/// \pre all coordinates are finite
CGAL_SP_CORE int sign_of_exact_determinant(vec3 a, vec3 b, vec3 c);

/// det(a, b, c) to a few units in the last place, 0 if it is below the range of doubles. \pre all coordinates are
/// finite
CGAL_SP_CORE double exact_determinant(vec3 a, vec3 b, vec3 c);

/// The determinants det(v_1, v_2, q), det(v_2, v_0, q), det(v_0, v_1, q), each taken as 0 where it is negative, over
/// the sum of all three, to a few units in the last place. \pre all coordinates are finite, and the exact sum is not 0
CGAL_SP_CORE std::array<double, 3> exact_barycentric_coordinates(const std::array<vec3, 3>& v, vec3 q);

/// det(a, b, q) in doubles, and a bound of its error.
///
/// The determinant is taken as a . ((b - a) x (q - a)): for unit vectors this is accurate in proportion to the size of
/// the triangle, so that a small triangle is decided as easily as a large one.
struct Determinant {
  double value, error;

  Determinant(vec3 a, vec3 b, vec3 q)
  {
    const vec3 d = sub(b, a), e = sub(q, a);
    value = inner(a, outer(d, e));
    const double magnitude = std::abs(a.x) * (std::abs(d.y * e.z) + std::abs(d.z * e.y)) +
                             std::abs(a.y) * (std::abs(d.z * e.x) + std::abs(d.x * e.z)) +
                             std::abs(a.z) * (std::abs(d.x * e.y) + std::abs(d.y * e.x));
    // Each term is seven roundings away from its exact value, and so is the magnitude: 8 units of 2^-53 would do.
    // Where products may have underflowed, nothing is certain.
    error = magnitude > 1e-280 ? 1e-15 * magnitude : 1;
  }
};

inline bool is_equal(vec3 a, vec3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

inline bool is_finite(vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }

/// The sign of det(a, b, q), exactly: 1 if q is on the left of the great circle from a to b, that is if the spherical
/// triangle (a, b, q) is counterclockwise as seen from outside; -1 if it is on the right; 0 if it is on the circle.
///
/// \pre all coordinates are finite
inline int orientation(vec3 a, vec3 b, vec3 q)
{
  const Determinant determinant(a, b, q);
  if(determinant.value > determinant.error)
    return 1;
  if(determinant.value < -determinant.error)
    return -1;
  if(is_equal(q, a) || is_equal(q, b) || is_equal(a, b)) // frequent, and only exact arithmetic would help otherwise
    return 0;
  return sign_of_exact_determinant(a, b, q);
}

inline bool is_positively_oriented(vec3 a, vec3 b, vec3 c) { return orientation(a, b, c) > 0; }

/// det(a, b, c) to 1e-6 of its value, however near the corners are to one great circle; not finite if a coordinate is
/// not.
inline double accurate_determinant(vec3 a, vec3 b, vec3 c)
{
  const Determinant determinant(a, b, c);
  const bool is_certain =
    !(std::abs(determinant.value) <= 1e6 * determinant.error) || !std::isfinite(determinant.error);
  return is_certain ? determinant.value : exact_determinant(a, b, c);
}

/// Signed area of the spherical triangle (a, b, c) of unit vectors, positive if it is seen counter-clockwise from
/// outside; in (-2 pi, 2 pi). Triangles far below the resolution of the coordinates keep a meaningful size.
inline double spherical_area(vec3 a, vec3 b, vec3 c)
{
  const double volume = accurate_determinant(a, b, c);
  const double denominator = 1 + inner(a, b) + inner(b, c) + inner(c, a);
  const double tangent = volume / denominator;
  if(denominator > 0 && std::abs(tangent) < 1e-3) // small triangles are many, and two terms are exact to 1e-12
    return 2 * (tangent - tangent * tangent * tangent / 3);
  return 2 * std::atan2(volume, denominator);
}

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/predicates/orientation_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_ORIENTATION_H
