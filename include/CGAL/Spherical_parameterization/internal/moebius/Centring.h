// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_CENTRING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_CENTRING_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The Moebius transformation without rotation (boosts of the ball) that brings the centroid of masses on the sphere to
/// the centre. There is exactly one, up to rotation, unless half of the mass or more is in one point. A. Baden,
/// K. Crane, M. Kazhdan, "Moebius registration", SGP 2018.
class Centring {
public:
  /// \param mass  not negative, with a positive sum
  /// \param v     unit vectors
  CGAL_SP_CORE Centring(const Host_loop& loop, const Host_array<double>& mass, Host_array<vec3> v);

  /// Of the centroid from the centre, in the end
  double distance() const { return distance_; }

  CGAL_SP_CORE vec3 operator()(vec3 p) const;
  CGAL_SP_CORE vec3 inverse(vec3 p) const;

private:
  std::vector<vec3> centre_; ///< of the boosts, one after the other
  double distance_ = 0;
};

/// Moves vectors of any length but 0 to the sphere, and centres them. Returns the distance of the centroid. Throws
/// Error for what is no direction, and for masses that are none.
CGAL_SP_CORE double centre_by_mass(const Host_array<double>& mass, Host_array<vec3>& image);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/moebius/Centring_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_CENTRING_H
