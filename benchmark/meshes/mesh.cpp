// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "meshes/mesh.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/subdivision_method_3.h>

#include <stdexcept>

namespace benchmark {
namespace {

// Keeps all points, and puts new ones on the middle of the edges.
struct Midpoint_mask {
  const Mesh* mesh;
  Sphere_map points;

  void edge_node(Mesh::Halfedge_index h, Point_3& p)
  {
    p = CGAL::midpoint(get(points, source(h, *mesh)), get(points, target(h, *mesh)));
  }
  void vertex_node(Mesh::Vertex_index v, Point_3& p) { p = get(points, v); }
  void border_node(Mesh::Halfedge_index, Point_3&, Point_3&) {}
};

} // namespace

Mesh read_mesh(const std::filesystem::path& file)
{
  Mesh mesh;
  bool is_read = false;
  try {
    is_read = CGAL::IO::read_polygon_mesh(file.string(), mesh);
  } catch(const std::exception&) { // a broken header, in some formats
  }
  if(!is_read || is_empty(mesh))
    throw std::runtime_error("cannot be read as a polygon mesh");
  return mesh;
}

void subdivide(Mesh& mesh, int times)
{
  for(int k = 0; k < times; ++k) {
    Midpoint_mask mask = {&mesh, mesh.points()};
    CGAL::Subdivision_method_3::PTQ(mesh, mask);
  }
}

Mesh decimated(Mesh mesh, double share_of_edges)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  // CGAL's predicate has another name from 5.6 on.
  SMS::edge_collapse(mesh, [&](const auto&, const auto&, std::size_t initial, std::size_t current) {
    return double(current) < share_of_edges * double(initial);
  });
  mesh.collect_garbage();
  return mesh;
}

} // namespace benchmark
