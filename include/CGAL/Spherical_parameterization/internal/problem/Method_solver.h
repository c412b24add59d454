// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H

#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>

#include <algorithm>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// What a method does with edge weights.
enum class Weights {
  NEEDED,       ///< there is no map without them
  IF_AVAILABLE, ///< it can do without them where a face has no area
  UNUSED
};

/// How a method is run. A method of the package, a struct M of its options, is complete with the specialization
///
///     template <>
///     class Method_solver<M> {
///     public:
///       explicit Method_solver(const M& method);   // checks the options: precondition()
///       static Weights weights();
///       bool needs_given_start() const;            // whether it starts from what the sphere map holds
///       std::string name() const;                  // for Result::method
///       template <class Backend>
///       Solution solve(const Backend& backend, const Problem& problem, const Effort& effort, Monitor& monitor) const;
///     };
///
/// solve() works with the verbs of `backend`, or on the host with backend.host_loop(). It calls monitor.advance(share),
/// through which callbacks and time limits reach it, and ends with finish(). It throws an Error if there is no map.
template <class Method>
class Method_solver;

/// What the caller asked for, or the default of the method; not more than the backend can give.
template <class Backend>
double accuracy_on(const Backend& backend, const Problem& problem, const Effort& effort, double by_default)
{
  return (std::max)(effort.accuracy.value_or(by_default), backend.best_accuracy(problem.size()));
}

/// The share of the whole work that the start map takes, for the progress callback.
constexpr double start_share = 0.4;

/// Makes of positions what the caller's map will hold: unit vectors as near as doubles are, where the positions are
/// rough, of a backend that computes in single precision; fixed vertices to the last bit; coordinates rounded as the
/// caller's map rounds them.
inline void make_storable(const Host_loop& loop, const Problem& problem, bool are_rough, Host_array<vec3>& v)
{
  if(!are_rough && !problem.has_fixed() && !problem.as_stored)
    return;
  for_each_index(loop, problem.size(), [&](int i) {
    if(problem.has_fixed() && problem.is_fixed[i])
      v[i] = problem.given[i];
    else if(are_rough)
      v[i] = unit(v[i]);
    if(problem.as_stored)
      v[i] = problem.as_stored(v[i]);
  });
}

/// What a backend hands over, as it will be stored.
template <class Backend, class Vectors>
Host_array<vec3> storable(const Backend& backend, const Problem& problem, Vectors&& v)
{
  Host_array<vec3> result = backend.download(std::forward<Vectors>(v));
  make_storable(backend.host_loop(), problem, backend.best_accuracy(problem.size()) > 0, result);
  return result;
}

/// Certifies a map on the backend as it will be stored, into `solution`. Returns whether a solver is done with it: it
/// is valid, or what is wrong with it is rounding only, which no solver can help.
template <class Backend>
bool certify_and_settle(const Backend& backend, const Problem& problem, const typename Backend::Vectors& v,
                        Solution& solution)
{
  const Stopwatch watch;
  solution.certificate = certify(backend.host_loop(), problem.face, storable(backend, problem, v));
  const bool is_settled =
    solution.certificate.is_valid() ||
    (problem.as_stored && certify(backend.host_loop(), problem.face, backend.download(v)).is_valid());
  solution.seconds.certify += watch.seconds();
  return is_settled;
}

/// Hands the map over, certified if that has not been done yet.
template <class Backend>
void finish(const Backend& backend, const Problem& problem, typename Backend::Vectors&& v, bool is_certified,
            Solution& solution)
{
  const Stopwatch watch;
  solution.position = storable(backend, problem, std::move(v));
  if(!is_certified)
    solution.certificate = certify(backend.host_loop(), problem.face, solution.position);
  solution.seconds.certify += watch.seconds();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H
