// SPDX-License-Identifier: GPL-3.0-or-later
// A program that takes few seconds to compile: are headers and libraries found?

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/version.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Mesh::Point(1, 1, 1), Mesh::Point(-1, -1, 1), Mesh::Point(-1, 1, -1), Mesh::Point(1, -1, -1),
                         mesh); // round the origin: each vertex is its direction
  const int degree = CGAL::Spherical_parameterization::degree_of_map(mesh, mesh.points());
  std::cout << CGAL_SPHERICAL_PARAMETERIZATION_VERSION << " sequential" << std::endl;
  return degree == 1 || degree == -1 ? 0 : 1;
}
