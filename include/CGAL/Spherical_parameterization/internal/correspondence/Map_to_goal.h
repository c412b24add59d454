// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_MAP_TO_GOAL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_MAP_TO_GOAL_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Geodesic_graph.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/landmarks_in_place.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/internal/isometric/solve_isometric.h>
#include <CGAL/Spherical_parameterization/internal/locate/Locator.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The point of a surface that has this image.
inline vec3 point_at(const Registered_surface& surface, const Locator& locator, vec3 image)
{
  const auto [face, weight] = locator.locate(image);
  return mean_of_corners(surface.face[face], weight, surface.point);
}

/// Where the vertices of a surface A should go. Places and targets may be wrong by a little, and contradict each other.
struct Registration_goal {
  Host_array<vec3> place;                       ///< on the sphere
  Host_array<vec3> target;                      ///< on B
  std::vector<int> spread;                      ///< vertices, spread evenly, that are pulled to their places first
  std::vector<Registration_landmark> landmarks; ///< are where they should be in the end

  void put(int v, const Registered_surface& b, int vertex_of_b)
  {
    landmarks.push_back({v, b.image[vertex_of_b]});
    place[v] = b.image[vertex_of_b];
    target[v] = b.point[vertex_of_b];
  }

  /// \param candidates  for `spread`: those that are not torn off
  void spread_among(const std::vector<int>& candidates, const Geodesic_graph& graph, const Host_array<vec3>& point)
  {
    for(int v : candidates)
      if(!is_torn_off(v, graph, point))
        spread.push_back(v);
  }

private:
  /// Whether the target of a vertex is far from those of the vertices around it. A few such points, if they are held,
  /// drag whole limbs along.
  bool is_torn_off(int v, const Geodesic_graph& graph, const Host_array<vec3>& point) const
  {
    constexpr std::size_t around = 50;
    constexpr double limit = 1.5; // times as far
    std::vector<int> near = {v};
    for(std::size_t k = 0; k < near.size() && near.size() <= around; ++k)
      graph.for_each_way(near[k], [&](int w, double) {
        if(std::find(near.begin(), near.end(), w) == near.end())
          near.push_back(w);
      });
    const auto is_farther = [&](int w) {
      return norm(sub(target[w], target[v])) > limit * norm(sub(point[w], point[v]));
    };
    const auto farther = std::count_if(near.begin() + 1, near.end(), is_farther);
    return 2 * static_cast<std::size_t>(farther) > near.size() - 1;
  }
};

/// A map of a surface A whose vertices are near their targets on B: some are pulled to their places by the isometric
/// method, and then all of them move. It is without flips.
template <class...>
class Map_to_goal {
public:
  /// Pulls some vertices to their places. Throws Error if there is no time for that.
  /// \param begin, end  the stage of the work
  Map_to_goal(const Watched_loop<Host_loop>& loop, const Registered_surface& a, const Registered_surface& b,
              const Locator& locator_b, Registration_goal goal, double begin, double end)
    : loop_(loop), b_(b), goal_(std::move(goal)), from_{{a.face, a.twin}, a.point, {}}
  {
    constexpr double pull = 3000;
    constexpr int most_solutions = 3;
    Problem problem = isometric_problem(a.face, a.point);
    for(int v : goal_.spread)
      hold(problem, v, goal_.place[v]);
    Isometric method;
    method.landmark_weight = pull;
    const double part = (end - begin) / most_solutions;
    Solution solution;
    for(int k = 0; k < most_solutions && (k == 0 || is_held_anew(problem, goal_.landmarks, solution.position)); ++k)
      try {
        loop.monitor().begin_stage(begin + k * part, begin + (k + 1) * part);
        solution = solve_isometric(loop.bare(), method, problem, {}, loop.monitor());
      } catch(const Input_error&) { // no more time
        if(k == 0)
          throw;
        break; // the map before is as valid
      }
    if(!solution.certificate.is_valid())
      return;
    image_ = std::move(solution.position);
    put_in_place(loop.bare(), a.face, goal_.landmarks, loop.monitor(), image_);
    from_.image = image_;
    compare_with_targets(locator_b);
  }

  /// Of the vertices of A; empty if there is no valid map with these places.
  const Host_array<vec3>& image() const { return image_; }
  const Registration_goal& goal() const { return goal_; }

  /// Moves all vertices near their targets.
  /// \return the number of iterations
  std::size_t move_all()
  {
    constexpr double isometry_weight = 1, accuracy = 5e-3;
    constexpr int most_iterations = 50;
    if(image_.empty())
      return 0;
    return static_cast<std::size_t>(refine(loop_.bare(), from_, b_, targets_, goal_.landmarks,
                                           {0, isometry_weight, most_iterations, accuracy}, loop_.monitor(), image_)
                                      .iterations);
  }

private:
  /// After a map has been found: lets go of vertices that are still far from their places, since the others hold the
  /// map elsewhere, so these places are wrong; and takes hold of landmarks that are far. Returns whether there are any.
  static bool is_held_anew(Problem& problem, const std::vector<Registration_landmark>& landmarks,
                           const Host_array<vec3>& position)
  {
    constexpr double too_far = 0.2, too_far_for_landmarks = 0.1;
    const std::vector<char> before = problem.is_fixed;
    for(int v = 0; v < problem.size(); ++v)
      if(problem.is_fixed[v] && norm(sub(position[v], problem.given[v])) > too_far)
        problem.is_fixed[v] = 0;
    for(const Registration_landmark& l : landmarks)
      if(before[l.vertex] || norm(sub(position[l.vertex], l.place)) > too_far_for_landmarks)
        hold(problem, l.vertex, l.place);
    return problem.is_fixed != before;
  }

  void compare_with_targets(const Locator& locator_b)
  {
    constexpr double weight = 3000;
    constexpr double farthest = 0.5; // what is farther off pulls less, since it is more likely to be wrong
    Host_array<vec3>& target = goal_.target;
    loop_.for_each(static_cast<int>(target.size()), [&](int v) {
      const vec3 at = point_at(b_, locator_b, image_[v]), way = sub(target[v], at);
      if(const double square = inner(way, way); square > farthest * farthest)
        target[v] = add_scaled(at, farthest * farthest / square, way);
    });
    for(double vec3::*coordinate : {&vec3::x, &vec3::y, &vec3::z}) {
      for(const vec3& p : target)
        targets_.a.push_back(std::sqrt(weight) * p.*coordinate);
      for(const vec3& p : b_.point)
        targets_.b.push_back(std::sqrt(weight) * p.*coordinate);
      ++targets_.number;
    }
  }

  const Watched_loop<Host_loop>& loop_;
  const Registered_surface& b_;
  Registration_goal goal_;
  Registered_surface from_; ///< A, with the map whose deformation is held small
  Registration_features targets_;
  Host_array<vec3> image_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_MAP_TO_GOAL_H
