// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Morphs one shape into another one: the map of the second shape is aligned with that of the first, then both shapes
// are sampled at the vertices of one icosphere. Without files a box becomes a spindle.
//
//   morph [MESH_A MESH_B [T [MORPHED]]]     T from 0 (A) to 1 (B)

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

struct Shape {
  Mesh mesh;
  Mesh::Property_map<Mesh::Vertex_index, Point_3> sphere;
};

void make_shape(Shape& shape, bool is_box)
{
  SP::make_icosphere(4, shape.mesh, shape.mesh.points());
  for(Point_3& p : shape.mesh.points()) {
    const double size = is_box ? (std::max)({std::abs(p.x()), std::abs(p.y()), std::abs(p.z()) / 2}) : 1;
    p = is_box ? Point_3(p.x() / size, p.y() / size, p.z() / size) : Point_3(p.x() / 2, p.y() / 2, 2 * p.z());
  }
}

bool map(Shape& shape)
{
  shape.sphere = shape.mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const auto result =
    SP::parameterize(shape.mesh, shape.sphere, CGAL::parameters::edge_weight_map(SP::barycentric_weights(shape.mesh)));
  if(!result)
    std::cerr << result << '\n';
  return bool(result);
}

int main(int argc, char* argv[])
{
  Shape a, b;
  if(argc < 3) {
    make_shape(a, true);
    make_shape(b, false);
  } else if(!CGAL::IO::read_polygon_mesh(argv[1], a.mesh) || !CGAL::IO::read_polygon_mesh(argv[2], b.mesh))
    return std::cerr << "a mesh cannot be read\n", 1;
  if(!map(a) || !map(b))
    return 1;

  const SP::Spherical_locator<Mesh> on_a(a.mesh, a.sphere), on_b(b.mesh, b.sphere);
  const SP::Rotation rotation = SP::aligning_rotation(on_a, a.mesh.points(), on_b, b.mesh.points());
  Mesh out;
  auto directions = out.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  auto end = out.add_property_map<Mesh::Vertex_index, Point_3>("v:end").first;
  SP::resample(on_a, a.mesh.points(), 6, out, out.points(), directions);
  SP::transfer_vertex_property(on_b, b.mesh.points(), out, SP::rotated_map(directions, rotation), end);

  const double t = argc > 3 ? std::atof(argv[3]) : 0.5;
  for(Mesh::Vertex_index v : vertices(out))
    out.point(v) += t * (end[v] - out.point(v));
  std::cout << out.number_of_vertices() << " vertices\n";
  return argc < 5 || CGAL::IO::write_polygon_mesh(argv[4], out, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
