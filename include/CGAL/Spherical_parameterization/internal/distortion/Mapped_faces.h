// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_MAPPED_FACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_MAPPED_FACES_H

// Former names, for the rooms that are still to be changed to read_surface.h.

#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

namespace CGAL::Spherical_parameterization::internal {

typedef Mapped_surface Mapped_faces;

template <class TriangleMesh, class VertexMap>
auto read_vectors(const TriangleMesh& mesh, VertexMap map) -> decltype(vertices(mesh), Host_array<vec3>())
{
  return vectors_at(vertices(mesh), map);
}

template <class TriangleMesh, class VertexSphereMap>
Mapped_faces read_images(const TriangleMesh& mesh, VertexSphereMap sphere_map, const Host_loop& loop)
{
  return read_map(mesh, sphere_map, Reading::UNCHECKED, loop);
}

template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
Mapped_faces read_mapped_faces(const TriangleMesh& mesh, VertexPointMap points, VertexSphereMap sphere_map,
                               const Host_loop& loop)
{
  Mapped_faces result = read_map(mesh, sphere_map, Reading::CHECKED, loop);
  result.point = vectors_at(vertices(mesh), points);
  return result;
}

template <class TriangleMesh, class Index>
Host_array<std::array<int, 3>> corners_of_faces(const TriangleMesh& mesh, const Index&, const Host_loop& loop)
{
  Vertices<TriangleMesh> vertex;
  return read_faces(mesh, Reading::UNCHECKED, loop, vertex).face;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_MAPPED_FACES_H
