// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CORNER_TABLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CORNER_TABLE_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <array>

namespace CGAL::Spherical_parameterization::internal {

/// The connectivity of a closed oriented triangle mesh. Number 3 f + k stands for corner k of face f, and for the
/// halfedge from there to the next corner of the face.
struct Corner_table {
  Host_array<std::array<int, 3>> face; ///< the vertices, counterclockwise
  Host_array<int> twin;                ///< by halfedge: the opposite one

  int number_of_halfedges() const { return static_cast<int>(3 * face.size()); }
  int origin(int h) const { return face[h / 3][h % 3]; }
  int target(int h) const { return origin(next(h)); }
  int apex(int h) const { return origin(previous(h)); } ///< the corner opposite to h
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
};

/// Normal of a face, as long as twice its area.
inline vec3 normal(const Host_array<vec3>& points, const std::array<int, 3>& f)
{
  return outer(sub(points[f[1]], points[f[0]]), sub(points[f[2]], points[f[0]]));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CORNER_TABLE_H
