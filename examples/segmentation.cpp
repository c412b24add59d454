// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Segments MESH, or else a ball with four limbs, into body and limbs, and also by CGAL's SDF values. Prints
// on the standard error how long each took, without the map.
//
//   segmentation [MESH]

#include <CGAL/Real_timer.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

Mesh ball_with_limbs() // in the directions of the corners of a tetrahedron
{
  Mesh mesh;
  SP::make_icosphere(5, mesh, mesh.points());
  for(Kernel::Point_3& p : mesh.points()) {
    double nearest = -1;
    for(const auto& d : {Kernel::Vector_3(1, 1, 1), {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}})
      nearest = (std::max)(nearest, (p - CGAL::ORIGIN) * d / std::sqrt(3.));
    const double sine = std::sqrt((std::max)(0., 1 - nearest * nearest));
    if(nearest > 0 && sine < 0.4)
      p = CGAL::ORIGIN + (1 + 3 * std::sqrt(1 - sine / 0.4)) * (p - CGAL::ORIGIN);
  }
  return mesh;
}

int main(int argc, char* argv[])
{
  Mesh mesh = ball_with_limbs();
  if(argc > 1 && (mesh.clear(), !CGAL::IO::read_polygon_mesh(argv[1], mesh)))
    return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:sphere").first;
  SP::parameterize(mesh, sphere); // limbs too thin for a valid map do no harm

  auto ours = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
  auto by_sdf = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:sdf_segment").first;
  CGAL::Real_timer timer;
  timer.start();
  const auto result = SP::segmentation_via_area_stretch(mesh, sphere, ours);
  if(!result)
    return std::cerr << SP::get_error_message(result.error) << ": " << result.detail << '\n', 1;
  const double seconds = timer.time();
  const std::size_t sdf_segments = CGAL::segmentation_via_sdf_values(mesh, by_sdf);
  std::cerr << seconds << " s, by SDF values " << timer.time() - seconds << " s\n";
  std::cout << result.number_of_segments << " segments, by SDF values " << sdf_segments << '\n';
}
