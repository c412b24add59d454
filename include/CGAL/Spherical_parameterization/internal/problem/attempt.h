// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_ATTEMPT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_ATTEMPT_H

#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/values/Error.h>

#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// Throws the Error if there is no map whose edges are geodesic: these are determined by their ends.
inline void check_simplicial(const Problem& problem)
{
  const std::string wrong = "there is no map with geodesic edges: ";
  if(problem.size() < 4)
    throw Input_error(Error_code::NOT_BIJECTIVE, wrong + "the mesh has fewer than four vertices");
  if(!problem.is_simplicial)
    throw Input_error(Error_code::NOT_BIJECTIVE, wrong + "two edges of the mesh have the same ends");
}

/// Runs a method, and says how it went: an `Input_error`, also that of an interruption, becomes a solution without a
/// map; what the caller's callback throws goes through. All seconds are accounted for.
template <class Backend, class Method>
Solution attempt(const Backend& backend, const Method_solver<Method>& solver, const Problem& problem,
                 const Effort& effort, Monitor& monitor)
{
  const Stopwatch watch;
  Solution solution;
  try {
    monitor.advance_or_throw(); // INTERRUPTED, if the time is up or the callback says so
    check_simplicial(problem);
    solution = solver.solve(backend, problem, effort, monitor);
  } catch(const Input_error& error) {
    solution.error = error.code();
    solution.detail = error.code() == Error_code::INTERRUPTED ? monitor.reason_without_map() : error.detail();
    if(monitor.is_interrupted())
      solution.termination = monitor.termination();
    solution.seconds.solve = watch.seconds();
  }
  // The solver has certified its map: what is left are termination, error, detail and remedy. `Automatic` is done with
  // each of its attempts.
  if(solution.has_map() && solution.attempts.empty())
    pass_verdict(problem, monitor, solution);
  if(solution.method.empty())
    solution.method = solver.name();
  solution.seconds.total = watch.seconds();
  if(solution.attempts.empty())
    solution.attempts.push_back(
      {solution.method, solution.error, solution.detail, solution.seconds, solution.termination});
  return solution;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_ATTEMPT_H
