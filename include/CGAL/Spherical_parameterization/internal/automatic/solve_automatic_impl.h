// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AUTOMATIC_SOLVE_AUTOMATIC_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AUTOMATIC_SOLVE_AUTOMATIC_IMPL_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/automatic/solve_automatic.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/problem/attempt.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// What was wrong with the attempts before the chosen one; with that itself, if it is valid and of no use.
inline std::string fallback_reason(const Problem& problem, const std::vector<Result::Attempt>& attempts,
                                   std::size_t chosen)
{
  std::string reason = problem.missing_weights;
  for(std::size_t k = 0; k <= chosen && k < attempts.size(); ++k)
    if(k < chosen || (attempts[k].error == Error_code::OK && !attempts[k].detail.empty()))
      reason += (reason.empty() ? "" : "; ") + attempts[k].method + ": " + attempts[k].detail;
  return reason;
}

/// The share of the surface that is limbs of which a valid map leaves next to nothing: it shrinks their lengths more
/// than so many times, against their mean. The spikes of noise, of a few faces each, are no limbs of a fine mesh.
inline double shrunk_share(const Host_loop& loop, const Problem& problem, const Host_array<vec3>& position,
                           double times)
{
  constexpr double least_limb = 1e-4; // of the faces
  const auto area = [&](int f) { return problem.area_of_face(f); };
  const double whole = sum_by_parts(loop, problem.number_of_faces(), area);
  const double least = 4 * pi / whole / times / times; // area on the sphere, per area of the surface
  const std::vector<int> shrunk = faces_where(
    loop, problem.face,
    [&](int f, const std::array<vec3, 3>& x) { return std::abs(spherical_area(x[0], x[1], x[2])) < least * area(f); },
    position);

  // Faces with a common corner are of the same limb.
  std::vector<int> corners;
  for(int f : shrunk)
    corners.insert(corners.end(), problem.face[f].begin(), problem.face[f].end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  const auto place = [&](int v) { return std::lower_bound(corners.begin(), corners.end(), v) - corners.begin(); };
  boost::disjoint_sets_with_storage<> limbs(corners.size());
  for(int f : shrunk)
    for(int k : {1, 2})
      limbs.union_set(place(problem.face[f][0]), place(problem.face[f][k]));
  std::vector<int> faces_of_limb(corners.size(), 0);
  const auto limb = [&](int f) { return limbs.find_set(place(problem.face[f][0])); };
  for(int f : shrunk)
    ++faces_of_limb[limb(f)];
  double of_limbs = 0;
  for(int f : shrunk)
    if(faces_of_limb[limb(f)] >= least_limb * problem.number_of_faces())
      of_limbs += area(f);
  return of_limbs / whole;
}

template <class Backend>
Solution Method_solver<Automatic>::solve(const Backend& backend, const Problem& problem, const Effort& effort,
                                         Monitor& monitor) const
{
  constexpr double negligible_share = 1e-3; // of the surface
  Solution best;
  bool is_best_extreme = false;
  std::size_t chosen = 0;
  std::vector<Result::Attempt> attempts;
  Result::Seconds seconds;
  // What is not what was asked for is worst, then what is not covered once; then flipped faces count.
  const auto badness = [](const Solution& s) {
    return std::tuple(s.error != Error_code::OK, s.certificate.degree != 1, s.certificate.flipped_faces);
  };
  const auto try_method = [&](const auto& solver, const Effort& its_effort, double begin, double end) {
    monitor.begin_stage(begin, end);
    Solution solution = attempt(backend, solver, problem, its_effort, monitor);
    attempts.insert(attempts.end(), solution.attempts.begin(), solution.attempts.end());
    seconds.start_map += solution.seconds.start_map;
    seconds.solve += solution.seconds.solve;
    seconds.certify += solution.seconds.certify;
    const bool is_valid = solution.error == Error_code::OK;
    const Stopwatch watch;
    const double shrunk =
      is_valid ? shrunk_share(backend.host_loop(), problem, solution.position, method_.largest_shrinkage) : 0;
    seconds.certify += watch.seconds();
    const bool is_extreme = shrunk > negligible_share;
    if(is_extreme)
      attempts.back().detail = "valid, but lengths shrink more than " + to_string(method_.largest_shrinkage) +
                               " times on " + to_string(100 * shrunk) + " % of the surface";
    const bool is_better = solution.has_map() && (is_best_extreme ? !is_extreme && solution.certificate.is_valid()
                                                                  : badness(solution) < badness(best));
    // Which landmarks contradict the mesh is of more use than a map that is not valid.
    const bool is_refusal = solution.error == Error_code::BAD_CONSTRAINTS && best.error != Error_code::OK;
    if((is_valid && !is_extreme) || !best.has_map() || is_better || is_refusal) {
      best = std::move(solution);
      is_best_extreme = is_extreme;
      chosen = attempts.size() - 1;
    }
    return (is_valid && !is_extreme) || monitor.is_interrupted();
  };
  const bool has_springs = problem.graph != nullptr; // none with densities, nor where a face has no area for a weight
  // Limbs that are of no use now are of none when they have been mended. On small meshes that is tried all the same.
  const auto is_hopeless = [&](const Host_array<vec3>& x) {
    constexpr int small_size = 10000;
    return problem.size() > small_size &&
           shrunk_share(backend.host_loop(), problem, x, method_.largest_shrinkage) > negligible_share;
  };
  if(!has_springs ||
     !try_method(Method_solver<Balanced>(Balanced{method_.spring_exponent}, is_hopeless), effort, 0, 0.5))
    try_method(Method_solver<Isometric>(Isometric{method_.area_exponent}), Effort(), // what was given is for springs
               has_springs ? 0.5 : 0, 1);
  if((best.error != Error_code::OK || is_best_extreme) && best.error != Error_code::INTERRUPTED &&
     monitor.is_interrupted()) {
    best.error = Error_code::INTERRUPTED;
    best.termination = monitor.termination();
    best.detail = best.has_map() ? monitor.reason() + "; the best map so far: " + attempts[chosen].detail
                                 : monitor.reason_without_map();
    best.remedy.clear();
  }
  best.attempts = std::move(attempts);
  best.seconds = seconds;
  best.fallback_reason = fallback_reason(problem, best.attempts, chosen);
  return best;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AUTOMATIC_SOLVE_AUTOMATIC_IMPL_H
