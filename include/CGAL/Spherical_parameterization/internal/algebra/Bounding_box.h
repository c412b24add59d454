// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_BOUNDING_BOX_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_BOUNDING_BOX_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <algorithm>
#include <limits>

namespace CGAL::Spherical_parameterization::internal {

/// The smallest box that holds some points. Halves are taken before sums and differences, which may overflow.
struct Bounding_box {
  vec3 low = {infinity, infinity, infinity};
  vec3 high = {-infinity, -infinity, -infinity};

  template <class Points>
  explicit Bounding_box(const Points& points)
  {
    for(const vec3& p : points) {
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
    }
  }

  vec3 centre() const { return {low.x / 2 + high.x / 2, low.y / 2 + high.y / 2, low.z / 2 + high.z / 2}; }

  /// Of the longest side; 1 for a single point: what coordinates can be divided by.
  double half_size() const
  {
    const double half = (std::max)({high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2});
    return half > 0 ? half : 1;
  }

private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_BOUNDING_BOX_H
