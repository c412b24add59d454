// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_SOLVE_ISOMETRIC_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_SOLVE_ISOMETRIC_IMPL_H

#include <CGAL/Spherical_parameterization/internal/isometric/Coarse_to_fine_map.h>
#include <CGAL/Spherical_parameterization/internal/isometric/canonical_order.h>
#include <CGAL/Spherical_parameterization/internal/isometric/solve_isometric.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// Throws the Error if a face cannot be positively oriented since all of its corners are fixed.
CGAL_SP_INLINE void check_fixed_faces(const Problem& problem)
{
  if(!problem.has_fixed())
    return;
  for(std::size_t f = 0; f < problem.face.size(); ++f) {
    const auto [i, j, k] = problem.face[f];
    if(problem.is_fixed[i] && problem.is_fixed[j] && problem.is_fixed[k] &&
       !is_positively_oriented(problem.place_of_fixed(i), problem.place_of_fixed(j), problem.place_of_fixed(k)))
      throw Input_error(Error_code::BAD_CONSTRAINTS,
                        "the fixed vertices " + std::to_string(problem.position[i]) + ", " +
                          std::to_string(problem.position[j]) + " and " + std::to_string(problem.position[k]) +
                          " are the corners of face " + std::to_string(f) + ", and would flip it");
  }
}

/// What a face is to cover of the sphere, in a unit that all faces have.
CGAL_SP_INLINE double target_area(const Problem& problem, int f)
{
  return (problem.density.empty() ? 1 : problem.density[f]) * norm(normal(problem.point, problem.face[f]));
}

/// Whether a face covers a part of the sphere that is much larger than what it is to cover: a local minimum.
CGAL_SP_INLINE bool has_giant_face(const Host_loop& loop, const Problem& problem, const Host_array<vec3>& position)
{
  constexpr double share = 0.05, factor = 20;
  const int number_of_faces = static_cast<int>(problem.face.size());
  const auto wanted = [&problem](int f) { return target_area(problem, f); };
  const double whole = sum_by_parts(loop, number_of_faces, wanted);
  const double giants = sum_by_parts(loop, number_of_faces, [&](int f) {
    const auto [i, j, k] = problem.face[f];
    const double area = spherical_area(position[i], position[j], position[k]) / (4 * pi);
    return area > share && area > factor * wanted(f) / whole ? 1. : 0.;
  });
  return giants > 0;
}

/// The smaller the exponent, the more limbs shrink, on coarse levels below the resolution of doubles: then the map is
/// computed again, with a larger one on these levels.
CGAL_SP_INLINE Host_array<vec3> map_above_resolution(const Watched_loop<Host_loop>& loop, const Isometric& method,
                                                     const Problem& problem, const Effort& effort,
                                                     Coarse_to_fine_map<>::Attempt attempt, Solver_report& report)
{
  constexpr double least_exponent = 0.1;
  const auto run = [&] {
    report = Solver_report();
    return Coarse_to_fine_map<>(loop, method, problem, effort, attempt).run(report);
  };
  try {
    return run();
  } catch(const Input_error& error) {
    if(error.code() != Error_code::NOT_BIJECTIVE || method.area_exponent.value_or(least_exponent) >= least_exponent)
      throw;
  }
  attempt.least_exponent = least_exponent;
  return run();
}

/// As `map_above_resolution()`; where its map has a giant face, the better one of it and a second map, which is less
/// likely to have one.
CGAL_SP_INLINE Host_array<vec3> map_of_attempt(const Watched_loop<Host_loop>& loop, const Isometric& method,
                                               const Problem& problem, const Effort& effort,
                                               Coarse_to_fine_map<>::Attempt attempt, Solver_report& report)
{
  constexpr double small_exponent = 0.5;
  Host_array<vec3> map = map_above_resolution(loop, method, problem, effort, attempt, report);
  if(problem.has_fixed() || area_exponent(method, problem) <= small_exponent ||
     !has_giant_face(loop.bare(), problem, map))
    return map;
  attempt.largest_tiny_exponent = small_exponent;
  try {
    Solver_report second;
    Host_array<vec3> other = map_above_resolution(loop, method, problem, effort, attempt, second);
    if(second.energy < report.energy) {
      report = second;
      return other;
    }
  } catch(const Input_error&) { // for want of time, mostly: the first map is there
  }
  return map;
}

/// Where landmarks get stuck, they do so by how the coarse mesh happens to be, or since the map of it is far from the
/// map of the whole mesh, which they may have been taken from. Then again, from the map without landmarks, on coarse
/// meshes that grow up to the whole mesh.
CGAL_SP_INLINE Host_array<vec3> map_of_attempts(const Watched_loop<Host_loop>& loop, const Isometric& method,
                                                const Problem& problem, const Effort& effort, Solver_report& report)
{
  constexpr int least_size = 500, vertices_per_landmark = 8, growth = 3;
  const auto landmarks = std::count(problem.is_fixed.begin(), problem.is_fixed.end(), 1);
  double size = (std::max)(double(least_size), vertices_per_landmark * double(landmarks));
  Landmark_budget budget(problem.size());
  const auto run = [&](const Problem& of, const Coarse_to_fine_map<>::Attempt& attempt) {
    return map_of_attempt(loop, method, of, effort, attempt, report);
  };
  const auto is_next_worth_while = [&](const Input_error& error) {
    return !budget.is_spent() &&
           (error.code() == Error_code::BAD_CONSTRAINTS || error.code() == Error_code::NOT_BIJECTIVE);
  };
  try {
    return run(problem, {static_cast<int>((std::min)(size, double(problem.size()))), false, &budget});
  } catch(const Input_error& error) {
    if(landmarks == 0 || !is_next_worth_while(error))
      throw;
  }
  Problem free = problem;
  free.is_fixed.clear();
  const Host_array<vec3> free_map = run(free, {0, true, &budget});
  for(; growth * size < problem.size(); size *= growth)
    try {
      return run(problem, {static_cast<int>(size), false, &budget, &free_map});
    } catch(const Input_error& error) {
      if(!is_next_worth_while(error))
        throw;
    }
  return run(problem, {problem.size(), true, &budget, &free_map});
}

/// See `Result::density_deviation`.
CGAL_SP_INLINE double density_deviation(const Host_loop& loop, const Problem& problem, const Host_array<vec3>& position)
{
  const int number_of_faces = static_cast<int>(problem.face.size());
  const auto wanted = [&problem](int f) { return target_area(problem, f); };
  const auto log_of_share = [&](int f) {
    const auto [i, j, k] = problem.face[f];
    constexpr double least = 1e-300;
    return std::log((std::max)(spherical_area(position[i], position[j], position[k]) / (4 * pi), least) / wanted(f));
  };
  const auto sum = [&](auto value) { // weighted
    return sum_by_parts(loop, number_of_faces, [&](int f) { return wanted(f) > 0 ? wanted(f) * value(f) : 0; });
  };
  const double whole = sum([](int) { return 1; });
  if(!(whole > 0))
    return 0;
  return std::sqrt(sum([&](int f) { return std::pow(log_of_share(f) + std::log(whole), 2); }) / whole);
}

CGAL_SP_CORE Solution solve_isometric(const Host_loop& loop, const Isometric& method, const Problem& problem,
                                      const Effort& effort, Monitor& monitor)
{
  const Stopwatch watch;
  if(std::isinf(method.landmark_weight))
    check_fixed_faces(problem);
  Solution solution;
  Host_array<int> vertex;
  const Watched_loop watched(loop, monitor);
  const Problem canonical = in_canonical_order(watched, problem, vertex);
  const Host_array<vec3> position = map_of_attempts(watched, method, canonical, effort, solution.report);
  solution.position.resize(problem.size());
  for_each_index(loop, problem.size(), [&](int i) { solution.position[vertex[i]] = position[i]; });
  solution.accuracy = effort.accuracy.value_or(Isometric::default_accuracy);
  solution.seconds.solve = watch.seconds();

  const Stopwatch certify_watch;
  make_storable(loop, problem, solution.position);
  if(!problem.density.empty())
    solution.report.density_deviation = density_deviation(loop, problem, solution.position);
  solution.certificate = certify(loop, problem.face, solution.position);
  solution.seconds.certify = certify_watch.seconds();
  return solution;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_SOLVE_ISOMETRIC_IMPL_H
