// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_POLICY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_POLICY_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>

#include <CGAL/tags.h>

#include <type_traits>

namespace CGAL::Spherical_parameterization::internal {

/// Tells `f(policy, mesh, ...)` from `f(mesh, ...)`. `CGAL::Parallel_tag` is a policy without TBB, too: one for which
/// `host_loop()` says what is missing.
template <class T>
constexpr bool is_policy = Is_policy<T>::value || std::is_same_v<T, CGAL::Parallel_tag>;

/// The parameters of function templates that are there for one of them.
template <class T>
using If_policy = std::enable_if_t<is_policy<T>, int>;
template <class T>
using If_no_policy = std::enable_if_t<!is_policy<T>, int>;

/// What functions that run on the host run their loops with.
template <class ExecutionPolicy>
auto host_loop(const ExecutionPolicy&)
{
  if constexpr(is_supported_policy<ExecutionPolicy>())
    return typename Loop_of<ExecutionPolicy>::type();
  else
    return Sequential_loop();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_HOST_POLICY_H
