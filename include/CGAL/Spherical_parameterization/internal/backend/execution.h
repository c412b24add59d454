// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_EXECUTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_EXECUTION_H

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <CGAL/tags.h>

#include <type_traits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// Where the solvers run. `Backend_for<P, Loop>::type` is the backend of the execution policy P, for each policy that
/// is supported. A backend is the only place that knows how loops are run there. Its memory and its verbs (one loop
/// each over a formula of vertex_formulas.h) are all that a solver sees.
///
/// There is a backend for
/// - `CGAL::Sequential_tag`: one core (Host_backend.h);
/// - `CGAL::Parallel_tag`: the threads of the caller's TBB arena (the same file), if linked with TBB;
/// - `OpenCL_device`: an OpenCL command queue, if OpenCL_device.h is included.
///
/// `Loop` is `Host_loop`, how set-up on the host is run. As a parameter it is part of the names of types, so that no
/// class is defined in two ways in a program of which only a part is compiled with TBB.
template <class ExecutionPolicy, class Loop>
struct Backend_for;

template <class ExecutionPolicy>
using Backend = typename Backend_for<ExecutionPolicy, Host_loop>::type;

/// Whether there is a backend for it.
template <class ExecutionPolicy>
struct Is_policy : std::is_same<ExecutionPolicy, CGAL::Sequential_tag> {};
#ifdef CGAL_LINKED_WITH_TBB
template <>
struct Is_policy<CGAL::Parallel_tag> : std::true_type {};
#endif

/// A static_assert() where it is called with what is no execution policy.
template <class ExecutionPolicy>
constexpr bool is_supported_policy()
{
  static_assert(Is_policy<ExecutionPolicy>::value || !std::is_same_v<ExecutionPolicy, CGAL::Parallel_tag>,
                "CGAL::Parallel_tag needs TBB: link with CGAL::TBB_support, which defines CGAL_LINKED_WITH_TBB");
  static_assert(Is_policy<ExecutionPolicy>::value || std::is_same_v<ExecutionPolicy, CGAL::Parallel_tag>,
                "the execution policy has to be CGAL::Sequential_tag, CGAL::Parallel_tag or an OpenCL_device");
  return Is_policy<ExecutionPolicy>::value;
}

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
Host_loop host_loop(const ExecutionPolicy&)
{
  static_cast<void>(is_supported_policy<ExecutionPolicy>());
  return loop_of<ExecutionPolicy>();
}

/// Calls `f(backend, name)` once, with the backend on which `policy` maps a mesh of n vertices, and what to call it,
/// and returns what f does. A backend of the host is made for nothing. That of OpenCL, in OpenCL_device.h, may throw an
/// `OpenCL_error`, and leaves small meshes to one core of the host.
template <class ExecutionPolicy, class Loop>
struct Choice_of_backend {
  template <class F>
  static auto call(const ExecutionPolicy& policy, int /* n */, F f)
  {
    const typename Backend_for<ExecutionPolicy, Loop>::type backend(policy);
    return f(backend, backend.device_name());
  }
};

} // namespace CGAL::Spherical_parameterization::internal

/// Defines the overload of a function `f(policy, first, ...)` that is called without a policy, and runs on one core.
/// The parameter `policy` of f is constrained by `internal::If_policy`.
#define CGAL_SP_ON_ONE_CORE(function)                                                                                  \
  template <class First, class... Arguments,                                                                           \
            ::CGAL::Spherical_parameterization::internal::If_no_policy<std::decay_t<First>> = 0>                       \
  auto function(First&& first, Arguments&&... arguments)                                                               \
  {                                                                                                                    \
    return function(::CGAL::Sequential_tag(), std::forward<First>(first), std::forward<Arguments>(arguments)...);      \
  }

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_EXECUTION_H
