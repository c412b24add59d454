// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLUTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLUTION_H

#include <CGAL/Spherical_parameterization/values/Result.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// What a solver has to say about its run, and about the map it has ended with.
struct Solver_report {
  std::size_t start_iterations = 0; ///< of the start map, on all coarse levels together
  std::size_t iterations = 0;
  std::size_t sweeps = 0;
  double residual = 0;
  double energy = 0;
  double density_deviation = 0;
  bool has_converged = false; ///< the solver itself: what is done for faces and rounding comes after it
  bool has_stalled = false;   ///< gave up before the limit of iterations, since nothing improved any more
};

/// A map, and all that is to be said about it. Certificate and report belong to these positions and to no others.
struct Solution {
  Host_array<vec3> position;  ///< unit vectors as the caller's map will store them; empty: there is no map
  Certificate certificate;    ///< of `position`
  std::vector<char> is_moved; ///< vertices that are not where the springs pull them, see `mend.h`; or empty
  Solver_report report;       ///< residual, energy and deviation are those of `position`
  double accuracy = 0;        ///< that the residual is held against
  std::optional<Termination> termination;
  Result::Seconds seconds; ///< of the phases between reading and writing, all attempts together
  std::string method;      ///< that found the map
  std::string device;      ///< what it ran on
  Error_code error = Error_code::OK;
  std::string detail;
  std::string
    remedy; ///< what may help a map that is not valid, by pass_verdict(); solve() adds other methods; or empty
  std::string fallback_reason;           ///< see `Result::fallback_reason`
  std::vector<Result::Attempt> attempts; ///< the methods that were tried, in turn

  bool has_map() const { return !position.empty(); }
};

/// Decides about a solution, and says why it ended. A map is `OK` if its certificate is valid, and the solver has done
/// what was asked for; else `INTERRUPTED`, `NOT_CONVERGED`, or `NOT_BIJECTIVE`, with a remedy.
CGAL_SP_CORE void pass_verdict(const Problem& problem, const Monitor& monitor, Solution& solution);

/// Everything in a solution but its positions, for the caller.
CGAL_SP_CORE void describe(const Solution& solution, Result& result);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/problem/Solution_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLUTION_H
