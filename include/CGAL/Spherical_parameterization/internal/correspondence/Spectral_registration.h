// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REGISTRATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REGISTRATION_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/values/Rotation.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Map_to_goal.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_matching.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/coarse_map.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/internal/locate/Locator.h>
#include <CGAL/Spherical_parameterization/internal/surface/match_halfedges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A first bijection of two surfaces: `Spectral_matching` says where the vertices of A belong on B, on coarse surfaces;
/// A is mapped to the sphere anew, so that some of them lie where these points of B are; and that map is deformed until
/// all of them are near. Of answers that are nearly as good, that one is taken whose map brings together what looks
/// alike. A fine surface follows the coarse one in the same two steps. Maps keep the barrier of their energies: they
/// are without flips.
template <class...>
class Spectral_registration {
public:
  static constexpr int least_vertices = 100; ///< below there are too few eigenfunctions

  Host_array<vec3> image;            ///< of the vertices of A; empty if there is no valid map with these places
  Rotation rotation;                 ///< of A's map, which comes nearest
  double margin = 0, difference = 0; ///< see `Registration_result`
  std::size_t iterations = 0;        ///< of the deformation

  /// \param features   what decides between answers that are nearly as good
  /// \param landmarks  vertices of A and B
  Spectral_registration(const Watched_loop<Host_loop>& loop, const Registered_surface& a, const Registered_surface& b,
                        const Locator& locator_b, const Registration_features& features,
                        const std::vector<std::pair<int, int>>& landmarks)
    : loop_(loop), b_(b)
  {
    std::vector<int> landmark_of_a, landmark_of_b;
    for(const auto& [v, w] : landmarks) {
      landmark_of_a.push_back(v);
      landmark_of_b.push_back(w);
    }
    loop.monitor().begin_stage(0, Spectral_matching<Host_loop>::share_of_work / 3); // which the matching shares
    const Coarse_map coarse_a(loop, a, landmark_of_a, most_vertices), coarse_b(loop, b, landmark_of_b, most_vertices);
    typename Spectral_matching<Host_loop>::Landmarks coarse_landmarks;
    for(const auto& [v, w] : landmarks)
      coarse_landmarks.emplace_back(coarse_a.number_of(v), coarse_b.number_of(w));
    const Spectral_shape<Host_loop> shape_a(loop.bare(), coarse_a, loop.monitor()),
      shape_b(loop.bare(), coarse_b, loop.monitor());
    // Where the shapes say the same as landmarks, these change nothing, but for what they are moved by in the end
    auto answers = Spectral_matching<Host_loop>(loop, shape_a, shape_b, coarse_landmarks, false).run();
    if(!answers.front().fits_landmarks)
      answers = Spectral_matching<Host_loop>(loop, shape_a, shape_b, coarse_landmarks, true).run();

    const int n = coarse_a.number_of_vertices;
    Registered_surface surface;
    surface.face = coarse_a.face;
    match_halfedges(loop.bare(), surface.face, n, surface.twin);
    for(int v : coarse_a.vertex) {
      surface.point.push_back(a.point[v]);
      surface.image.push_back(a.image[v]);
    }
    const std::vector<int> candidates = {shape_a.sample.begin(),
                                         shape_a.sample.begin() +
                                           (std::min)(most_places, static_cast<int>(shape_a.sample.size()))};
    const auto goal_of = [&](const auto& answer) {
      Registration_goal goal;
      for(int t : answer.map) {
        goal.place.push_back(shape_b.image[t]);
        goal.target.push_back(b.point[coarse_b.vertex[t]]);
      }
      for(std::size_t l = 0; l < landmarks.size(); ++l)
        goal.put(coarse_landmarks[l].first, b, landmarks[l].second);
      goal.spread_among(candidates, shape_a.graph, surface.point);
      return goal;
    };
    const auto stages = static_cast<double>(answers.size());
    std::optional<Map_to_goal<>> best;
    double least = 0;
    for(std::size_t k = 0; k < answers.size(); ++k)
      try {
        Map_to_goal<> map(loop, surface, b, locator_b, goal_of(answers[k]), 0.3 + 0.2 * k / stages,
                          0.3 + 0.2 * (k + 1) / stages);
        double score = answers[k].score;
        if(answers.size() > 1)
          score += map.image().empty() ? std::numeric_limits<double>::infinity()
                                       : std::log(mismatch(surface, coarse_a.vertex, features, map.image()));
        if(k == 0 || score < least) {
          least = score;
          margin = answers[k].margin;
          difference = answers[k].difference;
          best.emplace(std::move(map));
        }
      } catch(const Input_error&) { // no more time
        if(k == 0)
          throw;
        break;
      }
    rotation = best_rotation(surface.image, best->goal().place);
    loop.monitor().begin_stage(0.5, 0.55);
    iterations += best->move_all();
    image = best->image();
    if(image.empty() || n == static_cast<int>(a.point.size()))
      return;

    // The whole surface follows the coarse one
    const Locator locator_a(loop.bare(), Valid_map(coarse_a, loop.bare()));
    Registration_goal goal;
    goal.place.resize(a.point.size());
    goal.target.resize(a.point.size());
    loop.for_each(static_cast<int>(a.point.size()), [&](int v) {
      const auto [face, weight] = locator_a.locate(a.image[v]);
      goal.place[v] = unit(mean_of_corners(coarse_a.face[face], weight, image));
      goal.target[v] = point_at(b, locator_b, goal.place[v]);
    });
    for(const auto& [v, w] : landmarks)
      goal.put(v, b, w);
    for(int v : best->goal().spread)
      goal.spread.push_back(coarse_a.vertex[v]);
    Map_to_goal<> map(loop, a, b, locator_b, std::move(goal), 0.55, 0.67);
    loop.monitor().begin_stage(0.67, 0.8);
    iterations += map.move_all();
    image = map.image();
  }

private:
  static constexpr int most_vertices = 5500, most_places = 100;

  /// Root mean square, of the features where x puts the vertices of a coarse surface, which are those vertices of A.
  double mismatch(const Registered_surface& coarse_a, const std::vector<int>& vertex,
                  const Registration_features& features, Host_array<vec3> x) const
  {
    Registration_features coarse = {features.number, {}, features.b};
    for(int k = 0; k < features.number; ++k)
      for(int v : vertex)
        coarse.a.push_back(features.a[k * (features.a.size() / features.number) + v]);
    return std::sqrt(refine(loop_.bare(), coarse_a, b_, coarse, {}, {0, 0, 0, 0}, loop_.monitor(), x).mismatch);
  }

  const Watched_loop<Host_loop>& loop_;
  const Registered_surface& b_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_SPECTRAL_REGISTRATION_H
