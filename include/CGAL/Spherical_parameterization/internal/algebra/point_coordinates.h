// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_POINT_COORDINATES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_POINT_COORDINATES_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

template <class Point, class = void>
struct Has_xyz : std::false_type {};
template <class Point>
struct Has_xyz<Point,
               std::void_t<decltype(std::declval<const Point&>().x()), decltype(std::declval<const Point&>().y()),
                           decltype(std::declval<const Point&>().z())>> : std::true_type {};

/// A number of any type.
template <class Number>
double as_double(const Number& x)
{
  using CGAL::to_double;
  if constexpr(std::is_convertible_v<Number, double>) // CGAL does not know all of these
    return static_cast<double>(x);
  else
    return to_double(x);
}

/// The coordinates of a point of any kernel or vector library, as doubles: x(), y(), z() if there are such members,
/// else p[0], p[1], p[2].
template <class Point>
vec3 coordinates(const Point& p)
{
  if constexpr(Has_xyz<Point>::value)
    return {as_double(p.x()), as_double(p.y()), as_double(p.z())};
  else
    return {as_double(p[0]), as_double(p[1]), as_double(p[2])};
}

inline vec3 coordinates(const vec3& p) { return p; }

inline std::array<double, 3> array_of(vec3 p) { return {p.x, p.y, p.z}; }

template <class Point>
auto first_coordinate(const Point& p)
{
  if constexpr(Has_xyz<Point>::value)
    return p.x();
  else
    return p[0];
}
/// The type of the coordinates of a point.
template <class Point>
using Coordinate_of = std::decay_t<decltype(first_coordinate(std::declval<const Point&>()))>;

/// A number as this type holds it: integers are rounded.
template <class Number>
Number stored_number(double x)
{
  return static_cast<Number>(std::is_integral_v<Number> ? std::round(x) : x);
}

/// A position as points of this type hold it.
template <class Point>
Point stored_point(vec3 p)
{
  typedef Coordinate_of<Point> FT;
  return Point{stored_number<FT>(p.x), stored_number<FT>(p.y), stored_number<FT>(p.z)};
}

/// Whether several threads may read coordinates of this type at once: built-in numbers, unlike lazy exact ones.
template <class Point>
constexpr bool are_plain_coordinates()
{
  return std::is_floating_point_v<Coordinate_of<Point>>;
}

/// a divided by the largest of its absolute coordinates: squares and products then neither overflow nor underflow.
inline vec3 scaled_to_unit_box(vec3 a)
{
  const double largest = (std::max)({std::abs(a.x), std::abs(a.y), std::abs(a.z)});
  return largest > 0 ? vec3{a.x / largest, a.y / largest, a.z / largest} : a;
}

/// The direction of a vector that is not zero; a unit vector to a few roundings stays what it is, to the last bit.
inline vec3 direction_of(vec3 a)
{
  constexpr double rounding = 2e-15;
  return std::abs(inner(a, a) - 1) <= rounding ? a : unit(scaled_to_unit_box(a));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_POINT_COORDINATES_H
