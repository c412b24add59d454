// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Densities: one end of a lumpy body is to have four times as much area on the sphere, per area of the body, as the
// rest. The larger the area exponent, the closer the areas are to their targets.
//
//   densities

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/spherical_parameterization.h>

#include <cmath>
#include <iostream>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

int main()
{
  Mesh mesh;
  SP::make_icosphere(4, mesh, mesh.points());
  for(Point_3& p : mesh.points()) {
    const double r = 1 + 0.3 * std::sin(3 * p.x() + 1) * std::cos(2 * p.y()) + 0.2 * std::sin(4 * p.z());
    p = Point_3(1.5 * r * p.x(), r * p.y(), 0.7 * r * p.z());
  }
  auto density = mesh.add_property_map<Mesh::Vertex_index, double>("v:density", 1).first;
  for(Mesh::Vertex_index v : vertices(mesh))
    if(mesh.point(v).x() > 1)
      density[v] = 4;

  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  bool are_certified = true;
  for(double exponent : {1, 3, 10, 30}) {
    const auto result =
      SP::parameterize(mesh, SP::Isometric{exponent}, sphere, CGAL::parameters::vertex_density_map(density));
    are_certified = are_certified && result;
    std::cout << "exponent " << exponent << ": " << (result ? "certified" : result.detail)
              << ", areas deviate from their targets by " << std::round(100 * result.density_deviation) << " %\n";
  }
  return are_certified ? 0 : 1;
}
