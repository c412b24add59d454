// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H

#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>

#include <algorithm>
#include <cstddef>
#include <optional>

namespace CGAL::Spherical_parameterization::internal {

/// What a method does with edge weights.
enum class Weights {
  NEEDED,       ///< there is no map without them
  IF_AVAILABLE, ///< it can do without them: with densities, and where a face has no area
  UNUSED
};

/// How far the caller wants a method to go; what is not given is the default of the method.
struct Effort {
  std::optional<double> accuracy;
  std::optional<std::size_t> number_of_iterations;
};

/// How a method is run. A method of the package, a struct M of its options, is complete with the specialization
///
///     template <>
///     class Method_solver<M> {
///     public:
///       explicit Method_solver(const M& method);   // checks the options with CGAL_SP_PRECONDITION
///       static Weights weights();
///       bool needs_given_start() const;            // whether it starts from what the sphere map holds
///       std::string name() const;                  // for Result::method
///       template <class Backend>
///       Solution solve(const Backend& backend, const Problem& problem, const Effort& effort, Monitor& monitor) const;
///     };
///
/// solve() works with the verbs of `backend`, or on the host with backend.host_loop(). It calls monitor.advance(share),
/// through which callbacks and time limits reach it. A method of springs ends with `hand_over()` of settle.h. It throws
/// an Input_error if there is no map.
template <class Method>
class Method_solver;

/// What the caller asked for, or the default of the method; not more than the backend can give.
template <class Backend>
double accuracy_on(const Backend& backend, const Problem& problem, const Effort& effort, double by_default)
{
  return (std::max)(effort.accuracy.value_or(by_default), backend.best_accuracy(problem.size()));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H
