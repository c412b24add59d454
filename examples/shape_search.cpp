// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Finds the MESH whose shape is most similar to that of QUERY, independent of the pose. Without arguments: a cigar
// among a ball, a disc and another cigar.
//
//   shape_search [QUERY MESH...]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/shape_signature.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>
#include <CGAL/spherical_parameterization.h>
#include <CGAL/subdivision_method_3.h>

#include <iostream>
#include <string>
#include <vector>

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
namespace SP = CGAL::Spherical_parameterization;

Mesh ellipsoid(double a, double b, double c)
{
  Mesh mesh;
  CGAL::make_icosahedron<Mesh, Point_3>(mesh);
  CGAL::Subdivision_method_3::Loop_subdivision(mesh, CGAL::parameters::number_of_iterations(4));
  for(Point_3& p : mesh.points())
    p = Point_3(a * p.x(), b * p.y(), c * p.z());
  return mesh;
}

SP::Shape_signature signature(Mesh& mesh)
{
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  SP::parameterize(mesh, sphere); // a map that is not certified will do
  return SP::shape_signature(mesh, sphere);
}

int main(int argc, char* argv[])
{
  std::vector<std::string> names = {"a cigar", "a ball", "a disc", "another cigar"};
  std::vector<Mesh> meshes = {ellipsoid(1, 1, 4), ellipsoid(1, 1, 1), ellipsoid(4, 4, 1), ellipsoid(4.2, 1, 1)};
  if(argc > 2) {
    names.assign(argv + 1, argv + argc);
    meshes.assign(names.size(), Mesh());
    for(std::size_t i = 0; i < names.size(); ++i)
      if(!CGAL::IO::read_polygon_mesh(names[i], meshes[i])) {
        std::cerr << names[i] << ": cannot be read as a polygon mesh\n";
        return 1;
      }
  }
  const SP::Shape_signature query = signature(meshes[0]);
  std::cout.precision(2);
  for(std::size_t i = 1; i < meshes.size(); ++i)
    std::cout << SP::distance(query, signature(meshes[i])) << "  " << names[i] << '\n';
  return 0;
}
