// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_PRECONDITION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_PRECONDITION_H

#include <CGAL/assertions.h>

/// A precondition on values that come from outside: it holds with NDEBUG, too. `expression` is false for NaN, if it is
/// written as a comparison that has to be true.
/// Throws CGAL::Precondition_exception, or does what CGAL::set_error_behaviour() says.
#define CGAL_SP_PRECONDITION(expression, message)                                                                      \
  ((expression) ? static_cast<void>(0) : ::CGAL::precondition_fail(#expression, __FILE__, __LINE__, message))

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_PRECONDITION_H
