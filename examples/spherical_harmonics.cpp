// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The shape of MESH, or else of a bean, in spherical harmonics of degree DEGREE. Writes RECONSTRUCTION, if given.
//
//   spherical_harmonics [MESH [DEGREE [RECONSTRUCTION]]]

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
    SP::make_icosphere(4, mesh, mesh.points());
    for(Point_3& p : mesh.points())
      p = Point_3(3 * p.x(), p.y() + p.x() * p.x(), p.z());
  }
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const auto result = SP::parameterize(mesh, SP::Isometric(), sphere); // conformal maps need far more degrees
  if(!result)
    return std::cerr << result << '\n', 1;

  const int degree = argc > 2 ? std::atoi(argv[2]) : 16;
  const auto analysis = SP::harmonic_analysis(mesh, sphere, mesh.points(), degree); // least squares

  auto smooth = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:smooth").first;
  std::cout.precision(1);
  std::cout.setf(std::ios::fixed);
  for(int l = 1; l <= degree; l *= 2) {
    SP::harmonic_synthesis(SP::with_degree(analysis.coefficients, l), mesh, sphere, smooth);
    std::cout << "degree " << l << ": error " << 100 * SP::reconstruction_error(mesh, mesh.points(), smooth).relative
              << " %\n";
  }
  SP::harmonic_synthesis(analysis.coefficients, mesh, sphere, smooth);
  for(Mesh::Vertex_index v : vertices(mesh))
    mesh.point(v) = smooth[v];
  return argc < 4 || CGAL::IO::write_polygon_mesh(argv[3], mesh, CGAL::parameters::stream_precision(17)) ? 0 : 1;
}
