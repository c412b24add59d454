// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXT_TEXT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXT_TEXT_H

#include <cstddef>
#include <locale>
#include <sstream>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// "1 face is", "2 faces are"
inline std::string counted(std::size_t n, const char* one, const char* many)
{
  return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

/// With so many digits, and a point in every locale.
inline std::string to_string(double x, int digits = 3)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(digits);
  out << x;
  return out.str();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXT_TEXT_H
