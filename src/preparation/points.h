// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_POINTS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_POINTS_H

#include "input/mesh_readers.h"
#include "preparation/glued_surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace tool {

inline std::size_t place(int i) { return static_cast<std::size_t>(i); }

using Vector = Glued_surface::Point;

inline Vector minus(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double norm(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }

inline bool is_finite(const Vector& p) { return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]); }

/// Of finite points.
inline double largest_coordinate(const std::vector<Vector>& points)
{
  double largest = 0;
  for(const Vector& p : points)
    if(is_finite(p))
      largest = std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return largest;
}

/// A unit in which the squares of coordinates, of which this is the largest, are numbers. A power of 2: nothing is
/// rounded.
inline double unit_of(double largest_coordinate)
{
  return largest_coordinate > 0 ? std::ldexp(1., std::ilogb(largest_coordinate)) : 1;
}

/// The diagonal of the bounding box of the finite vertices that have faces.
inline double diagonal(const Soup& soup)
{
  constexpr double largest = std::numeric_limits<double>::infinity();
  Vector low = {largest, largest, largest}, high = {-largest, -largest, -largest};
  for(const auto& triangle : soup.triangles)
    for(const int v : triangle)
      if(const Vector& p = soup.points[place(v)]; is_finite(p))
        for(std::size_t k = 0; k < 3; ++k) {
          low[k] = std::min(low[k], p[k]);
          high[k] = std::max(high[k], p[k]);
        }
  return soup.triangles.empty() ? 0 : norm(minus(high, low));
}

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_POINTS_H
