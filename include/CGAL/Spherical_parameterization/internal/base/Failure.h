// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_FAILURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_FAILURE_H

#include <CGAL/Spherical_parameterization/Result.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// Input that cannot be mapped. Thrown by the checks and caught in `parameterize()`: it never reaches the user.
struct Failure {
  Error_code code;
  std::string detail;
};

/// "1 face is", "2 faces are"
inline std::string counted(std::size_t n, const char* one, const char* many)
{
  return std::to_string(n) + ' ' + (n == 1 ? one : many);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_FAILURE_H
