// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Distortion of areas and angles by a spherical map: prints the distortion of MESH, or else of a peanut, and the vertex
// of the largest stretch, which is the tip of a limb.
//
//   stretch [MESH]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <iostream>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

Mesh peanut()
{
  Mesh mesh;
  SP::make_icosphere(4, mesh, mesh.points());
  for(Point_3& p : mesh.points()) {
    const double radius = (0.4 + 0.6 * p.z() * p.z()) * (1 - 0.2 * p.z()); // one end is thinner than the other
    p = Point_3(radius * p.x(), radius * p.y(), 1.5 * p.z());
  }
  return mesh;
}

void print(const char* name, const SP::Distribution& d)
{
  std::cout << name << ": mean " << d.mean << ", 5 % below " << d.percentile_5 << ", median " << d.median
            << ", 5 % above " << d.percentile_95 << ", largest " << d.max << '\n';
}

int main(int argc, char* argv[])
{
  Mesh mesh = peanut();
  if(argc > 1 && (mesh.clear(), !CGAL::IO::read_polygon_mesh(argv[1], mesh)))
    return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const auto result = SP::parameterize(mesh, sphere);
  if(!result)
    return std::cerr << result << '\n', 1;

  std::cout.precision(3);
  const SP::Distortion_summary distortion = SP::distortion_summary(mesh, sphere);
  print("log area stretch", distortion.log_area_stretch);
  print("dilatation", distortion.dilatation);
  print("symmetric Dirichlet energy", distortion.symmetric_dirichlet);

  auto stretch = mesh.add_property_map<Mesh::Vertex_index, double>("v:stretch").first;
  const auto [least, greatest] = SP::vertex_log_area_stretch(mesh, sphere, stretch);
  for(Mesh::Vertex_index v : vertices(mesh))
    if(stretch[v] == greatest)
      std::cout << "shrunk most, by exp(" << greatest << "): " << v << " at " << mesh.point(v) << '\n';
}
