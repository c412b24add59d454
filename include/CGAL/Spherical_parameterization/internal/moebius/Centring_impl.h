// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_CENTRING_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_CENTRING_IMPL_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>
#include <CGAL/Spherical_parameterization/internal/moebius/Centring.h>
#include <CGAL/Spherical_parameterization/internal/moebius/moebius.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_CORE Centring::Centring(const Host_loop& loop, const Host_array<double>& mass, Host_array<vec3> v)
{
  constexpr int maximum_steps = 100;
  constexpr double tolerance = 1e-13;
  const Host_backend<Host_loop> backend(loop);
  Moments moments = backend.moments(mass, v);
  Host_array<vec3> scratch(v.size());
  centre_ = balance(backend, mass, tolerance, maximum_steps, v, scratch, moments);
  distance_ = norm(first_moment(moments)) / total_mass(moments);
}

CGAL_SP_CORE vec3 Centring::operator()(vec3 p) const
{
  for(const vec3& c : centre_)
    p = boost(p, c);
  return p;
}

CGAL_SP_CORE vec3 Centring::inverse(vec3 p) const
{
  for(std::size_t k = centre_.size(); k-- > 0;)
    p = boost(p, scale(-1, centre_[k]));
  return p;
}

CGAL_SP_CORE double centre_by_mass(const Host_array<double>& mass, Host_array<vec3>& image)
{
  double largest = 0;
  for(std::size_t i = 0; i < image.size(); ++i) {
    image[i] = scaled_to_unit_box(image[i]);
    if(const double square = inner(image[i], image[i]); !(square > 0) || !std::isfinite(square))
      throw Input_error(Error_code::NON_FINITE_COORDINATE, "no direction at vertex " + std::to_string(i));
    if(!(mass[i] >= 0) || !std::isfinite(mass[i]))
      throw Input_error(Error_code::BAD_WEIGHT, "the mass of vertex " + std::to_string(i));
    image[i] = unit(image[i]);
    largest = (std::max)(largest, mass[i]);
  }
  if(largest == 0)
    throw Input_error(Error_code::BAD_WEIGHT, "there is no mass");
  const int exponent = std::ilogb(largest);
  Host_array<double> in_unit = mass; // by a power of 2, so that sums and squares neither overflow nor vanish
  for(double& m : in_unit)
    m = std::scalbn(m, -exponent);
  const Centring centring(Host_loop(), in_unit, image);
  for(vec3& p : image)
    p = centring(p);
  return centring.distance();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_CENTRING_IMPL_H
