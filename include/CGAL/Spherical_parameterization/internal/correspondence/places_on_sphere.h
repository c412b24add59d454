// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_PLACES_ON_SPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_PLACES_ON_SPHERE_H

#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Rotations that cover all of them evenly: M. Alexa, "Super-Fibonacci spirals", CVPR 2022.
inline Matrix_3 super_fibonacci_rotation(int i, int number)
{
  constexpr double psi = 1.533751168755204288118041;
  const double s = i + 0.5, r = std::sqrt(s / number), other = std::sqrt(1 - s / number);
  const double alpha = 2 * pi * s / std::sqrt(2.), beta = 2 * pi * s / psi;
  return rotation_of_quaternion(
    {other * std::cos(beta), r * std::sin(alpha), r * std::cos(alpha), other * std::sin(beta)});
}

typedef std::vector<vec3> Places; ///< on the sphere

/// Moves places away from a centre, the more so the farther off they are, within reach.
inline Places moved_from(vec3 centre, double change, Places places)
{
  constexpr double reach = 0.6;
  for(vec3& p : places) {
    const vec3 d = sub(p, centre);
    p = unit(add_scaled(p, change * std::exp(-inner(d, d) / (2 * reach * reach)), d));
  }
  return places;
}

/// Places that keep orientation: all of them are rotated as anchors want it, and moved smoothly towards where these
/// belong. \param place, weight  of the anchors
inline Places turned(Places places, const Places& anchor, const Places& place, const std::vector<double>& weight,
                     double width)
{
  Places weighted, from;
  for(std::size_t k = 0; k < anchor.size(); ++k)
    weighted.push_back(scale(weight[k], anchor[k]));
  const Matrix_3 rotation = best_rotation(weighted, place);
  for(const vec3& p : anchor)
    from.push_back(rotated(rotation, p));
  for(vec3& p : places) {
    p = rotated(rotation, p);
    vec3 d = {0, 0, 0};
    double sum = 0;
    for(std::size_t k = 0; k < anchor.size(); ++k) {
      const double w = std::exp((inner(p, from[k]) - 1) / (width * width)) * weight[k];
      d = add_scaled(d, w, sub(place[k], from[k]));
      sum += w;
    }
    p = unit(add_scaled(p, sum > 0 ? 1 / sum : 0, d));
  }
  return places;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_PLACES_ON_SPHERE_H
