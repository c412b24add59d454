// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// A Polyhedron_3, whose vertices have no numbers and no second point: the sphere is kept in a hash table. MESH, or else
// an ellipsoid.
//
//   polyhedron [MESH]

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <boost/property_map/property_map.hpp>

#include <iostream>
#include <unordered_map>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Polyhedron_3<Kernel> Mesh;
typedef boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1) {
    SP::make_icosphere(3, mesh, get(CGAL::vertex_point, mesh));
    for(Point_3& p : CGAL::make_range(mesh.points_begin(), mesh.points_end()))
      p = Point_3(p.x(), p.y(), 3 * p.z());
  } else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;

  std::unordered_map<vertex_descriptor, Point_3> images;
  const boost::associative_property_map<decltype(images)> sphere(images);
  const auto result = SP::parameterize(mesh, sphere);
  if(!result)
    return std::cerr << result << '\n', 1;

  const SP::Distortion_summary distortion = SP::distortion_summary(mesh, sphere);
  std::cout.precision(3);
  std::cout << images.size() << " vertices have an image; median log area stretch "
            << distortion.log_area_stretch.median << '\n';
}
