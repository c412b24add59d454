// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_PRECONDITION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_PRECONDITION_H

#include <CGAL/assertions.h>

namespace CGAL::Spherical_parameterization {
namespace internal {

/// A precondition on values that come from outside: it holds with NDEBUG, too. `holds` is false for NaN, if it is
/// written as a comparison that has to be true.
/// Throws CGAL::Precondition_exception, or does what CGAL::set_error_behaviour() says.
inline void precondition(bool holds, const char* expression, const char* file, int line, const char* message)
{
  if(!holds)
    CGAL::precondition_fail(expression, file, line, message);
}

} // namespace internal

} // namespace CGAL::Spherical_parameterization

#define CGAL_SP_PRECONDITION(expression, message)                                                                      \
  ::CGAL::Spherical_parameterization::internal::precondition((expression), #expression, __FILE__, __LINE__, message)

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_PRECONDITION_H
