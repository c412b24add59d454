// SPDX-License-Identifier: GPL-3.0-or-later

#include "any_mesh.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <array>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace fuzz {
namespace {

using test::Mesh;
using test::Point;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;

constexpr std::size_t most_vertices = 100;

Halfedge any_halfedge(Bytes& in, const Mesh& mesh)
{
  auto it = mesh.halfedges_begin();
  std::advance(it, static_cast<std::ptrdiff_t>(in.below(mesh.number_of_halfedges())));
  return *it;
}

/// Whether both sides of an edge are the same face, as of an edge to a vertex of degree 1.
bool is_inside_a_face(Halfedge h, const Mesh& mesh) { return mesh.face(h) == mesh.face(mesh.opposite(h)); }

void split_edge(Halfedge h, Mesh& mesh)
{
  if(is_inside_a_face(h, mesh))
    return;
  const Halfedge split = CGAL::Euler::split_edge(h, mesh); // in front of h, and both faces are quadrangles now
  CGAL::Euler::split_face(split, mesh.next(h), mesh);
  const Halfedge other = mesh.opposite(h);
  CGAL::Euler::split_face(other, mesh.next(mesh.next(other)), mesh);
}

void flip_edge(Halfedge h, bool keeps_simplicial, Mesh& mesh)
{
  if(is_inside_a_face(h, mesh))
    return;
  const Vertex a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
  if(keeps_simplicial && (a == b || mesh.halfedge(a, b) != Mesh::null_halfedge()))
    return;
  CGAL::Euler::flip_edge(h, mesh);
}

/// Any triangulation of the sphere is some flips away from any other.
Mesh closed_sphere(Bytes& in, bool is_simplicial)
{
  Mesh mesh = tetrahedron();
  for(std::size_t steps = in.below(256); steps > 0 && mesh.number_of_vertices() < most_vertices; --steps) {
    const std::size_t what = in.below(8);
    const Halfedge h = any_halfedge(in, mesh);
    if(what < 2)
      CGAL::Euler::add_center_vertex(h, mesh);
    else if(what < 3)
      split_edge(h, mesh);
    else if(what < 7)
      flip_edge(h, is_simplicial, mesh);
    else if(is_simplicial && mesh.number_of_vertices() > 4 &&
            CGAL::Euler::does_satisfy_link_condition(mesh.edge(h), mesh))
      CGAL::Euler::collapse_edge(mesh.edge(h), mesh); // leaves garbage
  }
  return mesh;
}

/// Polygons that may have anything in common.
void add_any_faces(Bytes& in, Mesh& mesh)
{
  std::vector<Vertex> vertices(mesh.vertices_begin(), mesh.vertices_end());
  for(std::size_t n = 1 + in.below(20); n > 0; --n)
    vertices.push_back(mesh.add_vertex());
  for(std::size_t n = in.below(64); n > 0; --n) {
    std::vector<Vertex> corners;
    std::set<Vertex> different;
    for(std::size_t k = in.below(8) == 0 ? 3 + in.below(4) : 3; k > 0; --k) {
      corners.push_back(vertices[in.below(vertices.size())]);
      different.insert(corners.back());
    }
    if(different.size() == corners.size())
      mesh.add_face(corners); // which says no where an edge has two faces already
  }
}

void damage(Bytes& in, Mesh& mesh)
{
  for(std::size_t n = 1 + in.below(3); n > 0; --n) {
    auto it = mesh.faces_begin();
    std::advance(it, static_cast<std::ptrdiff_t>(in.below(mesh.number_of_faces())));
    CGAL::Euler::remove_face(mesh.halfedge(*it), mesh);
  }
}

/// Removes two faces, and joins their borders by a tube: a handle, or one component more or less.
void add_handle(Bytes& in, Mesh& mesh)
{
  const Halfedge a = any_halfedge(in, mesh), b = any_halfedge(in, mesh);
  std::set<Vertex> corners;
  for(const Halfedge h : {a, b})
    for(const Vertex v : mesh.vertices_around_face(h))
      corners.insert(v);
  if(corners.size() < 6)
    return;
  std::array<Vertex, 3> p, q;
  for(std::size_t i = 0; i < 3; ++i) {
    p[i] = mesh.target(i == 0 ? a : i == 1 ? mesh.next(a) : mesh.prev(a));
    q[i] = mesh.target(i == 0 ? b : i == 1 ? mesh.prev(b) : mesh.next(b));
  }
  CGAL::Euler::remove_face(a, mesh);
  CGAL::Euler::remove_face(b, mesh);
  for(std::size_t i = 0; i < 3; ++i) {
    mesh.add_face(p[i], p[(i + 1) % 3], q[(i + 1) % 3]);
    mesh.add_face(p[i], q[(i + 1) % 3], q[i]);
  }
}

} // namespace

Mesh tetrahedron()
{
  Mesh mesh;
  const std::array<Vertex, 4> v = {mesh.add_vertex(), mesh.add_vertex(), mesh.add_vertex(), mesh.add_vertex()};
  for(const auto& [i, j, k] : {std::array<std::size_t, 3>{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}})
    mesh.add_face(v[i], v[j], v[k]);
  return mesh;
}

Mesh any_mesh(Bytes& in)
{
  const std::size_t kind = in.below(12);
  Mesh mesh = kind < 11 ? closed_sphere(in, kind != 7) : Mesh();
  switch(kind) {
  case 8: damage(in, mesh); break;
  case 9: add_handle(in, mesh); break;
  case 10:
  case 11: add_any_faces(in, mesh); break;
  default: break;
  }
  return mesh;
}

void put_any_points(Bytes& in, Mesh& mesh)
{
  const auto small_point = [&in] {
    const double x = in.small(), y = in.small(), z = in.small();
    return Point(x, y, z);
  };
  const std::size_t kind = in.below(10);
  const double size = kind == 3 || kind == 4 ? in.magnitude() : 1;
  const std::vector<Point> few = {small_point(), small_point(), small_point()};
  for(const Vertex v : mesh.vertices()) {
    Point p = kind == 5 ? few[in.below(3)] : small_point();
    switch(kind) {
    case 2: p = Point(in.number(), in.number(), in.number()); break;
    case 3: p = Point(size * p.x(), size * p.y(), size * p.z()); break;
    case 4: p = Point(size + p.x(), size + p.y(), p.z()); break;
    case 6: p = Point(p.x(), p.y(), 0); break;
    case 7: p = Point(p.x(), 2 * p.x(), 1); break;
    case 8: {
      const double length = std::hypot(p.x(), p.y(), p.z());
      if(length > 0)
        p = Point(p.x() / length, p.y() / length, p.z() / length);
      break;
    }
    default: break;
    }
    mesh.point(v) = p;
  }
  if(kind == 9 && mesh.number_of_vertices() > 0)
    mesh.point(*mesh.vertices_begin()) = Point(in.number(), in.number(), in.number());
}

bool is_simplicial(const Mesh& mesh)
{
  if(mesh.number_of_vertices() < 4) // a triangle with two sides has no double edges, either
    return false;
  std::set<std::pair<Vertex, Vertex>> seen;
  for(const Halfedge h : mesh.halfedges())
    if(mesh.source(h) == mesh.target(h) || !seen.emplace(mesh.source(h), mesh.target(h)).second)
      return false;
  return true;
}

bool is_finite(const Mesh& mesh)
{
  for(const Vertex v : mesh.vertices())
    for(int i = 0; i < 3; ++i)
      if(!std::isfinite(mesh.point(v)[i]))
        return false;
  return true;
}

} // namespace fuzz
