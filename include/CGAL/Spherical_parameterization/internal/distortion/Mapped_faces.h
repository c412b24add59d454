// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_MAPPED_FACES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_MAPPED_FACES_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/for_each_face.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/surface/corner_table_of.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>

#include <boost/graph/graph_traits.hpp>

#include <array>

namespace CGAL::Spherical_parameterization::internal {

/// The faces of a mesh and their images on the sphere as arrays, in the order of the mesh. Nothing is checked.
struct Mapped_faces {
  Host_array<std::array<int, 3>> face;
  Host_array<vec3> point; ///< by vertex; may be left out
  Host_array<vec3> image; ///< by vertex

  int number_of_faces() const { return static_cast<int>(face.size()); }
  std::array<vec3, 3> in_source(int f) const { return corners(point, f); }
  std::array<vec3, 3> on_sphere(int f) const { return corners(image, f); }

  /// Calls f(face, its corners in the source, those on the sphere) for all faces, in any order.
  template <class Loop, class F>
  void for_each_face(const Loop& loop, F f) const
  {
    for_each_part(loop, number_of_faces(),
                  [&](int begin, int end) { internal::for_each_face(face, begin, end, f, point, image); });
  }

private:
  std::array<vec3, 3> corners(const Host_array<vec3>& at, int f) const
  {
    return {at[face[f][0]], at[face[f][1]], at[face[f][2]]};
  }
};

/// The values of a vertex map as vectors. Property maps are read on the calling thread, whatever the policy.
template <class TriangleMesh, class VertexMap>
Host_array<vec3> read_vectors(const TriangleMesh& mesh, VertexMap map)
{
  Host_array<vec3> result;
  result.reserve(num_vertices(mesh));
  for(auto v : vertices(mesh))
    result.push_back(coordinates(get(map, v)));
  return result;
}

/// Without the points of the source.
template <class TriangleMesh, class VertexSphereMap, class Loop>
Mapped_faces read_images(const TriangleMesh& mesh, VertexSphereMap sphere_map, const Loop& loop)
{
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;
  const auto numbering = numbering_of<vertex_descriptor>(mesh, vertices(mesh));
  return {corners_of_faces(mesh, numbering, loop), {}, read_vectors(mesh, sphere_map)};
}

template <class TriangleMesh, class VertexPointMap, class VertexSphereMap, class Loop>
Mapped_faces read_mapped_faces(const TriangleMesh& mesh, VertexPointMap points, VertexSphereMap sphere_map,
                               const Loop& loop)
{
  Mapped_faces result = read_images(mesh, sphere_map, loop);
  result.point = read_vectors(mesh, points);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_MAPPED_FACES_H
