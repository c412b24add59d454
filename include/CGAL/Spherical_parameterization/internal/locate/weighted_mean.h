// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_WEIGHTED_MEAN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_WEIGHTED_MEAN_H

#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

template <class Value, class = void>
struct Is_linear : std::false_type {};
template <class Value>
struct Is_linear<Value, std::void_t<decltype(1. * std::declval<const Value&>() + 1. * std::declval<const Value&>())>>
  : std::true_type {};

/// Between the least and the largest of them, whatever the rounding: what is constant stays so, and nothing overflows.
template <class Number>
Number weighted_mean_of_numbers(const std::array<double, 3>& w, Number x0, Number x1, Number x2)
{
  const auto [least, largest] = std::minmax({x0, x1, x2});
  const auto term = [](double weight, Number x) { return weight == 0 ? 0 : weight * x; };
  return std::clamp<Number>(term(w[0], x0) + term(w[1], x1) + term(w[2], x2), least, largest);
}

/// w_0 x_0 + w_1 x_1 + w_2 x_2 of numbers, vectors of any library, or points (which CGAL does not add up). A corner
/// without weight does not count, even if its value is not finite.
template <class Value>
Value weighted_mean(const std::array<double, 3>& w, const Value& x0, const Value& x1, const Value& x2)
{
  if constexpr(std::is_integral_v<Value>) {
    const auto [least, largest] = std::minmax({x0, x1, x2});
    const double mean = std::round(weighted_mean_of_numbers<double>(w, x0, x1, x2));
    if(mean <= static_cast<double>(least) || mean >= static_cast<double>(largest)) // beyond 2^53 these are rounded
      return mean <= static_cast<double>(least) ? least : largest;
    return static_cast<Value>(mean);
  } else if constexpr(std::is_arithmetic_v<Value>)
    return static_cast<Value>(weighted_mean_of_numbers<std::common_type_t<double, Value>>(w, x0, x1, x2));
  else if constexpr(Is_linear<Value>::value) {
    const Value& some = w[0] != 0 ? x0 : w[1] != 0 ? x1 : x2; // 0 times this is 0
    const auto counted = [&](double weight, const Value& x) -> const Value& { return weight == 0 ? some : x; };
    return static_cast<Value>(w[0] * counted(w[0], x0) + w[1] * counted(w[1], x1) + w[2] * counted(w[2], x2));
  } else {
    const vec3 a = coordinates(x0), b = coordinates(x1), c = coordinates(x2);
    return stored_point<Value>({weighted_mean_of_numbers(w, a.x, b.x, c.x), weighted_mean_of_numbers(w, a.y, b.y, c.y),
                                weighted_mean_of_numbers(w, a.z, b.z, c.z)});
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_WEIGHTED_MEAN_H
