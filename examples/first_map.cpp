// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Maps a closed mesh of genus 0 to the sphere: the mesh of the file MESH, or else an icosahedron. Writes the sphere to
// SPHERE, if given.
//
//   first_map [MESH [SPHERE.off]]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/spherical_parameterization.h>

#include <iostream>

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh)) {
    std::cerr << argv[1] << ": cannot be read as a polygon mesh\n";
    return 1;
  }
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const auto result = CGAL::Spherical_parameterization::parameterize(mesh, sphere);
  if(!result)
    return std::cerr << result << '\n', 1;
  std::cout << "valid spherical map of " << result.number_of_vertices << " vertices: " << result.flipped_faces
            << " flipped faces, degree " << result.degree << '\n';
  const auto parameters = CGAL::parameters::vertex_point_map(sphere).stream_precision(17);
  return argc < 3 || CGAL::IO::write_polygon_mesh(argv[2], mesh, parameters) ? 0 : 1;
}
