// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_IMPL_H

#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/mend.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// The corners at every vertex, corner 3f + k being vertex k of face f.
struct Corners_of_vertices {
  Host_array<int> offset, corner;

  Corners_of_vertices(const Host_array<std::array<int, 3>>& face, int number_of_vertices)
    : offset(number_of_vertices + 1, 0), corner(3 * face.size())
  {
    for(const auto& f : face)
      for(int i : f)
        ++offset[i + 1];
    for(int i = 0; i < number_of_vertices; ++i)
      offset[i + 1] += offset[i];
    Host_array<int> place(offset.begin(), offset.end() - 1);
    for(int c = 0; c < static_cast<int>(corner.size()); ++c)
      corner[place[face[c / 3][c % 3]]++] = c;
  }

  /// f(corner) for the corners at vertex i
  template <class F>
  void for_each(int i, F f) const
  {
    for(int k = offset[i]; k < offset[i + 1]; ++k)
      f(corner[k]);
  }
};

/// The faces for which `is_bad(f)` holds, in their order.
template <class Is_bad>
std::vector<int> bad_faces(const Host_loop& loop, int number_of_faces, Is_bad is_bad)
{
  std::vector<int> result;
  for(const std::vector<int>&part : results_of_parts(loop, number_of_faces, [&](int begin, int end) {
        std::vector<int> bad;
        for(int f = begin; f < end; ++f)
          if(is_bad(f))
            bad.push_back(f);
        return bad;
      }))
    result.insert(result.end(), part.begin(), part.end());
  return result;
}

CGAL_SP_CORE bool untangle(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                           const std::vector<char>& is_fixed, Host_array<vec3>& v, std::vector<char>& is_moved)
{
  constexpr int maximum_rings = 25, sweeps_per_ring = 100, sweeps_per_check = 10;
  constexpr double largest_share = 0.02; // of the faces: with more flipped it is another map that is needed
  constexpr int few = 10;
  constexpr std::int64_t moves_per_vertex = 200, moves_of_few = 300000; // the most work
  const int n = static_cast<int>(v.size()), number_of_faces = static_cast<int>(face.size());
  const auto is_flipped = [&](int f) {
    const vec3 a = v[face[f][0]], b = v[face[f][1]], c = v[face[f][2]];
    return !is_finite(a) || !is_finite(b) || !is_finite(c) || !is_positively_oriented(a, b, c);
  };
  std::vector<int> flipped = bad_faces(loop, number_of_faces, is_flipped);
  if(flipped.size() > largest_share * number_of_faces + few)
    return false;

  const Corners_of_vertices corners(face, n);
  const Host_array<vec3> before = v;
  std::vector<char> moved(n, 0);
  std::int64_t moves = 0;
  for(int ring = 0; ring < maximum_rings && !flipped.empty(); ++ring) {
    std::vector<char> is_free(n, 0);
    std::vector<int> patch;
    const auto add_corners_of = [&](int f) {
      for(int i : face[f])
        if(!is_free[i] && (is_fixed.empty() || !is_fixed[i])) {
          is_free[i] = 1;
          patch.push_back(i);
        }
    };
    for(int f : flipped)
      add_corners_of(f);
    for(std::size_t begin = 0, r = 0; r < static_cast<std::size_t>(ring); ++r) {
      const std::size_t end = patch.size();
      for(; begin < end; ++begin)
        corners.for_each(patch[begin], [&](int c) { add_corners_of(c / 3); });
    }
    for(int i : patch)
      moved[i] = 1;
    std::vector<int> concerned = flipped; // which may have fixed corners only
    for(int i : patch)
      corners.for_each(i, [&](int c) { concerned.push_back(c / 3); });
    Host_array<vec3> mean(patch.size());
    for(int sweep = 1; sweep <= sweeps_per_ring * (ring + 1) && !flipped.empty(); ++sweep) {
      for(std::size_t k = 0; k < patch.size(); ++k) {
        vec3 sum = {0, 0, 0};
        corners.for_each(patch[k], [&](int c) {
          const auto& f = face[c / 3];
          sum = add(sum, add(v[f[(c + 1) % 3]], v[f[(c + 2) % 3]]));
        });
        mean[k] = inner(sum, sum) > 0 ? unit(sum) : v[patch[k]];
      }
      for(std::size_t k = 0; k < patch.size(); ++k)
        v[patch[k]] = mean[k];
      if(sweep % sweeps_per_check == 0) {
        flipped.clear();
        std::copy_if(concerned.begin(), concerned.end(), std::back_inserter(flipped), is_flipped);
      }
      moves += static_cast<std::int64_t>(patch.size());
    }
    if(moves > moves_per_vertex * n + moves_of_few)
      break;
  }
  if(!flipped.empty()) {
    v = before;
    return false;
  }
  for(int i = 0; i < n; ++i)
    is_moved[i] |= moved[i];
  return true;
}

/// Numbers from 0 on for the vertices of a list such that no two of a face have the same: the lists of equal ones.
inline std::vector<std::vector<int>> colour_classes(const Host_array<std::array<int, 3>>& face,
                                                    const Corners_of_vertices& corners, const std::vector<int>& list,
                                                    int number_of_vertices)
{
  std::vector<std::vector<int>> classes;
  std::vector<int> colour(number_of_vertices, -1);
  for(int i : list) {
    const auto is_taken = [&](int candidate) {
      bool taken = false;
      corners.for_each(i, [&](int c) {
        for(int j : face[c / 3])
          taken = taken || colour[j] == candidate;
      });
      return taken;
    };
    int k = 0;
    while(is_taken(k))
      ++k;
    colour[i] = k;
    classes.resize((std::max)(classes.size(), static_cast<std::size_t>(k + 1)));
    classes[k].push_back(i);
  }
  return classes;
}

CGAL_SP_CORE void polish(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                         const Host_array<vec3>& point, const std::vector<char>& is_fixed, Host_array<vec3>& v,
                         std::vector<char>& is_moved)
{
  constexpr double bound = 2; // of the energy: stretches in the ratio 3.7
  constexpr int sweeps = 30, in_a_part = 64;
  constexpr double sufficient_gain = 1e-4; // of the energy of a star, for which another step follows
  constexpr Metric_bounds bounds = {1e6, 1e-30};
  const int n = static_cast<int>(v.size());
  const Distortion conformal(0);
  const auto face_at = [&](int c) {
    const auto& f = face[c / 3];
    const int i = f[c % 3], j = f[(c + 1) % 3], k = f[(c + 2) % 3];
    return Star_face(v[j], v[k], face_metric(sub(point[j], point[i]), sub(point[k], point[i]), bounds), 1);
  };

  std::vector<int> list;
  std::vector<char> is_listed(n, 0);
  for(int f : bad_faces(loop, static_cast<int>(face.size()), [&](int g) {
        const Star_face s = face_at(3 * g);
        const vec3 x = v[face[g][0]];
        return s.dirichlet(x) > bound * s.determinant(x);
      }))
    for(int i : face[f])
      if(!is_listed[i] && (is_fixed.empty() || !is_fixed[i])) {
        is_listed[i] = 1;
        list.push_back(i);
      }
  if(list.empty())
    return;

  // the worst stars first, whatever their numbers
  const Corners_of_vertices corners(face, n);
  const auto star_of = [&](int i) {
    Star star;
    corners.for_each(i, [&](int c) { star.push_back(face_at(c)); });
    return star;
  };
  std::vector<std::pair<double, int>> order;
  for(int i : list)
    order.emplace_back(-star_energy(conformal, star_of(i), v[i]), i);
  std::sort(order.begin(), order.end());
  std::transform(order.begin(), order.end(), list.begin(), [](const auto& entry) { return entry.second; });
  std::vector<std::vector<int>> classes = colour_classes(face, corners, list, n);
  for(int sweep = 0; sweep < sweeps; ++sweep)
    for(std::vector<int>& of_colour : classes) {
      for_each_index<in_a_part>(loop, static_cast<int>(of_colour.size()), [&](int k) {
        const int i = of_colour[k];
        const Star star = star_of(i);
        double energy = star_energy(conformal, star, v[i]);
        const double gain = relax_centre(conformal, star, v[i], energy);
        if(gain > 0)
          is_moved[i] = 1;
        if(!(gain > sufficient_gain * energy))
          of_colour[k] = -1;
      });
      of_colour.erase(std::remove(of_colour.begin(), of_colour.end(), -1), of_colour.end());
    }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_IMPL_H
