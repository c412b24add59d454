// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_PLANE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_PLANE_H

#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// A point or vector of the plane.
struct vec2 {
  double x, y;
};
inline vec2 add(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline vec2 sub(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline vec2 scale(double s, vec2 a) { return {s * a.x, s * a.y}; }
inline double inner(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
inline double distance(vec2 a, vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_PLANE_H
