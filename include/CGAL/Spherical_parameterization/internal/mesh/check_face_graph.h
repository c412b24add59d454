// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CHECK_FACE_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CHECK_FACE_GRAPH_H

#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/base/text.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Vertex_numbering.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The neighbours of every vertex in the order of vertices(mesh), in compressed rows.
struct Neighbours {
  Host_array<int> offset, target;
};

/// All numbers of vertices and halfedges are of type int. Looks at no element, and allocates nothing.
template <class TriangleMesh>
void check_size(const TriangleMesh& mesh)
{
  constexpr std::size_t limit = static_cast<std::size_t>((std::numeric_limits<int>::max)());
  const auto size = [](const auto& range) {
    return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
  };
  const std::size_t vertex_count = size(vertices(mesh)), face_count = size(faces(mesh));
  if(vertex_count >= limit || face_count > limit / 3)
    throw Input_error(Error_code::TOO_LARGE, std::to_string(vertex_count) + " vertices and " +
                                               std::to_string(face_count) +
                                               " faces; at most 715,827,882 faces are supported");
}

template <class TriangleMesh, class Face, class Loop>
bool are_triangles(const TriangleMesh& mesh, const std::vector<Face>& descriptors, const Loop& loop)
{
  if(descriptors.empty())
    return false;
  const int n = static_cast<int>(descriptors.size());
  return first_index(loop, n, [&](int f) { return !is_triangle(halfedge(descriptors[f], mesh), mesh); }) == n;
}

/// Walks round every vertex. Returns whether that meets each of its faces, and no border: whether the triangles form
/// a closed surface.
template <class TriangleMesh, class Vertex, class Loop>
bool read_neighbours(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering,
                     const std::vector<Vertex>& descriptors, std::size_t number_of_faces, const Loop& loop,
                     Neighbours& neighbours)
{
  // Faces tell how long the rows are, if all is well.
  const int n = static_cast<int>(descriptors.size());
  Host_array<int>& offset = neighbours.offset;
  offset.assign(n + 1, 0);
  for(auto h : halfedges(mesh)) {
    if(is_border(h, mesh))
      return false;
    ++offset[numbering(target(h, mesh)) + 1];
  }
  for(int i = 0; i < n; ++i)
    offset[i + 1] += offset[i];
  if(offset[n] != static_cast<int>(3 * number_of_faces))
    return false;
  neighbours.target.resize(offset[n]);
  return first_index(loop, n, [&](int i) {
           int at = offset[i];
           if(at == offset[i + 1])
             return true;
           for(auto h : halfedges_around_target(halfedge(descriptors[i], mesh), mesh)) {
             if(at == offset[i + 1])
               return true;
             neighbours.target[at++] = numbering(source(h, mesh));
           }
           return at != offset[i + 1];
         }) == n;
}

/// Throws the Error that says what and where; returns if there is nothing to say.
template <class TriangleMesh>
void explain_what_is_wrong(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering)
{
  std::size_t face_count = 0;
  for(auto f : faces(mesh)) {
    if(!is_triangle(halfedge(f, mesh), mesh))
      throw Input_error(Error_code::NOT_TRIANGULAR, "face " + std::to_string(face_count) + " has " +
                                                      std::to_string(degree(f, mesh)) +
                                                      " corners; triangulate the mesh first");
    ++face_count;
  }
  if(face_count == 0)
    throw Input_error(Error_code::EMPTY_MESH, "there is nothing to map");

  // Incident faces of each vertex as the faces tell it, to be compared with the walk round the vertex.
  Host_array<int> incident(numbering.size(), 0);
  std::size_t border = 0;
  for(auto h : halfedges(mesh)) {
    if(is_border(h, mesh))
      ++border;
    ++incident[numbering(target(h, mesh))];
  }
  std::size_t isolated = 0, first_isolated = 0;
  for(std::size_t i = 0; i < incident.size(); ++i)
    if(incident[i] == 0 && isolated++ == 0)
      first_isolated = i;
  if(isolated > 0)
    throw Input_error(Error_code::ISOLATED_VERTEX, counted(isolated, "isolated vertex", "isolated vertices") +
                                                     ", the first one is vertex " + std::to_string(first_isolated) +
                                                     "; remove them");
  if(border > 0)
    throw Input_error(Error_code::BOUNDARY,
                      counted(border, "boundary edge", "boundary edges") + "; fill the holes first");
  for(auto v : vertices(mesh)) {
    int walked = 0;
    for(auto h : halfedges_around_target(halfedge(v, mesh), mesh)) {
      (void)h;
      ++walked;
    }
    if(walked != incident[numbering(v)])
      throw Input_error(Error_code::NON_MANIFOLD, "the faces round vertex " + std::to_string(numbering(v)) +
                                                    " form several fans; duplicate the vertex");
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CHECK_FACE_GRAPH_H
