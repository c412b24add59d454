// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_LANDMARK_PLACEMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_LANDMARK_PLACEMENT_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/isometric/landmark_paths.h>
#include <CGAL/Spherical_parameterization/internal/isometric/newton_relaxation.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Rotates a valid map so that its landmarks are near their places in the sense of least squares, unless rounding would
/// make it invalid.
CGAL_SP_INLINE void rotate_to_landmarks(const Landmarks& landmarks, Map_level<>& level)
{
  std::vector<vec3> from, to;
  for(const Landmark& l : landmarks) {
    from.push_back(level.position()[level.index(l.vertex)]);
    to.push_back(l.place);
  }
  const Matrix_3 rotation = best_rotation(from, to);
  const Host_array<vec3> before = level.position();
  for(vec3& p : level.position())
    p = unit(rotated(rotation, p));
  if(!level.is_bijective())
    level.position() = before;
}

/// Pins the landmarks of a level that are placed; no other vertex is held.
CGAL_SP_INLINE void pin_placed(const Landmarks& landmarks, Map_level<>& level)
{
  level.release();
  for(const Landmark& l : landmarks)
    if(l.is_placed)
      level.pin(level.index(l.vertex));
}

/// Moves the landmarks of a level to their places, with the mesh round them, and pins them there. The map stays
/// bijective.
///
/// Landmarks are pulled by springs, whose energy is added to the distortion. Newton's method minimizes the sum: so the
/// mesh moves as a whole. A landmark is put to its place as soon as that lies in the kernel of its star, exactly. Where
/// the springs do not bring the landmarks on they become stiffer; where faces that are about to flip cut a step short,
/// softer.
///
/// At first the springs pull straight to the places. That brings landmarks home whose places fit the shape, and leaves
/// others stuck head to head. Then areas count less: so the mesh gives way at the tips of limbs, where it is small on
/// the sphere, and has to grow before landmarks can pass each other. Those that are stuck even so follow paths that do
/// not meet, a few edges at a time; after each step the mesh is relaxed while the landmarks are held.
template <class...>
class Landmark_placement {
public:
  Landmark_placement(const Watched_loop<Host_loop>& loop, const Distortion& distortion, Map_level<>& level,
                     Landmarks& landmarks, Landmark_budget& budget)
    : loop_(loop), full_distortion_(distortion), distortion_(distortion), level_(level), landmarks_(landmarks),
      budget_(budget)
  {}

  /// Returns whether all landmarks are placed. Those that are placed though others are not stay so only if the map is
  /// not much distorted thereby.
  bool run()
  {
    struct Stage {
      bool is_straight;
      double share_of_area_exponent;
    };
    for(const Stage stage : {Stage{true, 1}, Stage{true, 0.5}, Stage{false, 0.5}}) {
      is_straight_ = stage.is_straight;
      path_ = is_straight_ ? straight_paths() : Landmark_paths<>(loop_, level_, landmarks_, budget_).find();
      if(path_.empty())
        return false;
      const Host_array<vec3> position = level_.position();
      const Landmarks landmarks = landmarks_;
      const double energy = level_.energy(full_distortion_);
      distortion_ = full_distortion_.with_share_of_area(stage.share_of_area_exponent);
      const bool are_placed = follow_paths();
      distortion_ = full_distortion_;
      if(are_placed)
        return true;
      if(!relax(energy)) {
        level_.position() = position;
        landmarks_ = landmarks;
        pin_placed(landmarks_, level_);
      }
    }
    return false;
  }

private:
  static constexpr int maximum_iterations = 50;
  static constexpr double linear_tolerance = 0.1;

  std::vector<Path> straight_paths() const
  {
    std::vector<Path> paths;
    for(const Landmark& l : landmarks_)
      paths.push_back({level_.position()[level_.index(l.vertex)], l.place});
    return paths;
  }

  double step(Newton_relaxation<>& newton)
  {
    loop_.check();
    budget_.spend(level_.size());
    return newton.step(maximum_iterations, linear_tolerance);
  }

  void relax_locally()
  {
    level_.relax(distortion_);
    level_.relax_distorted(distortion_, level_.energy(distortion_));
  }

  /// After some landmarks got stuck: relaxes the map without springs. Returns whether the energy comes down to not much
  /// more than what it was before.
  bool relax(double energy)
  {
    constexpr int maximum_steps = 10;
    constexpr double least_gain = 0.01, tolerable = 1.5;
    pin_placed(landmarks_, level_);
    Newton_relaxation<> newton(loop_, distortion_, level_);
    for(int s = 0; s < maximum_steps; ++s) {
      const double gain = step(newton);
      level_.relax(distortion_);
      if(gain < least_gain && newton.promised_gain() < least_gain)
        break;
    }
    return level_.energy(distortion_) <= tolerable * energy;
  }

  bool follow_paths()
  {
    constexpr double softest = 1, first = 10, stiffest = 1e12, factor = 4;
    constexpr double short_step = 0.1, least_progress = 0.05;
    constexpr double share_of_rest = 0.1, share_of_way = 0.02; // that is progress enough to go on
    constexpr int patience = 15, most_steps = 400, least_steps = 60, work = 2000000;
    const int maximum_steps = (std::max)(least_steps, (std::min)(most_steps, work / level_.size()));
    reached_.assign(landmarks_.size(), 0);
    double stiffness = first;
    const double whole_way = way_to_go();
    double before = whole_way, milestone = whole_way;
    Newton_relaxation<> newton(loop_, distortion_, level_);
    for(int s = 0, since = 0; s < maximum_steps && !put_in_place(stiffness) && !budget_.is_spent(); ++s) {
      step(newton);
      const double length = newton.step_length();
      relax_locally();
      if(!is_straight_)
        relax_round_landmarks(newton);
      const double now = way_to_go();
      if(length < short_step)
        stiffness = (std::max)(stiffness / factor, softest);
      else if(now > (1 - least_progress) * before)
        stiffness *= factor;
      before = now;
      if(now < milestone - (is_straight_ ? share_of_rest * milestone : share_of_way * whole_way)) {
        milestone = now;
        since = 0;
      } else
        ++since;
      if(since > patience || stiffness > stiffest)
        break;
    }
    return put_in_place(stiffness);
  }

  /// Relaxes the map while the landmarks stay where they are.
  void relax_round_landmarks(Newton_relaxation<>& newton)
  {
    constexpr int maximum_steps = 5;
    constexpr double sufficient = 0.02; // gain that is left
    for(const Landmark& l : landmarks_)
      level_.pin(level_.index(l.vertex));
    for(int s = 0; s < maximum_steps; ++s) {
      step(newton);
      relax_locally();
      if(newton.promised_gain() < sufficient)
        break;
    }
  }

  /// Of all landmarks together, along their paths
  double way_to_go() const
  {
    double sum = 0;
    for(std::size_t k = 0; k < landmarks_.size(); ++k)
      if(!landmarks_[k].is_placed) {
        const std::size_t next = (std::min)(reached_[k] + 1, path_[k].size() - 1);
        sum += distance(level_.position()[level_.index(landmarks_[k].vertex)], path_[k][next]);
        for(std::size_t m = next + 1; m < path_[k].size(); ++m)
          sum += distance(path_[k][m - 1], path_[k][m]);
      }
    return sum;
  }

  /// The point of its path that landmark k is pulled to: the end, or one a few edges ahead.
  std::size_t next_point(std::size_t k)
  {
    constexpr double edges_ahead = 3, farthest = 0.3;
    const Path& path = path_[k];
    if(is_straight_)
      return path.size() - 1;
    const int i = level_.index(landmarks_[k].vertex);
    const vec3 x = level_.position()[i];
    double edges = 0;
    for(int c = level_.offset(i); c < level_.offset(i + 1); ++c)
      edges += distance(x, level_.position()[level_.corner(c).j]);
    const double ahead = (std::min)(farthest, edges_ahead * edges / (level_.offset(i + 1) - level_.offset(i)));

    std::size_t nearest = reached_[k];
    double way = 0;
    for(std::size_t m = nearest + 1; m < path.size(); ++m) {
      way += distance(path[m - 1], path[m]);
      if(way > ahead)
        break;
      if(distance(x, path[m]) < distance(x, path[nearest]))
        nearest = m;
    }
    reached_[k] = nearest;
    std::size_t next = (std::min)(nearest + 1, path.size() - 1);
    for(way = distance(path[nearest], path[next]); next + 1 < path.size() && way < ahead; ++next)
      way += distance(path[next], path[next + 1]);
    return next;
  }

  /// Puts landmarks to their places and pins them, as far as their stars stay valid; the others get springs. Returns
  /// whether all are in place.
  bool put_in_place(double stiffness)
  {
    bool are_placed = true;
    for(std::size_t k = 0; k < landmarks_.size(); ++k) {
      Landmark& l = landmarks_[k];
      if(l.is_placed)
        continue;
      const int i = level_.index(l.vertex);
      const std::size_t next = next_point(k);
      l.is_placed = next + 1 == path_[k].size() && is_valid_centre(level_.star(i), l.place);
      if(l.is_placed) {
        level_.position()[i] = l.place;
        level_.pin(i);
      } else
        level_.hold(i, {path_[k][next], stiffness});
      are_placed = are_placed && l.is_placed;
    }
    return are_placed;
  }

  const Watched_loop<Host_loop>& loop_;
  const Distortion full_distortion_;
  Distortion distortion_; ///< at the moment
  Map_level<>& level_;
  Landmarks& landmarks_;
  Landmark_budget& budget_;
  std::vector<Path> path_;           ///< of every landmark
  std::vector<std::size_t> reached_; ///< the point of its path where a landmark is
  bool is_straight_ = true;          ///< the paths are but their ends
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_LANDMARK_PLACEMENT_H
