// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_SURFACE_H

#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/check_face_graph.h>
#include <CGAL/Spherical_parameterization/values/Error.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// \file
/// The one place where face graphs and their maps become arrays. An `Indexed_triangle_mesh` is a face graph that has
/// been checked when it was made.

/// What is asked of a mesh, and how its vertices are numbered.
enum class Reading {
  UNCHECKED, ///< any triangles, to be looked at one by one; vertices have the numbers of the mesh
  CHECKED,   ///< a closed, connected surface of genus 0 with finite points; vertices have the numbers of the mesh
  MEASURED,  ///< the same, and the coordinates are not rounded
  /// The same in breadth-first order: neighbours then lie close together in memory, which more than halves the time of
  /// every sweep on large meshes, whatever the order of the input.
  BREADTH_FIRST
};

/// The vertices of a mesh by the numbers that they have in a Surface.
template <class TriangleMesh>
using Vertices = std::vector<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>;

/// The values of a map at some vertices as vectors. Read on the calling thread, whatever the policy.
template <class Range, class VertexMap>
Host_array<vec3> vectors_at(const Range& vertices, VertexMap map)
{
  Host_array<vec3> result;
  result.reserve(static_cast<std::size_t>(std::distance(vertices.begin(), vertices.end())));
  for(auto v : vertices)
    result.push_back(coordinates(get(map, v)));
  return result;
}

/// A range of points or directions as vectors.
template <class Points>
Host_array<vec3> vectors_of(const Points& points)
{
  Host_array<vec3> result;
  for(const auto& p : points)
    result.push_back(coordinates(p));
  return result;
}

/// Writes vectors into a map of some vertices, as its points hold them.
template <class Range, class VertexMap>
void put_vectors(const Range& vertices, const Host_array<vec3>& vectors, VertexMap map)
{
  typedef typename boost::property_traits<VertexMap>::value_type Point;
  auto vector = vectors.begin();
  for(auto v : vertices)
    put(map, v, stored_point<Point>(*vector++));
}

/// The corners of face f: source(h), target(h) and target(next(h)) for h = halfedge(f).
template <class TriangleMesh, class Number>
std::array<int, 3> corners_of_face(const TriangleMesh& mesh, const Number& number,
                                   typename boost::graph_traits<TriangleMesh>::face_descriptor f)
{
  const auto h = halfedge(f, mesh);
  return {number(source(h, mesh)), number(target(h, mesh)), number(target(next(h, mesh), mesh))};
}

/// Reads all but the points. Throws Error for what is too large, or not what was asked for.
template <class TriangleMesh>
Surface read_faces(const TriangleMesh& mesh, Reading reading, const Host_loop& loop, Vertices<TriangleMesh>& vertex)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  check_size(mesh);
  const auto numbering = numbering_of<typename Graph_traits::vertex_descriptor>(mesh, vertices(mesh));
  const std::vector<typename Graph_traits::face_descriptor> faces_of_mesh(faces(mesh).begin(), faces(mesh).end());
  vertex.assign(vertices(mesh).begin(), vertices(mesh).end());
  const int n = static_cast<int>(vertex.size()), m = static_cast<int>(faces_of_mesh.size());
  Surface surface;
  surface.number_of_vertices = n;
  if(reading != Reading::UNCHECKED) {
    if constexpr(Has_breadth_first_order<TriangleMesh>::value)
      surface.position = mesh.breadth_first_order();
    else {
      Checked_graph checked = check_face_graph(mesh, numbering, vertex, faces_of_mesh, loop);
      surface.position = std::move(checked.breadth_first);
      surface.is_simplicial = checked.is_simplicial;
    }
  }
  Host_array<int> index;
  if(reading == Reading::BREADTH_FIRST) {
    Vertices<TriangleMesh> sorted(vertex.size());
    for_each_index(loop, n, [&](int i) { sorted[i] = vertex[surface.position[i]]; });
    vertex.swap(sorted);
    index = inverse_permutation(loop, surface.position);
  } else
    Host_array<int>().swap(surface.position);
  const auto number = [&](const auto& v) { return index.empty() ? numbering(v) : index[numbering(v)]; };
  surface.face.resize(faces_of_mesh.size());
  for_each_index(loop, m, [&](int f) { surface.face[f] = corners_of_face(mesh, number, faces_of_mesh[f]); });
  if(!surface.is_simplicial)
    surface.set_twin(read_twins(mesh, faces_of_mesh, loop));
  return surface;
}

/// Throws Error for what is too large, or not what was asked for. Property maps are read on the calling thread, but for
/// points whose coordinates are plain numbers.
template <class TriangleMesh, class VertexPointMap>
Surface read_surface(const TriangleMesh& mesh, VertexPointMap points, Reading reading, const Host_loop& where_safe,
                     Vertices<TriangleMesh>& vertex)
{
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  const Host_loop loop = are_plain_coordinates<Point>() ? where_safe : Host_loop();
  Surface surface = read_faces(mesh, reading, loop, vertex);
  const int n = surface.number_of_vertices;
  surface.point.resize(n);
  for_each_index(loop, n, [&](int i) { surface.point[i] = coordinates(get(points, vertex[i])); });
  const int bad = first_index(loop, n, [&](int i) { return !is_finite(surface.point[i]); });
  if(bad < n && reading != Reading::UNCHECKED)
    throw Input_error(Error_code::NON_FINITE_COORDINATE,
                      "vertex " + std::to_string(surface.position.empty() ? bad : surface.position[bad]));
  const bool is_measured = reading == Reading::UNCHECKED || reading == Reading::MEASURED;
  is_measured ? scale_exactly(surface.point) : scale_to_unit_box(surface.point);
  return surface;
}

/// Without the points.
template <class TriangleMesh, class VertexSphereMap>
Mapped_surface read_map(const TriangleMesh& mesh, VertexSphereMap sphere_map, Reading reading, const Host_loop& loop)
{
  Vertices<TriangleMesh> vertex;
  Mapped_surface map;
  static_cast<Surface&>(map) = read_faces(mesh, reading, loop, vertex);
  map.image = vectors_at(vertex, sphere_map);
  return map;
}

template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
Mapped_surface read_map(const TriangleMesh& mesh, VertexPointMap points, VertexSphereMap sphere_map, Reading reading,
                        const Host_loop& loop)
{
  Vertices<TriangleMesh> vertex;
  Mapped_surface map;
  static_cast<Surface&>(map) = read_surface(mesh, points, reading, loop, vertex);
  map.image = vectors_at(vertex, sphere_map);
  return map;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_READ_SURFACE_H
