// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_IMPL_H

#include <CGAL/Spherical_parameterization/internal/predicates/exact_determinant.h>

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL::Spherical_parameterization::internal {

/// A vector of doubles as three integers times 2^exponent.
struct Integer_vector {
  typedef boost::multiprecision::cpp_int Integer;

  std::array<Integer, 3> coordinate;
  int exponent;

  explicit Integer_vector(vec3 p)
  {
    constexpr int bits = 53;
    const std::array<double, 3> value = {p.x, p.y, p.z};
    std::array<int, 3> exponents;
    for(int k = 0; k < 3; ++k)
      coordinate[k] = static_cast<std::int64_t>(std::ldexp(std::frexp(value[k], &exponents[k]), bits));
    exponent = *std::min_element(exponents.begin(), exponents.end()) - bits;
    for(int k = 0; k < 3; ++k)
      coordinate[k] <<= exponents[k] - bits - exponent;
  }
};

inline Integer_vector::Integer determinant(const Integer_vector& a, const Integer_vector& b, const Integer_vector& c)
{
  const auto minor = [&](int i, int j) {
    return Integer_vector::Integer(b.coordinate[i] * c.coordinate[j] - b.coordinate[j] * c.coordinate[i]);
  };
  return a.coordinate[0] * minor(1, 2) + a.coordinate[1] * minor(2, 0) + a.coordinate[2] * minor(0, 1);
}

CGAL_SP_CORE int sign_of_exact_determinant(vec3 a, vec3 b, vec3 c)
{
  return determinant(Integer_vector(a), Integer_vector(b), Integer_vector(c)).sign();
}

CGAL_SP_CORE std::array<double, 3> exact_barycentric_coordinates(const std::array<vec3, 3>& v, vec3 q)
{
  typedef Integer_vector::Integer Integer;
  const Integer_vector direction(q);
  const std::array<Integer_vector, 3> corner = {Integer_vector(v[0]), Integer_vector(v[1]), Integer_vector(v[2])};
  // The exponent of a determinant is the sum of those of its vectors: that of v_k is missing in the k-th one.
  const int most = (std::max)({corner[0].exponent, corner[1].exponent, corner[2].exponent});
  std::array<Integer, 3> exact;
  Integer total = 0;
  for(int k = 0; k < 3; ++k) {
    exact[k] = determinant(corner[(k + 1) % 3], corner[(k + 2) % 3], direction);
    exact[k] <<= most - corner[k].exponent;
    total += exact[k];
  }
  std::array<double, 3> result = {0, 0, 0};
  for(int k = 0; k < 3; ++k) {
    if(exact[k] <= 0 || total <= 0)
      continue;
    constexpr int bits = 64; // of the quotient, of which a double keeps 53
    const int shift = (std::max)(0, bits + static_cast<int>(msb(total)) - static_cast<int>(msb(exact[k])));
    result[k] = std::ldexp(Integer((exact[k] << shift) / total).convert_to<double>(), -shift);
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_EXACT_DETERMINANT_IMPL_H
