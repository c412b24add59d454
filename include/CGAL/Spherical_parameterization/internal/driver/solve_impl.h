// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_IMPL_H

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/driver/solve.h>
#include <CGAL/Spherical_parameterization/internal/problem/attempt.h>

#include <string>
#include <type_traits>

namespace CGAL::Spherical_parameterization::internal {

/// Its contract, and which exceptions leave it: solve.h.
template <class Loop, class ExecutionPolicy, class Method>
Solution solve(const ExecutionPolicy& policy, const Method& method, const Problem& problem, const Effort& effort,
               Monitor& monitor)
{
  constexpr bool is_advised = std::is_same_v<Method, Automatic> || std::is_same_v<Method, Isometric>;
  const Stopwatch watch;
  const auto run = [&](const auto& backend, const std::string& device) {
    const double set_up = watch.seconds(); // kernels of a device are compiled when it is used first
    // Runs the method, and decides whether its map is OK, INTERRUPTED, NOT_CONVERGED or NOT_BIJECTIVE. An Input_error,
    // with any other code, becomes a solution without a map.
    Solution solution = attempt(backend, Method_solver<Method>(method), problem, effort, monitor);
    if(!solution.remedy.empty()) { // NOT_BIJECTIVE; `solution.attempts` keep the detail without it
      const std::string others = is_advised ? "" : "the automatic or the isometric method, or ";
      solution.remedy = "use " + others + solution.remedy;
      solution.detail += "; " + solution.remedy;
    }
    solution.device = device;
    solution.seconds.start_map += set_up; // the total is set by parameterize()
    return solution;
  };
  // Calls `run` once. OpenCL leaves meshes that are small to one core of the host.
  return Choice_of_backend<ExecutionPolicy, Loop>::call(policy, problem.size(), run);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_IMPL_H
