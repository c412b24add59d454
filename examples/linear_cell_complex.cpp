// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// A Linear_cell_complex as a FaceGraph: the boundary of a solid, mapped and measured with the same calls as any other
// mesh. MESH, or else an ellipsoid.
//
//   linear_cell_complex [MESH]

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/Linear_cell_complex_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/spherical_parameterization.h>

#include <boost/property_map/property_map.hpp>

#include <iostream>
#include <map>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Linear_cell_complex_traits<3, Kernel> Traits;
typedef CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Traits>::type Complex;
typedef boost::graph_traits<Complex>::vertex_descriptor vertex_descriptor;

int main(int argc, char* argv[])
{
  Complex complex;
  if(argc == 1) {
    const auto points = get(CGAL::vertex_point, complex);
    SP::make_icosphere(3, complex, points);
    for(vertex_descriptor v : vertices(complex)) {
      const Point_3 p = get(points, v);
      put(points, v, Point_3(p.x(), 2 * p.y(), 3 * p.z()));
    }
  } else if(!CGAL::IO::read_polygon_mesh(argv[1], complex))
    return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;

  std::map<vertex_descriptor, Point_3> images;
  const boost::associative_property_map<decltype(images)> sphere(images);
  const auto result = SP::parameterize(complex, sphere);
  if(!result)
    return std::cerr << result << '\n', 1;
  std::cout << complex.one_dart_per_cell<2>().size() << " faces of the complex cover the sphere "
            << SP::degree_of_map(complex, sphere) << " time, " << SP::number_of_flipped_faces(complex, sphere)
            << " of them flipped\n";
}
