// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_ROUNDED_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_ROUNDED_H

#include <cstdint>
#include <cstring>
#include <limits>

namespace CGAL::Spherical_parameterization::internal {

/// x to the nearest multiple of 2^-digits times the power of two below `size`. So numbers that differ by rounding
/// errors become one, but for rare exceptions: the border of two multiples can lie between them.
/// \pre |x| <= size < infinity
template <int digits>
double rounded(double x, double size)
{
  constexpr int all = std::numeric_limits<double>::digits - 1;
  constexpr std::uint64_t exponent = ~std::uint64_t(0) << all;
  std::uint64_t bits;
  std::memcpy(&bits, &size, sizeof bits);
  bits &= exponent;
  double power;
  std::memcpy(&power, &bits, sizeof power);
  // Its last digit is the one that x is rounded to.
  const double shift = 1.5 * double(std::uint64_t(1) << (all - digits)) * power;
  return (x + shift) - shift;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_ROUNDED_H
