// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_ICOSPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_ICOSPHERE_H

#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/base/vec3.h>
#include <CGAL/Spherical_parameterization/internal/mesh/midpoint_refinement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_ICOSPHERE_H
