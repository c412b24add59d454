// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H

#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/mend.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

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
///       explicit Method_solver(const M& method);   // checks the options with CGAL_SP_PRECONDITION
///       static Weights weights();
///       bool needs_given_start() const;            // whether it starts from what the sphere map holds
///       std::string name() const;                  // for Result::method
///       template <class Backend>
///       Solution solve(const Backend& backend, const Problem& problem, const Effort& effort, Monitor& monitor) const;
///     };
///
/// solve() works with the verbs of `backend`, or on the host with backend.host_loop(). It calls monitor.advance(share),
/// through which callbacks and time limits reach it, and ends with finish(). It throws an Input_error if there is no
/// map.
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

/// The positions of a backend in doubles: unit vectors as near as doubles are, where the positions are rough, of a
/// backend that computes in single precision; fixed vertices to the last bit.
template <class Backend, class Vectors>
Host_array<vec3> in_doubles(const Backend& backend, const Problem& problem, Vectors&& v)
{
  Host_array<vec3> result = backend.download(std::forward<Vectors>(v));
  const bool are_rough = backend.best_accuracy(problem.size()) > 0;
  if(are_rough || problem.has_fixed())
    for_each_index(backend.host_loop(), problem.size(), [&](int i) {
      if(problem.has_fixed() && problem.is_fixed[i])
        result[i] = problem.given[i];
      else if(are_rough)
        result[i] = unit(result[i]);
    });
  return result;
}

/// Rounds coordinates as the caller's map does.
inline void make_storable(const Host_loop& loop, const Problem& problem, Host_array<vec3>& v)
{
  if(problem.as_stored)
    for_each_index(loop, problem.size(), [&](int i) { v[i] = problem.as_stored(v[i]); });
}

/// The certificate of positions as they will be stored.
inline Certificate certify_as_stored(const Host_loop& loop, const Problem& problem, const Host_array<vec3>& v)
{
  if(!problem.as_stored)
    return certify(loop, problem.face, v);
  Host_array<vec3> stored = v;
  make_storable(loop, problem, stored);
  return certify(loop, problem.face, stored);
}

/// The residual that rounding leaves on coordinates of this precision: an error of some roundings at every vertex.
inline double residual_of_rounding(const Problem& problem)
{
  constexpr double roundings = 5;
  return roundings * problem.rounding * std::sqrt(static_cast<double>(problem.size()));
}

/// Mends the bad faces of a conformal map; then `solution` has the positions. Returns false where they cannot be
/// mended, or are not known well enough: see `mend()` of the relaxation.
/// \param is_harmonic  whether the springs have the exponent 2. If not, they trade angles for areas, and none but
///                     flipped faces are bad
inline bool mend(const Host_loop& loop, const Problem& problem, bool is_harmonic, double resolution, Monitor& monitor,
                 Host_array<vec3>&& v, Solution& solution)
{
  constexpr double tolerated = 2; // MIPS: stretches in the ratio 3.7
  if(!problem.is_intrinsic() || solution.certificate.degree != 1)
    return false;
  const double bound = is_harmonic ? tolerated : std::numeric_limits<double>::infinity();
  std::vector<char> is_moved(problem.size(), 0);
  const Mending mending =
    mend(loop, problem.face, problem.point, problem.is_fixed, bound, resolution, monitor, v, is_moved);
  solution.is_beyond_mending = mending == Mending::TOO_MUCH;
  if(mending != Mending::DONE)
    return false;
  const Certificate certificate = certify_as_stored(loop, problem, v);
  if(certificate.degree != 1) // possible where nearly all vertices were moved
    return false;
  if(certificate.is_valid() || !solution.certificate.is_valid()) { // rounding to floats may flip what was valid
    solution.certificate = certificate;
    solution.position = std::move(v);
    solution.is_moved = std::move(is_moved);
  }
  return true;
}

/// Certifies a map on the backend as it will be stored, into `solution`, and mends it. Returns whether a solver is done
/// with it: it is valid, or what is wrong with it is rounding only, which no solver can help.
/// \param resolution  of a certificate: how small faces may be that are mended, infinite for none. While it is not 0, a
///                    valid map with bad faces below it is not done with, either
template <class Backend, class Resolution>
bool certify_and_settle(const Backend& backend, const Problem& problem, const typename Backend::Vectors& v,
                        bool is_harmonic, Resolution resolution, Monitor& monitor, Solution& solution)
{
  const Stopwatch watch;
  const auto& loop = backend.host_loop();
  Host_array<vec3> x = in_doubles(backend, problem, v);
  solution.certificate = certify_as_stored(loop, problem, x);
  const bool is_valid =
    solution.certificate.is_valid() || (problem.as_stored && certify(loop, problem.face, x).is_valid());
  solution.seconds.certify += watch.seconds(); // mending is part of the solution
  const double smallest = resolution(solution.certificate);
  return mend(loop, problem, is_harmonic, smallest, monitor, std::move(x), solution) ||
         (is_valid && !(problem.is_intrinsic() && smallest > 0));
}

/// Hands the map over, certified and mended if that has not been done yet. Where it is not the one that the solver has
/// ended with, to the last bit, its residual and energy are measured again.
/// \param accuracy  that was asked for
/// \param measure   `measure(v, report)` sets residual and energy of the map v on the backend
template <class Backend, class Measure>
void finish(const Backend& backend, const Problem& problem, typename Backend::Vectors&& v, bool is_certified,
            bool is_harmonic, double accuracy, Measure measure, Monitor& monitor, Solution& solution)
{
  const Stopwatch watch;
  const auto& loop = backend.host_loop();
  if(solution.position.empty()) // it has not been mended
    solution.position = in_doubles(backend, problem, std::move(v));
  double mending_seconds = 0;
  if(!is_certified) {
    solution.certificate = certify_as_stored(loop, problem, solution.position);
    if(solution.report.has_converged) {
      const Stopwatch mending;
      mend(loop, problem, is_harmonic, 0, monitor, Host_array<vec3>(solution.position), solution);
      mending_seconds = mending.seconds();
    }
  }
  make_storable(loop, problem, solution.position);
  solution.accuracy = (std::max)(accuracy, residual_of_rounding(problem));
  const auto is_set = [](char moved) { return moved != 0; };
  if(problem.as_stored || std::any_of(solution.is_moved.begin(), solution.is_moved.end(), is_set)) {
    const typename Backend::Vectors& stored = backend.upload(solution.position);
    measure(stored, solution.report);
  }
  solution.report.energy *= problem.weight_unit;
  solution.seconds.solve += mending_seconds;
  solution.seconds.certify += watch.seconds() - mending_seconds;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_METHOD_SOLVER_H
