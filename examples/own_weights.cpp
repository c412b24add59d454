// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Own weights: any property map from edges to positive numbers. Here larger weights (STIFFNESS, default 4; 1 is no
// change) contract the upper half of MESH, or else of an icosphere: it gets less area on the sphere.
//
//   own_weights [MESH [STIFFNESS]]

#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
namespace PMP = CGAL::Polygon_mesh_processing;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    SP::make_icosphere(4, mesh, mesh.points());
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;
  const double stiffness = argc > 2 ? std::atof(argv[2]) : 4;

  const CGAL::Bbox_3 box = PMP::bbox(mesh);
  const double middle = (box.zmin() + box.zmax()) / 2;
  const auto weights = SP::clamped_weights(mesh);
  auto own_weights = mesh.add_property_map<Mesh::Edge_index, double>("e:weight").first;
  for(Mesh::Edge_index e : edges(mesh)) {
    const Point_3 centre = CGAL::midpoint(mesh.point(source(e, mesh)), mesh.point(target(e, mesh)));
    own_weights[e] = get(weights, e) * (centre.z() > middle ? stiffness : 1);
  }
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const auto result = SP::parameterize(mesh, sphere, CGAL::parameters::edge_weight_map(own_weights));
  if(!result)
    return std::cerr << result << '\n', 1;

  std::vector<Mesh::Face_index> upper;
  for(Mesh::Face_index f : faces(mesh)) {
    const Mesh::Halfedge_index h = halfedge(f, mesh);
    const Point_3 &p = mesh.point(source(h, mesh)), &q = mesh.point(target(h, mesh));
    if(CGAL::centroid(p, q, mesh.point(target(next(h, mesh), mesh))).z() > middle)
      upper.push_back(f);
  }
  const auto share = [&](auto points) {
    const auto parameters = CGAL::parameters::vertex_point_map(points);
    return std::round(100 * PMP::area(upper, mesh, parameters) / PMP::area(mesh, parameters));
  };
  std::cout << "the upper half has " << share(mesh.points()) << " % of the surface and " << share(sphere)
            << " % of the sphere\n";
}
