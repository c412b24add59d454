// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_FACE_GRAPH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_FACE_GRAPH_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/surface/breadth_first.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

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

template <class TriangleMesh, class Face>
bool are_triangles(const TriangleMesh& mesh, const std::vector<Face>& descriptors, const Host_loop& loop)
{
  if(descriptors.empty())
    return false;
  const int n = static_cast<int>(descriptors.size());
  return first_index(loop, n, [&](int f) { return !is_triangle(halfedge(descriptors[f], mesh), mesh); }) == n;
}

/// Walks round every vertex. Returns whether that meets each of its faces, and no border: whether the triangles form
/// a closed surface.
template <class TriangleMesh, class Vertex>
bool read_neighbours(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering,
                     const std::vector<Vertex>& descriptors, std::size_t number_of_faces, const Host_loop& loop,
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
    border += is_border(h, mesh);
    ++incident[numbering(target(h, mesh))];
  }
  const auto isolated = static_cast<std::size_t>(std::count(incident.begin(), incident.end(), 0));
  if(isolated > 0) {
    const auto first = std::find(incident.begin(), incident.end(), 0) - incident.begin();
    throw Input_error(Error_code::ISOLATED_VERTEX, counted(isolated, "isolated vertex", "isolated vertices") +
                                                     ", the first one is vertex " + std::to_string(first) +
                                                     "; remove them");
  }
  if(border > 0)
    throw Input_error(Error_code::BOUNDARY,
                      counted(border, "boundary edge", "boundary edges") + "; fill the holes first");
  for(auto v : vertices(mesh)) {
    const auto walk = halfedges_around_target(halfedge(v, mesh), mesh);
    if(std::distance(walk.begin(), walk.end()) != incident[numbering(v)])
      throw Input_error(Error_code::NON_MANIFOLD, "the faces round vertex " + std::to_string(numbering(v)) +
                                                    " form several fans; duplicate the vertex");
  }
}

/// What is known of a face graph that has been checked.
struct Checked_graph {
  Host_array<int> breadth_first; ///< the positions of its vertices in vertices(mesh), in this order
  bool is_simplicial;            ///< no edge ends where it begins, no two have the same ends
};

/// Throws Error for what is no closed, connected triangle mesh of genus 0.
/// \param numbering  of the vertices
template <class TriangleMesh, class Vertex, class Face>
Checked_graph check_face_graph(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering,
                               const std::vector<Vertex>& vertex_descriptors, const std::vector<Face>& face_descriptors,
                               const Host_loop& loop)
{
  Neighbours neighbours;
  if(!are_triangles(mesh, face_descriptors, loop) ||
     !read_neighbours(mesh, numbering, vertex_descriptors, face_descriptors.size(), loop, neighbours))
    explain_what_is_wrong(mesh, numbering);
  std::size_t components = 0;
  Host_array<int> order = breadth_first_order(neighbours, components);
  if(components > 1)
    throw Input_error(Error_code::SEVERAL_COMPONENTS,
                      counted(components, "component", "components") + "; map them one by one");
  // V - E + F = 2 - 2g, and 2E = 3F since all faces are triangles.
  const int n = static_cast<int>(order.size()), characteristic = n - static_cast<int>(face_descriptors.size() / 2);
  if(characteristic != 2)
    throw Input_error(Error_code::WRONG_GENUS, "genus " + std::to_string((2 - characteristic) / 2) +
                                                 "; only surfaces without handles map to the sphere");
  const int first_doubled = first_index(loop, n, [&](int i) {
    const auto begin = neighbours.target.begin() + neighbours.offset[i];
    const auto end = neighbours.target.begin() + neighbours.offset[i + 1];
    std::sort(begin, end);
    return std::binary_search(begin, end, i) || std::adjacent_find(begin, end) != end;
  });
  return {std::move(order), first_doubled == n};
}

/// The opposite halfedges of a face graph that has been checked, as in Corner_table: corner 0 of face f is the source
/// of halfedge(f).
/// \param descriptors  of all faces
template <class TriangleMesh, class Face>
Host_array<int> read_twins(const TriangleMesh& mesh, const std::vector<Face>& descriptors, const Host_loop& loop)
{
  const auto numbering = numbering_of<Face>(mesh, descriptors);
  Host_array<int> twin(3 * descriptors.size());
  for_each_index(loop, static_cast<int>(descriptors.size()), [&](int f) {
    auto h = halfedge(descriptors[f], mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto other = opposite(h, mesh);
      const auto first = halfedge(face(other, mesh), mesh);
      const int corner = other == first ? 0 : other == next(first, mesh) ? 1 : 2;
      twin[3 * f + k] = 3 * numbering(face(other, mesh)) + corner;
    }
  });
  return twin;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_FACE_GRAPH_H
