// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The standard library of emscripten 3.1.6 reads integers only: std::from_chars() of floating-point numbers, by
// fast_float. It is correctly rounded, so that a file has the same coordinates as in the tool.

#ifndef SPHERICAL_PARAMETERIZATION_PAGE_FROM_CHARS_H
#define SPHERICAL_PARAMETERIZATION_PAGE_FROM_CHARS_H

#include <fast_float/fast_float.h>

#include <charconv>

namespace std {

template <class Real, enable_if_t<is_floating_point<Real>::value, int> = 0>
from_chars_result from_chars(const char* first, const char* last, Real& value)
{
  const auto [end, error] = fast_float::from_chars(first, last, value);
  return {end, error};
}

} // namespace std

#endif // SPHERICAL_PARAMETERIZATION_PAGE_FROM_CHARS_H
