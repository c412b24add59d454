// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_MIDPOINT_REFINEMENT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_MIDPOINT_REFINEMENT_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/base/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A closed triangle mesh in space.
struct Triangle_surface : Corner_table {
  Host_array<vec3> point;
};

/// Every face is cut into four at the midpoints of its edges: the surface stays, and so do the numbers of its vertices.
/// Corner k of face f is in face 4f + k, as the first one; face 4f + 3 is the middle one.
inline Triangle_surface refined_at_midpoints(const Triangle_surface& mesh)
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

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_MIDPOINT_REFINEMENT_H
