// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_MOMENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_MOMENTS_H

#include <array>

namespace CGAL::Spherical_parameterization::internal {

/// The sums that decide about balance: s = sum m_i v_i and S = sum m_i v_i v_i^T (xx, xy, xz, yy, yz, zz).
struct Moments {
  std::array<double, 3> first{};
  std::array<double, 6> second{};
};

/// From the nine sums of add_moments().
inline Moments to_moments(const std::array<double, 9>& s)
{
  return {{s[0], s[1], s[2]}, {s[3], s[4], s[5], s[6], s[7], s[8]}};
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_MOMENTS_H
