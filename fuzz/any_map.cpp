// SPDX-License-Identifier: GPL-3.0-or-later

#include "any_map.h"

#include "any_mesh.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <cmath>

namespace fuzz {
namespace {

using test::Mesh;
using test::Point;
typedef Mesh::Halfedge_index Halfedge;
typedef Mesh::Vertex_index Vertex;

constexpr std::size_t most_vertices = 80;
const char* const map_name = "v:sphere";

Point unit(double x, double y, double z)
{
  const double length = std::hypot(x, y, z);
  return Point(x / length, y / length, z / length);
}

bool is_positive(const Point& a, const Point& b, const Point& c)
{
  return test::exact_orientation(Point(0, 0, 0), a, b, c) == CGAL::POSITIVE;
}

/// Whether the faces round the vertex of h stay positively oriented with the vertex at p.
bool fits(const Mesh& mesh, Sphere_map sphere, Halfedge h, const Point& p)
{
  for(const Halfedge g : mesh.halfedges_around_target(h))
    if(!is_positive(p, sphere[mesh.target(mesh.next(g))], sphere[mesh.source(g)]))
      return false;
  return true;
}

/// From 1 down to what adds nothing to 1.
double any_share(Bytes& in) { return std::ldexp(1 + in.byte() / 256., -static_cast<int>(in.below(56))); }

Point any_mean(Bytes& in, const Point& a, const Point& b, const Point& c)
{
  const double s = any_share(in), t = any_share(in), u = any_share(in);
  return unit(s * a.x() + t * b.x() + u * c.x(), s * a.y() + t * b.y() + u * c.y(), s * a.z() + t * b.z() + u * c.z());
}

void insert(Bytes& in, Halfedge h, Sphere_map sphere, Mesh& mesh)
{
  const Point a = sphere[mesh.source(h)], b = sphere[mesh.target(h)], c = sphere[mesh.target(mesh.next(h))];
  const Point p = any_mean(in, a, b, c);
  if(is_positive(p, a, b) && is_positive(p, b, c) && is_positive(p, c, a))
    sphere[mesh.target(CGAL::Euler::add_center_vertex(h, mesh))] = p;
}

void move(Bytes& in, Halfedge h, Sphere_map sphere, const Mesh& mesh)
{
  const Point p = any_mean(in, sphere[mesh.target(h)], sphere[mesh.source(h)], sphere[mesh.target(mesh.next(h))]);
  if(fits(mesh, sphere, h, p))
    sphere[mesh.target(h)] = p;
}

void flip(Halfedge h, Sphere_map sphere, Mesh& mesh)
{
  const Vertex a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
  const Vertex s = mesh.source(h), t = mesh.target(h);
  if(a != b && mesh.halfedge(a, b) == Mesh::null_halfedge() && is_positive(sphere[a], sphere[b], sphere[t]) &&
     is_positive(sphere[b], sphere[a], sphere[s]))
    CGAL::Euler::flip_edge(h, mesh);
}

} // namespace

Mesh any_valid_map(Bytes& in)
{
  Mesh mesh = tetrahedron();
  const Sphere_map sphere = mesh.add_property_map<Vertex, Point>(map_name).first;
  const double s = std::sqrt(1. / 3);
  sphere[Vertex(0)] = Point(s, s, s);
  sphere[Vertex(1)] = Point(-s, -s, s);
  sphere[Vertex(2)] = Point(s, -s, -s);
  sphere[Vertex(3)] = Point(-s, s, -s);

  for(std::size_t steps = in.below(256); steps > 0 && mesh.number_of_vertices() < most_vertices; --steps) {
    const std::size_t what = in.below(4);
    const Halfedge h(static_cast<Mesh::size_type>(in.below(mesh.number_of_halfedges()))); // there is no garbage
    if(what == 0)
      insert(in, h, sphere, mesh);
    else if(what == 1)
      move(in, h, sphere, mesh);
    else
      flip(h, sphere, mesh);
  }
  return mesh;
}

Sphere_map sphere_of(const Mesh& mesh) { return mesh.property_map<Vertex, Point>(map_name).first; }

} // namespace fuzz
