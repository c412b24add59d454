// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Progress and cancelling: a callback gets the fraction of the work that is done, and returns whether to continue.
// MESH, or else an ellipsoid, is mapped with a progress bar, and then again with a callback that stops it.
//
//   progress [MESH]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <iostream>
#include <string>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

bool show(double done)
{
  const std::size_t width = 40, filled = static_cast<std::size_t>(width * done);
  std::cerr << "\r[" << std::string(filled, '#') << std::string(width - filled, ' ') << ']' << std::flush;
  return true;
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1) {
    SP::make_icosphere(5, mesh, mesh.points());
    for(Point_3& p : mesh.points())
      p = Point_3(p.x(), 2 * p.y(), 4 * p.z());
  } else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;

  SP::Result result = SP::parameterize(mesh, sphere, CGAL::parameters::callback(show));
  std::cerr << '\n';
  std::cout << "with patience: " << SP::get_error_message(result.error) << '\n';

  // Or with a time limit: maximum_running_time(10). In both cases the best map so far is stored.
  int calls = 0;
  const auto lose_patience = [&](double) { return ++calls < 3; };
  result = SP::parameterize(mesh, sphere, CGAL::parameters::callback(lose_patience));
  std::cout << "without: " << SP::get_error_message(result.error) << '\n';
  return result.error == SP::Error_code::INTERRUPTED ? 0 : 1;
}
