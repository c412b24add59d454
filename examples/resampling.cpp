// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Samples the shape of MESH, or else of an ellipsoid, at the vertices of an icosphere. Writes it to RESAMPLED, if
// given.
//
//   resampling [MESH [LEVEL [RESAMPLED]]]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <cstdlib>
#include <iostream>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc > 1) {
    if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
      return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;
  } else {
    SP::make_icosphere(3, mesh, mesh.points());
    for(Point_3& p : mesh.points())
      p = Point_3(p.x(), 2 * p.y(), 3 * p.z());
  }
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  // equal weights: limbs stay wider on the sphere than with conformal ones, and get more samples
  const auto result = SP::parameterize(mesh, sphere, CGAL::parameters::edge_weight_map(SP::barycentric_weights(mesh)));
  if(!result)
    return std::cerr << result << '\n', 1;

  Mesh out;
  auto directions = out.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const SP::Spherical_locator<Mesh> shape(mesh, sphere);
  SP::resample(shape, mesh.points(), argc > 2 ? std::atoi(argv[2]) : 5, out, out.points(), directions);
  std::cout << mesh.number_of_vertices() << " vertices have become " << out.number_of_vertices() << '\n';
  return argc < 4 || CGAL::IO::write_polygon_mesh(argv[3], out, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
