// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/solve_isometric.h>
#include <CGAL/Spherical_parameterization/internal/driver/solve_automatic.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/solve_balanced.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <CGAL/tags.h>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// Solves a problem where the policy says.
template <class Host_loop, class ExecutionPolicy, class Method>
Solution solve(const ExecutionPolicy& policy, const Method& method, const Problem& problem, Monitor& monitor);

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/driver/solve_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H
