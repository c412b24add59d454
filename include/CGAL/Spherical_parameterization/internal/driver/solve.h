// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/automatic/solve_automatic.h>
#include <CGAL/Spherical_parameterization/internal/balanced/solve_balanced.h>
#include <CGAL/Spherical_parameterization/internal/isometric/solve_isometric.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <CGAL/tags.h>

namespace CGAL::Spherical_parameterization::internal {

/// Runs a method on the backend of the policy. What is wrong with input or map is error and detail of the solution,
/// which may have no map. Exceptions of the caller's callback go through, as do `OpenCL_error` and `std::bad_alloc`.
/// \pre `Method_solver<Method>(method)` has been made before: it checks the options of the method
template <class Loop, class ExecutionPolicy, class Method>
Solution solve(const ExecutionPolicy& policy, const Method& method, const Problem& problem, const Effort& effort,
               Monitor& monitor);

/// What the compiled library has of a policy, after the word `template` or `extern template`.
#define CGAL_SP_FOR_EACH_METHOD(PREFIX, POLICY)                                                                        \
  PREFIX Solution solve<Host_loop>(const POLICY&, const Balanced&, const Problem&, const Effort&, Monitor&);           \
  PREFIX Solution solve<Host_loop>(const POLICY&, const Saddle_point&, const Problem&, const Effort&, Monitor&);       \
  PREFIX Solution solve<Host_loop>(const POLICY&, const Isometric&, const Problem&, const Effort&, Monitor&);          \
  PREFIX Solution solve<Host_loop>(const POLICY&, const Automatic&, const Problem&, const Effort&, Monitor&);

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
CGAL_SP_FOR_EACH_METHOD(extern template, CGAL::Sequential_tag)
#ifdef CGAL_LINKED_WITH_TBB
CGAL_SP_FOR_EACH_METHOD(extern template, CGAL::Parallel_tag)
#endif
#endif

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/driver/solve_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H
