// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The way of a map from the backend of a method of springs to the solution that is handed over: it is certified as it
// will be stored, mended, and measured again where mending or rounding has changed it.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SETTLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SETTLE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/mend.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

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

/// Mends the bad faces of a certified map of conformal springs, see `mend()`; if that is `DONE`, `solution` has the
/// positions.
/// \param is_harmonic  whether the springs have the exponent 2. If not, they trade angles for areas, and none but
///                     flipped faces are bad
CGAL_SP_INLINE Mending mend_conformal(const Host_loop& loop, const Problem& problem, bool is_harmonic,
                                      double resolution, Monitor& monitor, Host_array<vec3>&& v, Solution& solution)
{
  constexpr double tolerated = 2; // MIPS: stretches in the ratio 3.7
  if(!problem.is_intrinsic() || solution.certificate.degree != 1)
    return Mending::FAILED;
  const double bound = is_harmonic ? tolerated : std::numeric_limits<double>::infinity();
  std::vector<char> is_moved(problem.size(), 0);
  const Mending mending =
    mend(loop, problem.face, problem.point, problem.is_fixed, bound, resolution, monitor, v, is_moved);
  if(mending != Mending::DONE)
    return mending;
  const Certificate certificate = certify_as_stored(loop, problem, v);
  if(certificate.degree != 1) // possible where nearly all vertices were moved
    return Mending::FAILED;
  if(certificate.is_valid() || !solution.certificate.is_valid()) { // rounding to floats may flip what was valid
    solution.certificate = certificate;
    solution.position = std::move(v);
    solution.is_moved = std::move(is_moved);
  }
  return Mending::DONE;
}

/// Whether a solver is done with a map.
enum class Settled {
  YES,           ///< it is valid, or what is wrong with it is rounding only, which no solver can help
  NOT_YET,       ///< it may be at a finer accuracy, or from another start
  BEYOND_MENDING ///< the same, and `Mending::TOO_MUCH`
};

/// Certifies a map on the backend as it will be stored, into `solution`, and mends it.
/// \param resolution  of a certificate and its map: how small faces may be that are mended, infinite for none. While it
///                    is not 0, a valid map with bad faces below it is not done with, either
template <class Backend, class Resolution>
Settled settle(const Backend& backend, const Problem& problem, const typename Backend::Vectors& v, bool is_harmonic,
               Resolution resolution, Monitor& monitor, Solution& solution)
{
  const Stopwatch watch;
  const auto& loop = backend.host_loop();
  Host_array<vec3> x = in_doubles(backend, problem, v);
  solution.certificate = certify_as_stored(loop, problem, x);
  const bool is_valid =
    solution.certificate.is_valid() || (problem.as_stored && certify(loop, problem.face, x).is_valid());
  solution.seconds.certify += watch.seconds(); // mending is part of the solution
  const double smallest = resolution(solution.certificate, x);
  const Mending mending = mend_conformal(loop, problem, is_harmonic, smallest, monitor, std::move(x), solution);
  if(mending == Mending::DONE || (is_valid && !(problem.is_intrinsic() && smallest > 0)))
    return Settled::YES;
  return mending == Mending::TOO_MUCH ? Settled::BEYOND_MENDING : Settled::NOT_YET;
}

/// Hands the map over, certified and mended if that has not been done yet. Where it is not the one that the solver has
/// ended with, to the last bit, its residual and energy are measured again.
/// \param accuracy  that was asked for
/// \param measure   `measure(v, report)` sets residual and energy of the map v on the backend
template <class Backend, class Measure>
void hand_over(const Backend& backend, const Problem& problem, typename Backend::Vectors&& v, bool is_certified,
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
      mend_conformal(loop, problem, is_harmonic, 0, monitor, Host_array<vec3>(solution.position), solution);
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SETTLE_H
