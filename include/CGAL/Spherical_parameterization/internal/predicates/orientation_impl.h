// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_ORIENTATION_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_ORIENTATION_IMPL_H

#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// A finite double as the sum of digit[i] * 2^(bits * (top - i)); the digits have its sign.
struct Long_digits {
  static constexpr int bits = 18;
  static constexpr int length = 4; ///< the first digit is not 0, and three more have 54 bits

  int top = 0;
  std::array<std::int64_t, length> digit = {};

  explicit Long_digits(double x)
  {
    int exponent = 0;
    if(std::frexp(x, &exponent) == 0)
      return;
    top = static_cast<int>(std::floor((exponent - 1.) / bits));
    double rest = std::ldexp(x, -bits * top);
    for(std::int64_t& d : digit) {
      d = static_cast<std::int64_t>(rest);
      rest = (rest - static_cast<double>(d)) * (1 << bits);
    }
  }
};

/// An exact sum of determinants: a fixed point number with room for the products of any three doubles. U. Kulisch,
/// W. Miranker, "The arithmetic of the digital computer: a new approach", SIAM Review 28, 1986.
///
/// Exact numbers of a library would do, too: but those of Boost are a megabyte of headers in every program, and CGAL's
/// MP_Float takes more than twice as long.
class Exact_determinants {
public:
  void add(vec3 a, vec3 b, vec3 c)
  {
    const std::array<Long_digits, 3> p = digits(a), q = digits(b), r = digits(c);
    for(int k = 0; k < 3; ++k) {
      add_product(1, p[k], q[(k + 1) % 3], r[(k + 2) % 3]);
      add_product(-1, p[k], q[(k + 2) % 3], r[(k + 1) % 3]);
    }
  }

  /// The sum is m * 2^e: its sign is that of m, which if it is positive is right to two units in the last place.
  /// Nothing may be added after that.
  std::pair<double, int> value()
  {
    std::int64_t carry = 0;
    int top = 0;
    for(int i = 0; i < size; ++i) {
      const std::int64_t entry = sum_[i] + carry;
      sum_[i] = entry & (base - 1);
      carry = (entry - sum_[i]) / base;
      if(sum_[i] != 0)
        top = i;
    }
    if(carry < 0)
      return {-1, 0}; // the length is of no interest
    double mantissa = 0;
    for(int i = 0; i < Long_digits::length && i <= top; ++i)
      mantissa += std::ldexp(static_cast<double>(sum_[top - i]), -Long_digits::bits * i);
    return {mantissa, Long_digits::bits * (top - offset)};
  }

private:
  // The exponents of doubles are -1074 ... 1023, those of the first digits -60 ... 56; three last ones are 9 below.
  static constexpr int lowest = -60, highest = 56, offset = -3 * lowest + 3 * (Long_digits::length - 1);
  static constexpr std::int64_t base = 1 << Long_digits::bits;

  static std::array<Long_digits, 3> digits(vec3 a) { return {Long_digits(a.x), Long_digits(a.y), Long_digits(a.z)}; }

  /// Products of three digits are below 2^54, and there is room in an entry for 500 of them.
  void add_product(int sign, const Long_digits& a, const Long_digits& b, const Long_digits& c)
  {
    std::int64_t* const first = sum_.data() + offset + a.top + b.top + c.top;
    for(int i = 0; i < Long_digits::length; ++i)
      for(int j = 0; j < Long_digits::length; ++j)
        for(int k = 0; k < Long_digits::length; ++k)
          first[-(i + j + k)] += sign * a.digit[i] * b.digit[j] * c.digit[k];
  }

  static constexpr int carries = 3; // entries that the sum of the highest ones may run over into
  static constexpr int size = offset + 3 * highest + 1 + carries;
  std::array<std::int64_t, size> sum_ = {};
};

CGAL_SP_CORE int sign_of_exact_determinant(vec3 a, vec3 b, vec3 c)
{
  Exact_determinants sum;
  sum.add(a, b, c);
  const double value = sum.value().first;
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

CGAL_SP_CORE double exact_determinant(vec3 a, vec3 b, vec3 c)
{
  for(const double sign : {1., -1.}) {
    Exact_determinants sum;
    sum.add(a, sign > 0 ? b : c, sign > 0 ? c : b);
    const auto [value, exponent] = sum.value();
    if(value >= 0)
      return sign * std::ldexp(value, exponent);
  }
  return 0;
}

CGAL_SP_CORE std::array<double, 3> exact_barycentric_coordinates(const std::array<vec3, 3>& v, vec3 q)
{
  Exact_determinants all;
  for(int k = 0; k < 3; ++k)
    all.add(v[(k + 1) % 3], v[(k + 2) % 3], q);
  const auto [total, total_exponent] = all.value();
  std::array<double, 3> result = {0, 0, 0};
  for(int k = 0; k < 3; ++k) {
    Exact_determinants own;
    own.add(v[(k + 1) % 3], v[(k + 2) % 3], q);
    const auto [value, exponent] = own.value();
    if(value > 0 && total > 0)
      result[k] = std::ldexp(value / total, exponent - total_exponent);
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_ORIENTATION_IMPL_H
