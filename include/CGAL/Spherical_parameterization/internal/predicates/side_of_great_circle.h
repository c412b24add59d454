// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SIDE_OF_GREAT_CIRCLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SIDE_OF_GREAT_CIRCLE_H

#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// det(a, b, q) and a bound of its rounding error.
///
/// It is taken as a . ((b - a) x (q - a)): in a limb that is far smaller than the unit the differences are all but
/// exact, and the bound is relative to them, where a bound for the plain determinant (and for its interval arithmetic)
/// fails.
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

/// On which side of the oriented great circle from a to b the direction q is: 1 left, 0 on it, -1 right. Exact.
inline int side_of_great_circle(vec3 a, vec3 b, vec3 q)
{
  const Determinant determinant(a, b, q);
  if(determinant.value > determinant.error)
    return 1;
  if(determinant.value < -determinant.error)
    return -1;
  if(is_equal(q, a) || is_equal(q, b) || is_equal(a, b)) // frequent, and else nothing but exact arithmetic would help
    return 0;
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  const auto point = [](vec3 p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return static_cast<int>(Kernel().orientation_3_object()(Kernel::Point_3(0, 0, 0), point(a), point(b), point(q)));
}

/// Weights (non-negative, sum 1) for which the weighted mean of the corners v has the direction q, each exact to 1e-12.
/// \pre q is in the cone of v, which is positively oriented
inline std::array<double, 3> barycentric_coordinates(const std::array<vec3, 3>& v, vec3 q)
{
  std::array<double, 3> w;
  for(int k = 0; k < 3; ++k)
    if(is_equal(q, v[k])) {
      w = {0, 0, 0};
      w[k] = 1;
      return w;
    }
  double sum = 0, error = 0;
  for(int k = 0; k < 3; ++k) {
    const Determinant determinant(v[(k + 1) % 3], v[(k + 2) % 3], q);
    w[k] = (std::max)(determinant.value, 0.);
    sum += w[k];
    error += determinant.error;
  }
  if(error > 1e-13 * sum) { // slivers
    typedef CGAL::Exact_rational FT;
    std::array<FT, 3> exact;
    for(int k = 0; k < 3; ++k) {
      const vec3 a = v[(k + 1) % 3], b = v[(k + 2) % 3];
      exact[k] = FT(q.x) * (FT(a.y) * FT(b.z) - FT(a.z) * FT(b.y)) + FT(q.y) * (FT(a.z) * FT(b.x) - FT(a.x) * FT(b.z)) +
                 FT(q.z) * (FT(a.x) * FT(b.y) - FT(a.y) * FT(b.x));
    }
    const FT total = exact[0] + exact[1] + exact[2];
    for(int k = 0; k < 3; ++k)
      w[k] = (std::max)(CGAL::to_double(FT(exact[k] / total)), 0.); // q may be rounded
    sum = w[0] + w[1] + w[2];
  }
  return {w[0] / sum, w[1] / sum, w[2] / sum};
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SIDE_OF_GREAT_CIRCLE_H
