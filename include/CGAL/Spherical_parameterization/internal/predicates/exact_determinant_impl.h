// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_IMPL_H

#include <CGAL/Spherical_parameterization/internal/predicates/exact_determinant.h>

#include <CGAL/MP_Float.h>
#include <CGAL/Quotient.h>

namespace CGAL::Spherical_parameterization::internal {

// MP_Float is the exact number that costs least: Boost's integers are seven times as much text to compile.
inline MP_Float exact_determinant(vec3 a, vec3 b, vec3 c)
{
  const auto minor = [](double p, double q, double r, double s) {
    return MP_Float(p) * MP_Float(s) - MP_Float(q) * MP_Float(r);
  };
  return MP_Float(a.x) * minor(b.y, b.z, c.y, c.z) + MP_Float(a.y) * minor(b.z, b.x, c.z, c.x) +
         MP_Float(a.z) * minor(b.x, b.y, c.x, c.y);
}

CGAL_SP_CORE int sign_of_exact_determinant(vec3 a, vec3 b, vec3 c) { return exact_determinant(a, b, c).sign(); }

CGAL_SP_CORE std::array<double, 3> exact_barycentric_coordinates(const std::array<vec3, 3>& v, vec3 q)
{
  std::array<MP_Float, 3> exact;
  for(int k = 0; k < 3; ++k)
    exact[k] = exact_determinant(v[(k + 1) % 3], v[(k + 2) % 3], q);
  const MP_Float total = exact[0] + exact[1] + exact[2];
  std::array<double, 3> result = {0, 0, 0};
  for(int k = 0; k < 3; ++k)
    if(exact[k] > 0 && total > 0)
      result[k] = to_double(Quotient<MP_Float>(exact[k], total));
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_IMPL_H
