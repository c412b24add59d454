// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CORNER_TABLE_OF_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CORNER_TABLE_OF_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/surface/check_face_graph.h>

#include <CGAL/boost/graph/helpers.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The corners of face f: source(h), target(h) and target(next(h)) for h = halfedge(f), as in Source_mesh.
template <class TriangleMesh, class Index>
std::array<int, 3> corners_of_face(const TriangleMesh& mesh, const Index& index,
                                   typename boost::graph_traits<TriangleMesh>::face_descriptor f)
{
  const auto h = halfedge(f, mesh);
  return {index(source(h, mesh)), index(target(h, mesh)), index(target(next(h, mesh), mesh))};
}

/// The corners of all faces in the order of faces(mesh); vertices have the numbers index(v). Throws Error for a mesh
/// that is too large.
template <class TriangleMesh, class Index>
Host_array<std::array<int, 3>> corners_of_faces(const TriangleMesh& mesh, const Index& index, const Host_loop& loop)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  check_size(mesh);
  const std::vector<face_descriptor> descriptor(faces(mesh).begin(), faces(mesh).end());
  Host_array<std::array<int, 3>> face(descriptor.size());
  for_each_index(loop, static_cast<int>(face.size()),
                 [&](int f) { face[f] = corners_of_face(mesh, index, descriptor[f]); });
  return face;
}

/// The corner table of a face graph. Opposite halfedges are those of the mesh: it may have several edges between two
/// vertices.
/// \param corners  what `corners_of_faces()` gives, with any numbers
/// Throws Error for a face that is no triangle, and for a boundary.
template <class TriangleMesh>
Corner_table corner_table_of(const TriangleMesh& mesh, Host_array<std::array<int, 3>> corners, const Host_loop& loop)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  const auto numbering = numbering_of<typename Graph_traits::face_descriptor>(mesh, faces(mesh));
  const std::vector<typename Graph_traits::face_descriptor> descriptor(faces(mesh).begin(), faces(mesh).end());
  Corner_table table;
  table.face = std::move(corners);
  table.twin.resize(3 * descriptor.size());
  const int n = static_cast<int>(descriptor.size());
  const int bad = first_index(loop, n, [&](int f) {
    auto h = halfedge(descriptor[f], mesh);
    if(!is_triangle(h, mesh))
      return true;
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto other = opposite(h, mesh);
      if(is_border(other, mesh))
        return true;
      const auto neighbour = face(other, mesh);
      const auto first = halfedge(neighbour, mesh);
      const int corner = other == first ? 0 : other == next(first, mesh) ? 1 : 2;
      table.twin[3 * f + k] = 3 * numbering(neighbour) + corner;
    }
    return false;
  });
  if(bad < n && !is_triangle(halfedge(descriptor[bad], mesh), mesh))
    throw Input_error(Error_code::NOT_TRIANGULAR, "face " + std::to_string(bad) + "; triangulate the mesh first");
  if(bad < n)
    throw Input_error(Error_code::BOUNDARY,
                      "the first boundary edge is one of face " + std::to_string(bad) + "; fill the holes first");
  return table;
}

/// Throws Error if there are vertices below n without faces.
inline void check_no_isolated_vertex(const Host_array<std::array<int, 3>>& face, int n)
{
  std::vector<bool> has_face(n);
  for(const std::array<int, 3>& f : face)
    for(int v : f)
      has_face[v] = true;
  const auto first = std::find(has_face.begin(), has_face.end(), false) - has_face.begin();
  if(first < n)
    throw Input_error(Error_code::ISOLATED_VERTEX,
                      "the first one is vertex " + std::to_string(first) + "; remove them");
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CORNER_TABLE_OF_H
