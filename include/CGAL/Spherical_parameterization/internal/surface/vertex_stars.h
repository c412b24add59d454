// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_STARS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_STARS_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/surface/corner_table_of.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// The faces round every vertex, from halfedge(v, mesh) on, in compressed rows: vertices and faces have the numbers
/// they have in the mesh.
struct Vertex_stars {
  Host_array<int> offset;
  Host_array<int> face;

  int number_of_vertices() const { return static_cast<int>(offset.size()) - 1; }
};

/// Throws Error for a vertex without faces, and at a boundary.
template <class TriangleMesh>
Vertex_stars vertex_stars(const TriangleMesh& mesh)
{
  const Vertex_numbering<TriangleMesh> vertex_number(vertices(mesh));
  const Face_numbering<TriangleMesh> face_number(faces(mesh));
  check_no_isolated_vertex(corners_of_faces(mesh, vertex_number, Host_loop()), static_cast<int>(vertex_number.size()));
  Vertex_stars stars;
  stars.offset.push_back(0);
  for(auto v : vertices(mesh)) {
    for(auto h : halfedges_around_target(halfedge(v, mesh), mesh)) {
      if(is_border(h, mesh))
        throw Input_error(Error_code::BOUNDARY,
                          "at vertex " + std::to_string(stars.number_of_vertices()) + "; fill the holes first");
      stars.face.push_back(face_number(face(h, mesh)));
    }
    stars.offset.push_back(static_cast<int>(stars.face.size()));
  }
  return stars;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_STARS_H
