// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// hypot() with the bits that it has in the C library of Debian, instead of musl's, which emscripten has: 14 % of their
// results differ in the last bit, and start maps with them. C. F. Borges, "Algorithm 1014: An improved algorithm for
// hypot(x,y)", ACM Transactions on Mathematical Software 47 (2020), as in glibc 2.35 and later.

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

/// \pre a >= b > 0, and squares neither overflow nor underflow
double corrected(double a, double b)
{
  const double h = std::sqrt(a * a + b * b);
  double s, t;
  if(h <= 2 * b) {
    const double delta = h - b;
    s = a * (2 * delta - a);
    t = (delta - 2 * (a - b)) * delta;
  } else {
    const double delta = h - a;
    s = 2 * delta * (a - 2 * b);
    t = (4 * delta - b) * b + delta * delta;
  }
  return h - (s + t) / (2 * h);
}

} // namespace

extern "C" double hypot(double x, double y)
{
  constexpr double scale = 0x1p-600;
  if(std::isinf(x) || std::isinf(y))
    return std::numeric_limits<double>::infinity();
  if(std::isnan(x) || std::isnan(y))
    return std::numeric_limits<double>::quiet_NaN();
  const double a = std::max(std::abs(x), std::abs(y)), b = std::min(std::abs(x), std::abs(y));
  if(a > 0x1p+511)
    return b <= a * 0x1p-54 ? a + b : corrected(a * scale, b * scale) / scale;
  if(b < 0x1p-459)
    return a >= b / 0x1p-54 ? a + b : corrected(a / scale, b / scale) * scale;
  return b <= a * 0x1p-54 ? a + b : corrected(a, b);
}
