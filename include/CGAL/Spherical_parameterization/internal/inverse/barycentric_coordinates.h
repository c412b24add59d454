// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INVERSE_BARYCENTRIC_COORDINATES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INVERSE_BARYCENTRIC_COORDINATES_H

#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <algorithm>
#include <array>

namespace CGAL::Spherical_parameterization::internal {

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
    w = exact_barycentric_coordinates(v, q);
    sum = w[0] + w[1] + w[2];
  }
  return {w[0] / sum, w[1] / sum, w[2] / sum};
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INVERSE_BARYCENTRIC_COORDINATES_H
