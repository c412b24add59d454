// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLE_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Mends a map that few flipped faces keep from being valid. Their vertices move to the means of their neighbours, the
/// others stay; where faces are still flipped, the vertices around move, too. (A patch with a convex boundary has no
/// flipped face then: W. Tutte, "How to draw a graph", 1963.) Returns how many vertices have moved; 0, and v as it was,
/// where that does not help.
inline std::size_t untangle(const Host_array<std::array<int, 3>>& face, Host_array<vec3>& v)
{
  constexpr int maximum_rings = 40, sweeps_per_ring = 300;
  constexpr double largest_share = 0.7; // of the faces; a map with more is another map
  const int n = static_cast<int>(v.size()), number_of_faces = static_cast<int>(face.size());
  const auto is_flipped = [&](int f) { return !is_positively_oriented(v[face[f][0]], v[face[f][1]], v[face[f][2]]); };
  std::vector<int> flipped;
  for(int f = 0; f < number_of_faces; ++f)
    if(is_flipped(f))
      flipped.push_back(f);
  if(flipped.size() > largest_share * number_of_faces + 10)
    return 0;

  Host_array<int> offset(n + 1, 0), star(3 * face.size()); // the faces round every vertex
  for(const auto& f : face)
    for(int i : f)
      ++offset[i + 1];
  for(int i = 0; i < n; ++i)
    offset[i + 1] += offset[i];
  Host_array<int> place(offset.begin(), offset.end() - 1);
  for(int f = 0; f < number_of_faces; ++f)
    for(int i : face[f])
      star[place[i]++] = f;

  const Host_array<vec3> before = v;
  std::vector<char> is_free(n, 0);
  std::vector<int> free_vertices;
  const auto set_free = [&](int i) {
    if(!is_free[i]) {
      is_free[i] = 1;
      free_vertices.push_back(i);
    }
  };
  for(int ring = 0; ring < maximum_rings && !flipped.empty(); ++ring) {
    std::vector<int> centres;
    for(int f : flipped)
      for(int i : face[f])
        if(ring == 0)
          set_free(i);
        else
          centres.push_back(i);
    for(int i : centres)
      for(int k = offset[i]; k < offset[i + 1]; ++k)
        for(int j : face[star[k]])
          set_free(j);
    for(int i : free_vertices)
      v[i] = before[i];
    for(int sweep = 0; sweep < sweeps_per_ring * (ring + 1); ++sweep)
      for(int i : free_vertices) {
        vec3 sum = {0, 0, 0};
        for(int k = offset[i]; k < offset[i + 1]; ++k)
          for(int j : face[star[k]])
            if(j != i)
              sum = add_scaled(sum, 1, v[j]);
        v[i] = unit(sum);
      }
    flipped.clear();
    for(int i : free_vertices)
      for(int k = offset[i]; k < offset[i + 1]; ++k)
        if(is_flipped(star[k]))
          flipped.push_back(star[k]);
  }
  if(!flipped.empty()) {
    v = before;
    return 0;
  }
  return free_vertices.size();
}

/// Newton steps of the conformal energy
inline std::size_t polish(const Host_array<std::array<int, 3>>& face, const Host_array<vec3>& point, double bound,
                          int sweeps, Host_array<vec3>& v)
{
  const int n = static_cast<int>(v.size()), number_of_faces = static_cast<int>(face.size());
  Host_array<int> offset(n + 1, 0), star(3 * face.size()); // the faces round every vertex
  for(const auto& f : face)
    for(int i : f)
      ++offset[i + 1];
  for(int i = 0; i < n; ++i)
    offset[i + 1] += offset[i];
  Host_array<int> place(offset.begin(), offset.end() - 1);
  for(int f = 0; f < number_of_faces; ++f)
    for(int i : face[f])
      star[place[i]++] = f;
  const Distortion conformal(0);
  const Metric_bounds bounds = {1e6, 1e-30};
  std::vector<char> is_free(n, 0);
  std::vector<int> free_vertices;
  const auto face_at = [&](int f, int c) {
    const int i = face[f][c], a = face[f][(c + 1) % 3], b = face[f][(c + 2) % 3];
    const Face_metric m = face_metric(sub(point[a], point[i]), sub(point[b], point[i]), bounds);
    return Star_face{v[a], v[b], m.cotangent[0], m.cotangent[1], m.cotangent[2], m.twice_area};
  };
  for(int f = 0; f < number_of_faces; ++f) {
    const Star_face s = face_at(f, 0);
    const vec3 x = v[face[f][0]];
    if(s.dirichlet(x) > bound * s.determinant(x))
      for(int i : face[f])
        if(!is_free[i]) {
          is_free[i] = 1;
          free_vertices.push_back(i);
        }
  }
  for(int sweep = 0; sweep < sweeps; ++sweep)
    for(int i : free_vertices) {
      Star st;
      for(int k = offset[i]; k < offset[i + 1]; ++k) {
        const auto& f = face[star[k]];
        st.push_back(face_at(star[k], f[0] == i ? 0 : f[1] == i ? 1 : 2));
      }
      double energy = star_energy(conformal, st, v[i]);
      relax_centre(conformal, st, v[i], energy);
    }
  return free_vertices.size();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLE_H
