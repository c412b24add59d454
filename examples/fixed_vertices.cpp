// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Fixed vertices: landmarks of an ellipsoid are kept at given positions on the sphere, and all other vertices are
// mapped between them. The positions are those of the free map, twisted about the axis: by ANGLE degrees in the north,
// by -ANGLE in the south.
//
//   fixed_vertices [ANGLE]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/spherical_parameterization.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

int main(int argc, char* argv[])
{
  const double angle = (argc > 1 ? std::atof(argv[1]) : 10) * std::acos(-1.) / 180;
  Mesh mesh;
  SP::make_icosphere(4, mesh, mesh.points());
  for(Point_3& p : mesh.points())
    p = Point_3(p.x(), p.y(), 2 * p.z());
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  if(const auto result = SP::parameterize(mesh, sphere); !result)
    return std::cerr << result << '\n', 1;

  auto is_fixed = mesh.add_property_map<Mesh::Vertex_index, bool>("v:is_fixed", false).first;
  auto wanted = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:wanted").first;
  const std::size_t landmarks = 42; // the vertices of the icosphere of level 1: many and well spread, as they should be
  for(Mesh::Vertex_index v : vertices(mesh)) {
    const Point_3 p = sphere[v];
    const double turn = angle * p.z();
    wanted[v] =
      Point_3(std::cos(turn) * p.x() - std::sin(turn) * p.y(), std::sin(turn) * p.x() + std::cos(turn) * p.y(), p.z());
    is_fixed[v] = v.idx() < landmarks;
    if(is_fixed[v])
      sphere[v] = wanted[v];
  }
  const auto result = SP::parameterize(mesh, sphere, CGAL::parameters::vertex_is_constrained_map(is_fixed));
  if(!result)
    return std::cerr << result << '\n', 1;

  double farthest = 0;
  for(Mesh::Vertex_index v : vertices(mesh))
    if(is_fixed[v])
      farthest = (std::max)(farthest, CGAL::squared_distance(sphere[v], wanted[v]));
  std::cout << landmarks << " of " << result.number_of_vertices << " vertices are at their given positions, to "
            << (farthest < 1e-30 ? "the last bit" : "rounding") << ", and no face is flipped\n";
}
