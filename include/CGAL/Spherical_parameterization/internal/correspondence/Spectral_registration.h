// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REGISTRATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REGISTRATION_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Rotation.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Geodesic_graph.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_matching.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_shape.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/coarse_map.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/landmarks_in_place.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/internal/isometric/solve_isometric.h>
#include <CGAL/Spherical_parameterization/internal/locate/Locator.h>
#include <CGAL/Spherical_parameterization/internal/surface/match_halfedges.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A first bijection of two surfaces: `Spectral_matching` says where the vertices of A belong on B, on coarse surfaces;
/// A is mapped to the sphere anew, so that some of them lie where these points of B are; and that map is deformed until
/// all of them are near. A fine surface follows the coarse one in the same two steps. Maps keep the barrier of their
/// energies: they are without flips.
template <class...>
class Spectral_registration {
public:
  static constexpr int least_vertices = 100; ///< below there are too few eigenfunctions

  Host_array<vec3> image;            ///< of the vertices of A; empty if there is no valid map with these places
  Rotation rotation;                 ///< of A's map, which comes nearest
  double margin = 0, difference = 0; ///< see `Registration_result`
  std::size_t iterations = 0;        ///< of the deformation

  /// \param landmarks  vertices of A and B
  Spectral_registration(const Watched_loop<Host_loop>& loop, Monitor& monitor, const Registered_surface& a,
                        const Registered_surface& b, const Locator& locator_b,
                        const std::vector<std::pair<int, int>>& landmarks)
    : loop_(loop), monitor_(monitor), b_(b), locator_b_(locator_b)
  {
    std::vector<int> landmark_of_a, landmark_of_b;
    for(const auto& [v, w] : landmarks) {
      landmark_of_a.push_back(v);
      landmark_of_b.push_back(w);
    }
    monitor.begin_stage(0, Spectral_matching<Host_loop>::share_of_work / 3); // which the matching shares
    const Coarse_map coarse_a = coarse(a, landmark_of_a), coarse_b = coarse(b, landmark_of_b);
    typename Spectral_matching<Host_loop>::Landmarks coarse_landmarks;
    for(const auto& [v, w] : landmarks)
      coarse_landmarks.emplace_back(coarse_a.number_of(v), coarse_b.number_of(w));
    const Spectral_shape<Host_loop> shape_a(loop.bare(), coarse_a, monitor), shape_b(loop.bare(), coarse_b, monitor);
    // Where the shapes say the same as landmarks, these change nothing, but for what they are moved by in the end
    auto match = Spectral_matching<Host_loop>(loop, shape_a, shape_b, coarse_landmarks, false).run();
    if(!match.fits_landmarks)
      match = Spectral_matching<Host_loop>(loop, shape_a, shape_b, coarse_landmarks, true).run();
    margin = match.margin;
    difference = match.difference;

    const int n = coarse_a.number_of_vertices;
    Registered_surface surface;
    surface.face = coarse_a.face;
    match_halfedges(loop.bare(), surface.face, n, surface.twin);
    Host_array<vec3> place, target;
    for(int i = 0; i < n; ++i) {
      surface.point.push_back(a.point[coarse_a.vertex[i]]);
      surface.image.push_back(a.image[coarse_a.vertex[i]]);
      place.push_back(shape_b.image[match.map[i]]);
      target.push_back(b.point[coarse_b.vertex[match.map[i]]]);
    }
    std::vector<Registration_landmark> in_place;
    for(std::size_t k = 0; k < landmarks.size(); ++k) {
      const int v = coarse_landmarks[k].first, w = landmarks[k].second;
      in_place.push_back({v, b.image[w]});
      place[v] = b.image[w];
      target[v] = b.point[w];
    }
    rotation = best_rotation(surface.image, place);
    std::vector<int> spread;
    for(int k = 0; k < (std::min)(most_places, static_cast<int>(shape_a.sample.size())); ++k)
      if(const int v = shape_a.sample[k]; !is_torn_off(v, shape_a.graph, surface.point, target))
        spread.push_back(v);
    image = moved_to(surface, spread, place, target, in_place, 0.3, 0.55);
    if(image.empty() || n == static_cast<int>(a.point.size()))
      return;

    // The whole surface follows the coarse one
    const Locator locator_a(loop.bare(), Valid_map(coarse_a, loop.bare()));
    Host_array<vec3> all_places(a.point.size()), all_targets(a.point.size());
    loop.for_each(static_cast<int>(a.point.size()), [&](int v) {
      const auto [face, weight] = locator_a.locate(a.image[v]);
      all_places[v] = unit(mean_of_corners(coarse_a.face[face], weight, image));
      all_targets[v] = on_b(all_places[v]);
    });
    for(std::size_t k = 0; k < landmarks.size(); ++k) {
      const auto& [v, w] = landmarks[k];
      in_place[k].vertex = v;
      all_places[v] = b.image[w];
      all_targets[v] = b.point[w];
    }
    for(int& v : spread)
      v = coarse_a.vertex[v];
    image = moved_to(a, spread, all_places, all_targets, in_place, 0.55, 0.8);
  }

private:
  static constexpr int most_vertices = 5500, most_places = 100;

  Coarse_map coarse(const Registered_surface& surface, const std::vector<int>& kept) const
  {
    return Coarse_map(loop_.bare(), surface, surface.point, surface.image, kept, most_vertices, monitor_);
  }

  /// Whether the target of a vertex is far from those of the vertices around it. A few such points, if they are held,
  /// drag whole limbs along.
  static bool is_torn_off(int v, const Geodesic_graph& graph, const Host_array<vec3>& point,
                          const Host_array<vec3>& target)
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

  /// The point of B that has this image.
  vec3 on_b(vec3 q) const
  {
    const auto [face, weight] = locator_b_.locate(q);
    return mean_of_corners(b_.face[face], weight, b_.point);
  }

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

  /// A map of a surface with some vertices, spread evenly, near their places, and then all of them near their targets
  /// on B. Places and targets may be wrong by a little, and contradict each other. Landmarks are where they should be.
  Host_array<vec3> moved_to(const Registered_surface& a, const std::vector<int>& spread, const Host_array<vec3>& place,
                            Host_array<vec3> target, const std::vector<Registration_landmark>& landmarks, double begin,
                            double end)
  {
    constexpr double pull = 3000, target_weight = 3000, isometry_weight = 1, accuracy = 1e-3;
    constexpr double farthest = 0.5; // what is farther off pulls less, since it is more likely to be wrong
    constexpr int most_iterations = 50, most_solutions = 3;
    const int n = static_cast<int>(a.point.size());
    Problem problem = isometric_problem(a.face, a.point);
    for(int v : spread)
      hold(problem, v, place[v]);
    Isometric method;
    method.landmark_weight = pull;
    const double middle = (begin + end) / 2, part = (middle - begin) / most_solutions;
    Solution solution;
    for(int k = 0; k < most_solutions && (k == 0 || is_held_anew(problem, landmarks, solution.position)); ++k)
      try {
        monitor_.begin_stage(begin + k * part, begin + (k + 1) * part);
        solution = solve_isometric(loop_.bare(), method, problem, {}, monitor_);
      } catch(const Input_error&) { // no more time
        if(k == 0)
          throw;
        break; // the map before is as valid
      }
    if(!solution.certificate.is_valid())
      return {};
    Host_array<vec3>& x = solution.position;
    put_in_place(loop_.bare(), a.face, landmarks, monitor_, x);

    loop_.for_each(n, [&](int v) {
      const vec3 at = on_b(x[v]), way = sub(target[v], at);
      if(const double square = inner(way, way); square > farthest * farthest)
        target[v] = add_scaled(at, farthest * farthest / square, way);
    });
    monitor_.begin_stage(middle, end);
    Registration_features features;
    for(double vec3::*coordinate : {&vec3::x, &vec3::y, &vec3::z}) {
      for(const vec3& p : target)
        features.a.push_back(std::sqrt(target_weight) * p.*coordinate);
      for(const vec3& p : b_.point)
        features.b.push_back(std::sqrt(target_weight) * p.*coordinate);
      ++features.number;
    }
    const Registered_surface from = {{a.face, a.twin}, a.point, x};
    iterations += static_cast<std::size_t>(
      refine(loop_.bare(), from, b_, features, landmarks, {0, isometry_weight, most_iterations, accuracy}, monitor_, x)
        .iterations);
    return std::move(x);
  }

  const Watched_loop<Host_loop>& loop_;
  Monitor& monitor_;
  const Registered_surface& b_;
  const Locator& locator_b_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REGISTRATION_H
