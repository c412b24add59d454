// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SPHERICAL_AREA_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SPHERICAL_AREA_H

#include <CGAL/Spherical_parameterization/internal/base/vec3.h>

#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// Signed area of the spherical triangle (a, b, c) of unit vectors, positive if it is seen counter-clockwise from
/// outside; in (-2 pi, 2 pi). Triangles far below the resolution of the coordinates keep a meaningful size.
inline double spherical_area(vec3 a, vec3 b, vec3 c)
{
  const double volume = inner(a, outer(sub(b, a), sub(c, a)));
  const double denominator = 1 + inner(a, b) + inner(b, c) + inner(c, a);
  const double tangent = volume / denominator;
  if(denominator > 0 && std::abs(tangent) < 1e-3) // small triangles are many, and two terms are exact to 1e-12
    return 2 * (tangent - tangent * tangent * tangent / 3);
  return 2 * std::atan2(volume, denominator);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SPHERICAL_AREA_H
