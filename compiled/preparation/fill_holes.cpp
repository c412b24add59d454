// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/mend.h"

#include "preparation/points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/exceptions.h>
#include <CGAL/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Patch_mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Triangle = std::array<int, 3>;

/// A disk over a polygon: vertices 0 to m - 1 are those of the polygon, others are new.
struct Disk {
  std::vector<Glued_surface::Point> new_points;
  std::vector<Triangle> triangles;
};

/// Cuts triangles of two neighbouring edges off a polygon, those with the shortest third side first, until `most`
/// vertices are left, which are returned.
std::vector<int> cut_corners(const std::vector<Kernel::Point_3>& polygon, std::size_t most,
                             std::vector<Triangle>& triangles)
{
  const int m = static_cast<int>(polygon.size());
  std::vector<int> previous, next;
  for(int i = 0; i < m; ++i) {
    previous.push_back((i + m - 1) % m);
    next.push_back((i + 1) % m);
  }
  using Corner = std::tuple<double, int, int, int>; // third side, squared; vertex, previous, next
  std::priority_queue<Corner, std::vector<Corner>, std::greater<>> queue;
  const auto add = [&](int i) {
    const int p = previous[place(i)], n = next[place(i)];
    queue.emplace(CGAL::squared_distance(polygon[place(p)], polygon[place(n)]), i, p, n);
  };
  for(int i = 0; i < m; ++i)
    add(i);
  std::vector<bool> is_cut(polygon.size(), false);
  for(std::size_t left = polygon.size(); left > most;) {
    const auto [side, i, p, n] = queue.top();
    queue.pop();
    if(is_cut[place(i)] || previous[place(i)] != p || next[place(i)] != n) // a neighbour was cut off since
      continue;
    triangles.push_back({p, i, n});
    is_cut[place(i)] = true;
    next[place(p)] = n;
    previous[place(n)] = p;
    add(p);
    add(n);
    --left;
  }
  std::vector<int> rest;
  for(int i = 0; i < m; ++i)
    if(!is_cut[place(i)])
      rest.push_back(i);
  return rest;
}

/// Of a polygon without new points, from whose corners all but `most` were cut off; empty if CGAL finds none.
/// `all_edges` are looked at, not only those of the Delaunay triangulation.
std::vector<Triangle> triangulated(const std::vector<Kernel::Point_3>& polygon, std::size_t most, bool all_edges)
{
  std::vector<Triangle> triangles;
  const std::vector<int> rest = cut_corners(polygon, most, triangles);
  std::vector<Kernel::Point_3> points;
  for(const int i : rest)
    points.push_back(polygon[place(i)]);
  std::vector<CGAL::Triple<int, int, int>> found;
  try {
    PMP::triangulate_hole_polyline(
      points, std::back_inserter(found),
      CGAL::parameters::use_delaunay_triangulation(!all_edges).do_not_use_cubic_algorithm(!all_edges));
  } catch(const CGAL::Failure_exception&) { // a precondition of CGAL that a polygon through itself breaks
    found.clear();
  }
  for(const auto& t : found)
    triangles.push_back({rest[place(t.first)], rest[place(t.second)], rest[place(t.third)]});
  for(Triangle& t : triangles)
    std::sort(t.begin(), t.end()); // in the direction of the polygon
  if(triangles.size() + 2 != polygon.size())
    triangles.clear();
  return triangles;
}

std::vector<Triangle> triangulated(const std::vector<Kernel::Point_3>& polygon)
{
  // Of equally good triangulations, as symmetric holes have them, CGAL takes the one that it meets first. With the
  // Delaunay triangulation this depends on addresses in memory, so it is for larger holes, which are rarely symmetric.
  constexpr std::size_t small = 100, most_of_all_edges = 200; // cubic time: .01 and .1 s
  constexpr std::size_t most = 500;                           // quadratic memory
  std::vector<Triangle> triangles;
  if(polygon.size() > small)
    triangles = triangulated(polygon, most, false);
  if(triangles.empty())
    triangles = triangulated(polygon, most_of_all_edges, true);
  return triangles;
}

Disk cone(const std::vector<Kernel::Point_3>& polygon)
{
  Disk disk;
  const int m = static_cast<int>(polygon.size());
  disk.new_points.push_back({0, 0, 0});
  for(const Kernel::Point_3& p : polygon)
    for(int k = 0; k < 3; ++k)
      disk.new_points[0][place(k)] += p[k] / m;
  for(int i = 0; i < m; ++i)
    disk.triangles.push_back({i, (i + 1) % m, m});
  return disk;
}

/// By which factor lengths in a disk are divided to make as many triangles as CGAL does by default, but not many more
/// than `most`. As there, its triangles have sides like the edges at the polygon.
double density(const std::vector<Kernel::Point_3>& polygon, const std::vector<Kernel::Point_3>& outer,
               const std::vector<Triangle>& triangles, double most)
{
  const auto length = [](const Kernel::Point_3& p, const Kernel::Point_3& q) {
    return std::sqrt(CGAL::squared_distance(p, q));
  };
  double area = 0, edge = 0;
  for(const auto& [a, b, c] : triangles)
    area += std::sqrt(CGAL::squared_area(polygon[place(a)], polygon[place(b)], polygon[place(c)]));
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const Kernel::Point_3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
    edge += (2 * length(p, q) + length(p, outer[i]) + length(q, outer[i])) / (4. * static_cast<double>(polygon.size()));
  }
  const double expected = area / (std::sqrt(3.) / 4 * edge * edge);
  return std::sqrt(2.) * (expected > most ? std::sqrt(most / expected) : 1);
}

/// The disk in CGAL's data structure, with the faces around it, whose edges say how fine the disk should be.
/// `outer[i]` is the third corner of the face at edge i of the polygon. Not many more triangles than `most` are made.
Disk refined(const std::vector<Kernel::Point_3>& polygon, const std::vector<Kernel::Point_3>& outer,
             const std::vector<Triangle>& triangles, double most)
{
  Patch_mesh mesh;
  for(const Kernel::Point_3& p : polygon)
    mesh.add_vertex(p);
  const auto vertex = [](int i) { return Patch_mesh::Vertex_index(static_cast<Patch_mesh::size_type>(i)); };
  std::vector<Patch_mesh::Face_index> inner, around;
  for(const Triangle& t : triangles)
    inner.push_back(mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2])));
  for(std::size_t i = 0; i < polygon.size(); ++i) {
    const auto a = vertex(static_cast<int>(i)), b = vertex(static_cast<int>((i + 1) % polygon.size()));
    around.push_back(mesh.add_face(b, a, mesh.add_vertex(outer[i])));
  }
  if(mesh.number_of_faces() < inner.size() + around.size()) // one did not fit
    return {{}, triangles};
  try {
    PMP::refine(mesh, inner, CGAL::Emptyset_iterator(), CGAL::Emptyset_iterator(),
                CGAL::parameters::density_control_factor(density(polygon, outer, triangles, most)));
  } catch(const CGAL::Failure_exception&) { // as above: then it is left coarse
    return {{}, triangles};
  }
  for(const auto f : around) // the disk is left
    CGAL::Euler::remove_face(mesh.halfedge(f), mesh);
  Disk disk;
  PMP::polygon_mesh_to_polygon_soup(mesh, disk.new_points, disk.triangles);
  disk.new_points.erase(disk.new_points.begin(), disk.new_points.begin() + static_cast<std::ptrdiff_t>(polygon.size()));
  return disk;
}

/// The sides of triangles by their ends. They are numbered as if no two had the same ends.
std::map<std::pair<int, int>, int> sides_of(const std::vector<Triangle>& triangles)
{
  std::map<std::pair<int, int>, int> sides;
  for(const Triangle& t : triangles)
    for(std::size_t k = 0; k < 3; ++k)
      sides.try_emplace({t[k], t[(k + 1) % 3]}, static_cast<int>(sides.size()));
  return sides;
}

/// \pre boundary[m - 1 - i] is the side that runs from vertex i + 1 of the polygon to vertex i
void add_disk(Glued_surface& surface, const std::vector<int>& boundary, const Disk& disk)
{
  const int m = static_cast<int>(boundary.size());
  std::vector<int> vertices;
  for(int i = 0; i < m; ++i)
    vertices.push_back(surface.target(boundary[place(m - 1 - i)]));
  for(const Glued_surface::Point& p : disk.new_points)
    vertices.push_back(surface.add_vertex(p));
  const int first_side = surface.number_of_sides();
  for(const Triangle& t : disk.triangles)
    surface.add_face({vertices[place(t[0])], vertices[place(t[1])], vertices[place(t[2])]});
  const auto sides = sides_of(disk.triangles);
  for(const auto& [ends, side] : sides) {
    const auto twin = sides.find({ends.second, ends.first});
    surface.glue(first_side + side,
                 twin == sides.end() ? boundary[place(m - 1 - ends.first)] : first_side + twin->second);
  }
}

/// Whether the triangles are a disk over a polygon of m edges: what add_disk() takes for granted.
bool is_disk(const Disk& disk, int m)
{
  const auto sides = sides_of(disk.triangles);
  if(sides.size() != 3 * disk.triangles.size())
    return false;
  int at_boundary = 0;
  for(const auto& entry : sides) {
    const auto [a, b] = entry.first;
    if(sides.count({b, a}) > 0)
      continue;
    if(a >= m || b != (a + 1) % m)
      return false;
    ++at_boundary;
  }
  return at_boundary == m;
}

} // namespace

void fill_hole(Glued_surface& surface, const std::vector<int>& boundary)
{
  if(boundary.size() == 1) { // a side with one end vertex: halved
    const int side = boundary[0];
    const Glued_surface::Point a = surface.point(surface.origin(side));
    const Glued_surface::Point c = surface.point(surface.target(Glued_surface::next(side)));
    const int middle = surface.add_vertex({(a[0] + c[0]) / 2, (a[1] + c[1]) / 2, (a[2] + c[2]) / 2});
    const int face = surface.add_face({surface.target(side), surface.origin(side), middle});
    surface.glue(3 * face, side);
    surface.glue(3 * face + 1, 3 * face + 2);
    return;
  }
  if(boundary.size() == 2) {
    surface.glue(boundary[0], boundary[1]);
    return;
  }
  std::vector<Kernel::Point_3> polygon, outer;
  const auto point = [&surface](int v) {
    const Glued_surface::Point& p = surface.point(v);
    return Kernel::Point_3(p[0], p[1], p[2]);
  };
  for(auto side = boundary.rbegin(); side != boundary.rend(); ++side) {
    polygon.push_back(point(surface.target(*side)));
    outer.push_back(point(surface.target(Glued_surface::next(*side))));
  }
  const int m = static_cast<int>(polygon.size());
  const std::vector<Triangle> triangles = triangulated(polygon);
  // edges of a large hole that are much finer than the rest of the surface would fill it with millions
  const double most = std::max(20'000, surface.number_of_faces());
  Disk disk;
  if(!triangles.empty())
    disk = refined(polygon, outer, triangles, most);
  if(!is_disk(disk, m))
    disk = {{}, triangles};
  if(!is_disk(disk, m))
    disk = cone(polygon);
  add_disk(surface, boundary, disk);
}

} // namespace CGAL::Spherical_parameterization::preparation
