// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_IMPL_H

#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Patch.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/mend.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

constexpr Metric_bounds bounds_of_mending = {1e6, 1e-30};

/// The faces that have a corner in a set of vertices.
CGAL_SP_INLINE std::vector<int> faces_at(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                                         const std::vector<char>& is_in_set)
{
  return faces_where(loop, face,
                     [&](int f) { return is_in_set[face[f][0]] || is_in_set[face[f][1]] || is_in_set[face[f][2]]; });
}

typedef std::vector<Patch::Part> Patches;

/// The patches of the vertices that move: the sets of them that faces connect.
CGAL_SP_INLINE Patches patches_of(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                                  const std::vector<char>& is_moving)
{
  const std::vector<int> concerned = faces_at(loop, face, is_moving);
  Host_array<int> number(is_moving.size()); // of moving vertices, in the order in which faces name them
  std::vector<int> moving;
  for(int g : concerned)
    for(int i : face[g])
      number[i] = -1;
  for(int g : concerned)
    for(int i : face[g])
      if(is_moving[i] && number[i] < 0) {
        number[i] = static_cast<int>(moving.size());
        moving.push_back(i);
      }

  boost::disjoint_sets_with_storage<> sets(moving.size());
  for(int g : concerned)
    for(int m = 0; m < 3; ++m)
      if(const int i = face[g][m], j = face[g][(m + 1) % 3]; is_moving[i] && is_moving[j])
        sets.union_set(number[i], number[j]);

  Patches patches;
  std::vector<int> patch_of(moving.size(), -1), place(moving.size()); // the former by set
  for(std::size_t k = 0; k < moving.size(); ++k) {
    int& patch = patch_of[sets.find_set(k)];
    if(patch < 0) {
      patch = static_cast<int>(patches.size());
      patches.emplace_back();
    }
    place[k] = static_cast<int>(patches[patch].vertices.size());
    patches[patch].vertices.push_back(moving[k]);
  }
  for(int g : concerned) {
    Patch::Face of_patch = {face[g], {-1, -1, -1}, {}, 0, 0};
    int patch = -1;
    for(int m = 0; m < 3; ++m)
      if(const int i = face[g][m]; is_moving[i]) {
        of_patch.moving[m] = place[number[i]];
        patch = patch_of[sets.find_set(number[i])];
      }
    patches[patch].faces.push_back(of_patch);
  }
  return patches;
}

/// Calls f(patch) for all patches, in any order, each of which lives that long. Those that take long come one by one,
/// on the thread of the caller: it is the one that may call his callback.
template <class F>
void for_each_patch(const Host_loop& loop, Patches& patches, Host_array<vec3>& v, F f)
{
  constexpr std::size_t large = 2000;
  const auto work_on = [&](Patch::Part& part) {
    Patch patch(part, v);
    f(patch);
  };
  std::vector<Patch::Part*> small;
  for(Patch::Part& part : patches)
    if(part.vertices.size() > large)
      work_on(part);
    else
      small.push_back(&part);
  loop.for_each(static_cast<int>(small.size()), [&](int k) { work_on(*small[k]); });
}

/// Makes all faces of a patch positive, if it can, by Newton's method for energies that are regularized less and less.
/// Returns whether it could.
CGAL_SP_INLINE bool untangle(const Host_array<vec3>& point, Monitor& monitor, Patch& patch)
{
  constexpr int most_steps = 200;
  constexpr Metric_bounds bounds = {30, 1e-30}; // needles are untangled as if they were better
  constexpr double largest_start = 1e-3, least_regularization = 1e-7, share_of_worst = 0.2;
  constexpr double sufficient_gain = 1e-2, slowest = 0.5, fastest = 0.1; // when, and how fast, it is regularized less
  constexpr double smallest_face = 1e-24;                                // what doubles tell apart on the sphere
  constexpr double damping = 1e-8;

  // Faces should have the size of the largest one at their corners that move.
  std::vector<Patch::Face>& faces = patch.faces();
  std::vector<double> largest(patch.size(), smallest_face);
  for(Patch::Face& f : faces) {
    f.metric = face_metric(point[f.corner[0]], point[f.corner[1]], point[f.corner[2]], bounds);
    f.twice_area = (std::max)(smallest_face, patch.star_face(f).dirichlet(patch.position(f.corner[0])));
    for(int i : f.moving)
      if(i >= 0)
        largest[i] = (std::max)(largest[i], f.twice_area);
  }
  for(Patch::Face& f : faces) {
    for(int i : f.moving)
      if(i >= 0)
        f.twice_area = (std::max)(f.twice_area, largest[i]);
    f.weight = 1 / f.twice_area;
  }

  const auto share_of_most_negative = [&] {
    double ratio = 0;
    for(const Patch::Face& f : faces)
      ratio = (std::min)(ratio, patch.star_face(f).determinant(patch.position(f.corner[0])) / f.twice_area);
    return share_of_worst * std::abs(ratio);
  };
  double regularization = (std::max)(share_of_most_negative(), largest_start);
  for(int steps = 0; steps < most_steps && regularization > least_regularization && monitor.may_go_on(); ++steps) {
    const Patch::Step step = patch.step(Untangling_energy(regularization), damping);
    if(patch.has_positive_faces())
      return true;
    if(step.gain < sufficient_gain * step.energy)
      regularization = std::clamp(share_of_most_negative(), fastest * regularization, slowest * regularization);
  }
  return false;
}

/// Newton's method for MIPS, on a patch of positive faces. Returns whether it ended at a minimum, and was not sliding
/// on when nothing was gained any more: its steps got no shorter.
CGAL_SP_INLINE bool minimize_mips(double damping, Monitor& monitor, Patch& patch)
{
  constexpr int most_steps = 100, most_vain_steps = 8;
  constexpr double short_step = 1e-4;                         // to the faces around: Newton's method squares it
  constexpr double short_on_sphere = 1e-9, small_gain = 1e-4; // of the energy
  constexpr double much_shorter = 0.5;
  int vain_steps = 0; // since the last one that gained or was much shorter than any before
  double shortest = std::numeric_limits<double>::infinity();
  for(int steps = 0; steps < most_steps && vain_steps < most_vain_steps && monitor.may_go_on(); ++steps) {
    const Patch::Step step = patch.step(Distortion(0), damping);
    const bool is_small = step.gain < small_gain * step.energy;
    if(!step.is_taken || step.length < short_step || (step.length_on_sphere < short_on_sphere && is_small))
      return true;
    const bool is_vain = is_small && step.length > much_shorter * shortest;
    vain_steps = is_vain ? vain_steps + 1 : 0;
    shortest = (std::min)(shortest, step.length);
  }
  return false;
}

/// Moves a patch of positive faces to the minimum of MIPS.
///
/// To move a limb within the patch as a whole may cost an energy that is nothing beside that of its faces. Hardly any
/// damping is what it takes to find its place all the same. A limb whose place is below the rounding of its faces
/// slides on for ever: then a damping that holds it where it was. What is stiffer is at its minimum in the end,
/// whatever the numbers of vertices and faces.
CGAL_SP_INLINE void polish(const Host_array<vec3>& point, Monitor& monitor, Patch& patch)
{
  constexpr double hardly = 1e-10, held = 1e-6;
  for(Patch::Face& f : patch.faces()) {
    f.metric = face_metric(point[f.corner[0]], point[f.corner[1]], point[f.corner[2]], bounds_of_mending);
    f.twice_area = f.metric.twice_area;
    f.weight = 1;
  }
  const std::vector<vec3> start = patch.positions();
  if(!minimize_mips(hardly, monitor, patch)) {
    patch.set_positions(start);
    minimize_mips(held, monitor, patch);
  }
}

CGAL_SP_CORE Mending mend(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                          const Host_array<vec3>& point, const std::vector<char>& is_fixed, double bound,
                          double resolution, Monitor& monitor, Host_array<vec3>& v, std::vector<char>& is_moved)
{
  constexpr double largest_share = 0.05; // of the faces: with more flipped it is another map that is needed
  constexpr int few = 10, most_rings = 32;
  constexpr int always_moved = 2000; // and so large a share of the vertices:
  constexpr double largest_moved_share = 0.1;
  constexpr std::int64_t moves_per_vertex = 50, moves_of_few = 200000; // the most work, of untangling
  const int n = static_cast<int>(v.size()), number_of_faces = static_cast<int>(face.size());
  if(!std::all_of(v.begin(), v.end(), [](vec3 x) { return is_finite(x); }))
    return Mending::FAILED;

  const auto is_flipped = [&](int f) { return !is_positively_oriented(v[face[f][0]], v[face[f][1]], v[face[f][2]]); };
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto is_bad = [&](int f, const std::array<vec3, 3>& x, const std::array<vec3, 3>& p) {
    const Star_face s(x[1], x[2], face_metric(p[0], p[1], p[2], bounds_of_mending), 1);
    return (bound < infinity && !(s.dirichlet(x[0]) <= bound * s.determinant(x[0]))) || is_flipped(f);
  };
  std::vector<int> bad = faces_where(loop, face, is_bad, v, point);
  const auto flipped = std::count_if(bad.begin(), bad.end(), is_flipped);
  const auto is_unknown = [&](int f) {
    const vec3 a = v[face[f][0]], b = v[face[f][1]], c = v[face[f][2]];
    return !((std::max)({norm(sub(a, b)), norm(sub(b, c)), norm(sub(c, a))}) >= resolution);
  };
  if(static_cast<double>(flipped) > largest_share * number_of_faces + few)
    return Mending::FAILED; // at a finer accuracy there may be fewer
  if(std::any_of(bad.begin(), bad.end(), is_unknown))
    return Mending::FAILED;
  if(bad.empty())
    return Mending::DONE;

  // The vertices that try to untangle now, and those that have tried, which are polished in the end.
  std::vector<char> tries, is_moving(n, 0);
  std::vector<std::pair<int, vec3>> before; // of those that move: where they were
  const auto most_moving = static_cast<std::size_t>(always_moved + largest_moved_share * n);
  const auto let_try = [&](const std::vector<int>& faces) { // returns whether they are few enough
    tries.assign(n, 0);
    for(int f : faces)
      for(int i : face[f])
        if(is_fixed.empty() || !is_fixed[i]) {
          tries[i] = 1;
          if(!std::exchange(is_moving[i], 1))
            before.emplace_back(i, v[i]);
        }
    return before.size() <= most_moving;
  };
  if(!let_try(bad)) {
    bad.erase(std::remove_if(bad.begin(), bad.end(), [&](int f) { return !is_flipped(f); }), bad.end());
    if(bad.empty())
      return Mending::DONE;
    is_moving.assign(n, 0);
    before.clear();
    if(!let_try(bad))
      return Mending::TOO_MUCH;
  }
  Patches patches = patches_of(loop, face, tries);
  const auto give_up = [&](Mending how) {
    for(const auto& [i, x] : before)
      v[i] = x;
    return how;
  };
  std::int64_t moves = 0;
  for(int rings = 1; flipped > 0; rings *= 2) {
    for_each_patch(loop, patches, v, [&](Patch& patch) {
      const std::vector<vec3> start = patch.positions();
      const auto at_first = patch.number_of_flipped_faces();
      if(at_first > 0 && !untangle(point, monitor, patch) && patch.number_of_flipped_faces() >= at_first)
        patch.set_positions(start);
    });
    std::vector<int> tangled = faces_where(loop, face, is_flipped);
    if(tangled.empty()) {
      if(rings > 1)
        patches = patches_of(loop, face, is_moving);
      break;
    }
    for(const Patch::Part& part : patches)
      moves += part.moves;
    if(rings > most_rings || moves > moves_per_vertex * n + moves_of_few || monitor.is_interrupted())
      return give_up(Mending::FAILED);
    std::vector<char> is_near(n, 0);
    for(int ring = 0; ring <= rings; ++ring) {
      for(int f : tangled)
        for(int i : face[f])
          is_near[i] = 1;
      tangled = faces_at(loop, face, is_near);
    }
    if(!let_try(tangled))
      return give_up(Mending::TOO_MUCH);
    patches = patches_of(loop, face, tries);
  }
  for_each_patch(loop, patches, v, [&](Patch& patch) { polish(point, monitor, patch); });
  if(monitor.is_interrupted())
    return give_up(Mending::FAILED);
  for(const auto& [i, x] : before)
    if(!is_equal(v[i], x))
      is_moved[i] = 1;
  return Mending::DONE;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_IMPL_H
