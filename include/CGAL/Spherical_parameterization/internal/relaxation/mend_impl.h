// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_MEND_IMPL_H

#include <CGAL/Spherical_parameterization/internal/mesh/fans.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/mend.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/untangling_energy.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// The corners at every vertex, corner 3f + k being vertex k of face f.
struct Corners_of_vertices {
  Host_array<int> offset, corner;

  Corners_of_vertices(const Host_loop& loop, const Host_array<std::array<int, 3>>& face, int number_of_vertices)
    : offset(number_of_vertices + 1), corner(3 * face.size())
  {
    offset[number_of_vertices] = static_cast<int>(corner.size());
    for_each_fan(loop, face, number_of_vertices, [&](const Fan& fan) {
      offset[fan.vertex] = fan.first;
      std::copy(fan.begin(), fan.end(), corner.begin() + fan.first);
    });
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

/// The vertices that are at most so many edges away from the given faces, and may move.
inline std::vector<int> vertices_near(const Host_array<std::array<int, 3>>& face, const Corners_of_vertices& corners,
                                      const std::vector<int>& faces, int rings, const std::vector<char>& is_fixed,
                                      int number_of_vertices)
{
  std::vector<char> is_seen(number_of_vertices, 0);
  std::vector<int> result;
  const auto add_corners_of = [&](int f) {
    for(int i : face[f])
      if(!std::exchange(is_seen[i], 1))
        result.push_back(i);
  };
  for(int f : faces)
    add_corners_of(f);
  std::size_t begin = 0;
  for(int ring = 0; ring < rings; ++ring)
    for(const std::size_t end = result.size(); begin < end; ++begin)
      corners.for_each(result[begin], [&](int c) { add_corners_of(c / 3); });
  if(!is_fixed.empty())
    result.erase(std::remove_if(result.begin(), result.end(), [&](int i) { return is_fixed[i]; }), result.end());
  return result;
}

/// Sorts a list of vertices, those of the largest energy(i) first: whatever their numbers are.
template <class Energy>
void sort_worst_first(Energy energy, std::vector<int>& list)
{
  std::vector<std::pair<double, int>> order;
  for(int i : list)
    order.emplace_back(-energy(i), i);
  std::sort(order.begin(), order.end());
  std::transform(order.begin(), order.end(), list.begin(), [](const auto& entry) { return entry.second; });
}

CGAL_SP_CORE bool untangle(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                           const Host_array<vec3>& point, const std::vector<char>& is_fixed, Host_array<vec3>& v,
                           std::vector<char>& is_moved)
{
  constexpr double largest_share = 0.05; // of the faces: with more flipped it is another map that is needed
  constexpr int few = 10, most_rings = 32, sweeps_per_patch = 200, finishing_sweeps = 15, in_a_part = 64;
  constexpr std::int64_t moves_per_vertex = 50, moves_of_few = 200000; // the most work
  constexpr Metric_bounds bounds = {30, 1e-30};                        // needles are untangled as if they were better
  constexpr double largest_start = 1e-3, least_regularization = 1e-7, share_of_worst = 0.2; // of the energy
  constexpr double sufficient_gain = 1e-3, slowest = 0.5, fastest = 0.1; // when, and how fast, it is regularized less
  constexpr double smallest_face = 1e-24;                                // what doubles tell apart on the sphere
  const int n = static_cast<int>(v.size()), number_of_faces = static_cast<int>(face.size());
  const auto is_flipped = [&](int f) {
    const vec3 a = v[face[f][0]], b = v[face[f][1]], c = v[face[f][2]];
    return !is_finite(a) || !is_finite(b) || !is_finite(c) || !is_positively_oriented(a, b, c);
  };
  std::vector<int> flipped = bad_faces(loop, number_of_faces, is_flipped);
  if(flipped.empty())
    return true;
  if(flipped.size() > largest_share * number_of_faces + few ||
     !std::all_of(v.begin(), v.end(), [](vec3 x) { return is_finite(x); }))
    return false;

  const Corners_of_vertices corners(loop, face, n);
  const Host_array<vec3> before = v;
  const auto metric_at = [&](int c) {
    const auto& f = face[c / 3];
    const vec3 p = point[f[c % 3]];
    return face_metric(sub(point[f[(c + 1) % 3]], p), sub(point[f[(c + 2) % 3]], p), bounds);
  };
  Host_array<double> size(number_of_faces, 0.); // that faces should have, of the order of their neighbours'
  std::int64_t moves = 0;
  for(int rings = 1; rings <= most_rings && !flipped.empty(); rings *= 2) {
    std::vector<int> patch = vertices_near(face, corners, flipped, rings, is_fixed, n);
    std::vector<int> concerned = flipped; // which may have fixed corners only
    for(int i : patch)
      corners.for_each(i, [&](int c) { concerned.push_back(c / 3); });
    std::sort(concerned.begin(), concerned.end());
    concerned.erase(std::unique(concerned.begin(), concerned.end()), concerned.end());

    Host_array<double> largest(n, smallest_face); // at a vertex
    for(int f : concerned) {
      const auto [i, j, k] = face[f];
      const double dirichlet = Star_face(v[j], v[k], metric_at(3 * f), 1).dirichlet(v[i]);
      for(int corner : face[f])
        largest[corner] = (std::max)(largest[corner], dirichlet);
    }
    for(int f : concerned)
      size[f] = (std::max)({largest[face[f][0]], largest[face[f][1]], largest[face[f][2]]});
    const auto star_of = [&](int i) {
      Star star;
      corners.for_each(i, [&](int c) {
        const Face_metric metric = metric_at(c);
        const auto& f = face[c / 3];
        star.emplace_back(v[f[(c + 1) % 3]], v[f[(c + 2) % 3]], metric, size[c / 3] / metric.twice_area);
      });
      return star;
    };
    const auto find_flipped = [&] {
      flipped.clear();
      std::copy_if(concerned.begin(), concerned.end(), std::back_inserter(flipped), is_flipped);
      double worst = 0;
      for(int f : flipped)
        worst = (std::min)(worst, determinant(v[face[f][0]], v[face[f][1]], v[face[f][2]]) / size[f]);
      return share_of_worst * std::abs(worst);
    };

    double regularization = (std::max)(find_flipped(), largest_start);
    const std::size_t flipped_at_first = flipped.size();
    sort_worst_first([&](int i) { return Untangling_energy(regularization).value(star_of(i), v[i]); }, patch);
    const std::vector<std::vector<int>> classes = colour_classes(face, corners, patch, n);
    const auto of_patch = [&] {
      Host_array<vec3> positions;
      for(int i : patch)
        positions.push_back(v[i]);
      return positions;
    };
    const auto put_back = [&](const Host_array<vec3>& positions) {
      for(std::size_t k = 0; k < patch.size(); ++k)
        v[patch[k]] = positions[k];
    };
    const Host_array<vec3> at_first = of_patch();
    // Once no face is flipped, some sweeps make the faces better that are only just positive.
    Host_array<vec3> valid;
    int finishing = 0;
    for(int sweep = 0;
        sweep < sweeps_per_patch && finishing < finishing_sweeps && regularization > least_regularization; ++sweep) {
      const Untangling_energy untangling(regularization);
      double energy = 0, gain = 0;
      for(const std::vector<int>& of_colour : classes) {
        const auto sums =
          results_of_parts<in_a_part>(loop, static_cast<int>(of_colour.size()), [&](int begin, int end) {
            std::pair<double, double> sum = {0, 0};
            for(int k = begin; k < end; ++k) {
              const int i = of_colour[k];
              const Star star = star_of(i);
              double of_star = untangling.value(star, v[i]);
              sum.first += of_star;
              sum.second += untangling.relax_centre(star, v[i], of_star);
            }
            return sum;
          });
        for(const auto& [of_part, gain_of_part] : sums) {
          energy += of_part;
          gain += gain_of_part;
        }
      }
      moves += static_cast<std::int64_t>(patch.size());
      const double next = find_flipped();
      if(flipped.empty()) {
        valid = of_patch();
        ++finishing;
      }
      if(gain < sufficient_gain * energy)
        regularization = std::clamp(next, fastest * regularization, slowest * regularization);
    }
    if(!valid.empty()) {
      put_back(valid);
      flipped.clear();
    }
    if(moves > moves_per_vertex * n + moves_of_few)
      break;
    if(flipped.size() > flipped_at_first) { // the patch is too small
      put_back(at_first);
      find_flipped();
    }
  }
  if(!flipped.empty()) {
    v = before;
    return false;
  }
  for(int i = 0; i < n; ++i)
    if(!is_equal(v[i], before[i]))
      is_moved[i] = 1;
  return true;
}

CGAL_SP_CORE void polish(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                         const Host_array<vec3>& point, const std::vector<char>& is_fixed, Host_array<vec3>& v,
                         std::vector<char>& is_moved)
{
  constexpr double bound = 2; // of the energy: stretches in the ratio 3.7
  constexpr int sweeps = 100, in_a_part = 64;
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

  const Corners_of_vertices corners(loop, face, n);
  const auto star_of = [&](int i) {
    Star star;
    corners.for_each(i, [&](int c) { star.push_back(face_at(c)); });
    return star;
  };
  sort_worst_first([&](int i) { return star_energy(conformal, star_of(i), v[i]); }, list);
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
