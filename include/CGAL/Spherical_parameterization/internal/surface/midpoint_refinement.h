// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MIDPOINT_REFINEMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MIDPOINT_REFINEMENT_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/surface/match_halfedges.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A closed triangle mesh in space.
struct Triangle_surface : Corner_table {
  Host_array<vec3> point;
};

/// Every face is cut into four at the midpoints of its edges: the surface stays, and so do the numbers of its vertices.
/// Corner k of face f is in face 4f + k, as the first one; face 4f + 3 is the middle one.
CGAL_SP_INLINE Triangle_surface refined_at_midpoints(const Triangle_surface& mesh)
{
  Triangle_surface fine;
  fine.point = mesh.point;
  const int m = mesh.number_of_halfedges();
  std::vector<int> midpoint(m);
  for(int h = 0; h < m; ++h)
    if(h < mesh.twin[h]) {
      midpoint[h] = midpoint[mesh.twin[h]] = static_cast<int>(fine.point.size());
      fine.point.push_back(scale(0.5, add(mesh.point[mesh.origin(h)], mesh.point[mesh.target(h)])));
    }
  const auto halfedge_at_corner = [](int h) { return 3 * (4 * (h / 3) + h % 3); }; // the first half of h
  fine.twin.resize(4 * mesh.twin.size());
  for(int f = 0; f < static_cast<int>(mesh.face.size()); ++f) {
    const int middle = 3 * (4 * f + 3);
    for(int k = 0; k < 3; ++k) {
      const int h = 3 * f + k, before = Corner_table::previous(h);
      fine.face.push_back({mesh.face[f][k], midpoint[h], midpoint[before]});
      // its three sides: the first half of h, the one towards the middle face, the second half of the edge before
      fine.twin[halfedge_at_corner(h)] = halfedge_at_corner(Corner_table::next(mesh.twin[h])) + 2;
      fine.twin[halfedge_at_corner(h) + 1] = middle + (k + 2) % 3;
      fine.twin[halfedge_at_corner(h) + 2] = halfedge_at_corner(mesh.twin[before]);
      fine.twin[middle + k] = halfedge_at_corner(Corner_table::next(h)) + 1;
    }
    fine.face.push_back({midpoint[3 * f], midpoint[3 * f + 1], midpoint[3 * f + 2]});
  }
  return fine;
}

/// An icosahedron of which every triangle has been cut in four `level` times, on the unit sphere: 10 * 4^level + 2
/// points and 20 * 4^level triangles, counter-clockwise seen from outside. The first points are those of the lower
/// levels.
struct Icosphere {
  std::vector<vec3> points;
  std::vector<std::array<int, 3>> triangles;

  explicit Icosphere(int level)
  {
    Triangle_surface mesh;
    Host_array<vec3>& point = mesh.point;
    const double golden = (1 + std::sqrt(5.)) / 2;
    for(const double a : {-1., 1.})
      for(const double b : {-golden, golden})
        for(const vec3& p : {vec3{0, a, b}, vec3{a, b, 0}, vec3{b, 0, a}})
          point.push_back(unit(p));
    const int n = static_cast<int>(point.size());
    for(int i = 0; i < n; ++i) // neighbours have the inner product 1/sqrt(5), all others a negative one
      for(int j = i + 1; j < n; ++j)
        for(int k = j + 1; k < n; ++k)
          if(inner(point[i], point[j]) > 0 && inner(point[j], point[k]) > 0 && inner(point[k], point[i]) > 0) {
            const bool is_positive = inner(point[i], outer(point[j], point[k])) > 0;
            mesh.face.push_back(is_positive ? std::array<int, 3>{i, j, k} : std::array<int, 3>{i, k, j});
          }
    match_halfedges(Host_loop(), mesh.face, n, mesh.twin);
    for(; level > 0; --level) {
      const auto old = static_cast<std::ptrdiff_t>(point.size());
      mesh = refined_at_midpoints(mesh);
      std::transform(point.begin() + old, point.end(), point.begin() + old, unit);
    }
    points.assign(point.begin(), point.end());
    triangles.assign(mesh.face.begin(), mesh.face.end());
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MIDPOINT_REFINEMENT_H
