// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_ON_ONE_CORE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_ON_ONE_CORE_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>

#include <CGAL/tags.h>

#include <utility>

/// Defines the overload of a function `f(policy, first, ...)` that is called without a policy, and runs on one core.
/// The parameter `policy` of f is constrained by `internal::If_policy`.
#define CGAL_SP_ON_ONE_CORE(function)                                                                                  \
  template <class First, class... Arguments, ::CGAL::Spherical_parameterization::internal::If_no_policy<First> = 0>    \
  auto function(const First& first, Arguments&&... arguments)                                                          \
  {                                                                                                                    \
    return function(::CGAL::Sequential_tag(), first, std::forward<Arguments>(arguments)...);                           \
  }

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_ON_ONE_CORE_H
