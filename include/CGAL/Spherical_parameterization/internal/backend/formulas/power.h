/* SPDX-License-Identifier: LGPL-3.0-or-later
 * Part of CGAL Spherical Parameterization.
 *
 * Powers: pow() differs in the last bits from one C library or device to the next, and maps with it. See
 * vertex_formulas.h.
 */
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_POWER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_FORMULAS_POWER_H

#ifdef __OPENCL_C_VERSION__

/* x = m 2^k with m in [1/2, 1) */
real mantissa(real x, int* k) { return frexp(x, k); }
real times_power_of_two(real x, int n) { return ldexp(x, n); }

#else
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <cstdint>
#include <cstring>
namespace CGAL::Spherical_parameterization::internal {

/// What frexp() and ldexp() do for finite x > 0 and |n| <= 1100, without a call of the library.
inline double double_of(std::uint64_t bits)
{
  double x;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}
inline double mantissa(double x, int* k)
{
  const bool is_subnormal = x < 0x1p-1022;
  if(is_subnormal)
    x *= 0x1p54;
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  *k = static_cast<int>(bits >> 52) - (is_subnormal ? 1022 + 54 : 1022);
  return double_of((bits & 0x000fffffffffffff) | 0x3fe0000000000000);
}
inline double power_of_two(int n) { return double_of(static_cast<std::uint64_t>(n + 1023) << 52); }
inline double times_power_of_two(double x, int n) { return x * power_of_two(n / 2) * power_of_two(n - n / 2); }
#endif

/* x^(n/4) for finite x > 0, by products and square roots */
CGAL_SP_FUNCTION real power_of_quarters(real x, int n)
{
  const int size = n < 0 ? -n : n;
  const real root = sqrt(x);
  real result = (size & 2 ? root : 1) * (size & 1 ? sqrt(root) : 1);
  for(int i = size / 4; i > 0; i /= 2) {
    result = i & 1 ? result * x : result;
    x = x * x;
  }
  return n < 0 ? 1 / result : result;
}

/* x^y for finite x > 0 and y, with a relative error below (2 + |y| + |log(x^y)|) 2^-52; beyond the range of numbers
 * infinity or 0. Products, sums, quotients and square roots alone, since these round in the same way everywhere.
 *
 * x = 2^k m with m in [sqrt(1/2), sqrt(2)), log(m) = 2 artanh((m - 1) / (m + 1)), and x^y = 2^n e^f with
 * |f| <= log(2) / 2: both series go on until a term is below 2^-56 of the sum. */
CGAL_SP_FUNCTION real power(real x, real y)
{
  if(y > -64 && y < 64 && 4 * y == (int)(4 * y)) /* most exponents that are chosen are such */
    return power_of_quarters(x, (int)(4 * y));
  int k;
  real m = mantissa(x, &k);
  const int is_small = m < 0.70710678118654752;
  m = is_small ? 2 * m : m;
  k -= is_small;
  const real s = (m - 1) / (m + 1), q = s * s;
  real sum = 0.043478260869565216; /* 1 / 23, 1 / 21, ... */
  sum = sum * q + 0.047619047619047616;
  sum = sum * q + 0.05263157894736842;
  sum = sum * q + 0.058823529411764705;
  sum = sum * q + 0.06666666666666667;
  sum = sum * q + 0.07692307692307693;
  sum = sum * q + 0.09090909090909091;
  sum = sum * q + 0.1111111111111111;
  sum = sum * q + 0.14285714285714285;
  sum = sum * q + 0.2;
  sum = sum * q + 0.3333333333333333;
  const real whole = y * k, rest = y * (2.8853900817779268 * (s + s * q * sum)); /* 2 / log(2) */
  real binary = whole + rest;
  binary = binary > 1100 ? 1100 : binary < -1100 ? -1100 : binary;
  const int n = (int)(binary < 0 ? binary - 0.5 : binary + 0.5);
  real f = (whole - n + rest) * 0.69314718055994531;
  f = f > 1 ? 1 : f < -1 ? -1 : f;
  sum = 1.6059043836821613e-10; /* 1 / 13!, 1 / 12!, ... */
  sum = sum * f + 2.08767569878681e-09;
  sum = sum * f + 2.505210838544172e-08;
  sum = sum * f + 2.755731922398589e-07;
  sum = sum * f + 2.7557319223985893e-06;
  sum = sum * f + 2.48015873015873e-05;
  sum = sum * f + 0.0001984126984126984;
  sum = sum * f + 0.001388888888888889;
  sum = sum * f + 0.008333333333333333;
  sum = sum * f + 0.041666666666666664;
  sum = sum * f + 0.16666666666666666;
  sum = sum * f + 0.5;
  return times_power_of_two(1 + (f + f * f * sum), n);
}

#ifndef __OPENCL_C_VERSION__
} // namespace CGAL::Spherical_parameterization::internal
#endif

#endif
