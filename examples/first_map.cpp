// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Maps a closed genus-0 mesh to the sphere and writes the sphere.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <iostream>

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc < 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << "usage: first_map MESH SPHERE.off\n";
    return 2;
  }
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const auto result = CGAL::Spherical_parameterization::parameterize(mesh, sphere);
  std::cout << result << '\n';
  if(!result)
    return 1;
  const auto parameters = CGAL::parameters::vertex_point_map(sphere).stream_precision(17);
  return CGAL::IO::write_polygon_mesh(argv[2], mesh, parameters) ? 0 : 1;
}
