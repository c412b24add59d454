// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#pragma once

#include <CGAL/Spherical_parameterization/preparation/glued_surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL::Spherical_parameterization::preparation {

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

inline bool has_finite_corners(const Triangle_soup& soup, const Triangle_soup::Triangle& t)
{
  return std::all_of(t.begin(), t.end(), [&soup](int v) { return is_finite(soup.points[place(v)]); });
}

/// Whether it is one to begin with, not a line or a point.
inline bool is_face(const Triangle_soup& soup, const Triangle_soup::Triangle& t)
{
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && has_finite_corners(soup, t);
}

/// Of finite points.
template <class Points>
double largest_coordinate(const Points& points)
{
  double largest = 0;
  for(const Vector& p : points)
    if(is_finite(p))
      largest = std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return largest;
}

/// Of the corners of faces: other points may be anywhere.
inline double largest_coordinate(const Triangle_soup& soup)
{
  double largest = 0;
  for(const auto& t : soup.triangles)
    if(is_face(soup, t))
      largest =
        std::max(largest, largest_coordinate(std::array{soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]}));
  return largest;
}

/// A unit in which the squares of coordinates, of which this is the largest, are numbers. A power of 2: nothing is
/// rounded.
inline double unit_of(double largest_coordinate)
{
  return largest_coordinate > 0 ? std::ldexp(1., std::ilogb(largest_coordinate)) : 1;
}

} // namespace CGAL::Spherical_parameterization::preparation
