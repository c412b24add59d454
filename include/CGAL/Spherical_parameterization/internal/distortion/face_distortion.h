// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_DISTORTION_H

#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace CGAL::Spherical_parameterization::internal {

inline double flat_area(const std::array<vec3, 3>& p)
{
  const vec3 n = outer(sub(p[1], p[0]), sub(p[2], p[0]));
  return std::sqrt(inner(n, n)) / 2;
}

/// Half of det(a, b, c): the area of the flat triangle times the distance of its plane from the origin, with sign.
inline double half_determinant(const std::array<vec3, 3>& v) { return Determinant(v[0], v[1], v[2]).value / 2; }

/// The angle at o between the great circles through a and b.
inline double spherical_angle(vec3 o, vec3 a, vec3 b)
{
  const vec3 u = tangent(sub(a, o), o), w = tangent(sub(b, o), o);
  const vec3 n = outer(u, w);
  return std::atan2(std::sqrt(inner(n, n)), inner(u, w));
}

inline double flat_angle(vec3 o, vec3 a, vec3 b)
{
  const vec3 u = sub(a, o), w = sub(b, o);
  const vec3 n = outer(u, w);
  return std::atan2(std::sqrt(inner(n, n)), inner(u, w));
}

/// Mean over the corners of |angle on the sphere - angle in the source|, in radians.
inline double angle_distortion(const std::array<vec3, 3>& p, const std::array<vec3, 3>& v)
{
  double sum = 0;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum += std::abs(spherical_angle(v[i], v[j], v[k]) - flat_angle(p[i], p[j], p[k]));
  }
  return sum / 3;
}

/// sigma_1^2 + sigma_2^2 of the affine map from one flat triangle to another: its Dirichlet energy by the cotangent
/// formula, over the area. Infinite if the source triangle has no area.
inline double squared_singular_values(const std::array<vec3, 3>& p, const std::array<vec3, 3>& v)
{
  const double area = flat_area(p);
  if(!(area > 0))
    return std::numeric_limits<double>::infinity();
  double sum = 0;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const vec3 opposite = sub(v[k], v[j]);
    sum += inner(sub(p[j], p[i]), sub(p[k], p[i])) * inner(opposite, opposite);
  }
  return (std::max)(0., sum / (4 * area * area));
}

/// sigma_1 / sigma_2 >= 1, from (sigma_1^2 + sigma_2^2) / (sigma_1 sigma_2).
inline double ratio_of_singular_values(double squared_sum, double product)
{
  if(!(product > 0) || !std::isfinite(squared_sum))
    return std::numeric_limits<double>::infinity();
  const double half = (std::max)(1., squared_sum / product / 2);
  return half + std::sqrt((half - 1) * (half + 1));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_FACE_DISTORTION_H
