// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The execution policy changes the time, not the result: the map of MESH, or else of an ellipsoid, with every policy
// that this program was built with. Prints on the standard error how long each took.
//
//   policies [MESH]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/OpenCL_device.h>
#endif

#include <iostream>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

template <class Policy>
std::vector<Point_3> map(const Policy& policy, Mesh& mesh)
{
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  const auto result = SP::parameterize(policy, mesh, SP::Balanced(), sphere);
  std::cerr << result.device << ": " << result << '\n';
  return std::vector<Point_3>(sphere.begin(), sphere.end());
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1) {
    SP::make_icosphere(5, mesh, mesh.points()); // 10,242 vertices: enough for a device to be used
    for(Point_3& p : mesh.points())
      p = Point_3(p.x(), 2 * p.y(), 3 * p.z());
  } else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;

  const std::vector<Point_3> sphere = map(CGAL::Sequential_tag(), mesh);
  bool are_equal = true;
#ifdef CGAL_LINKED_WITH_TBB // the program is linked with CGAL::TBB_support
  are_equal = are_equal && map(CGAL::Parallel_tag(), mesh) == sphere;
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL // and with OpenCL
  for(std::size_t k = 0; k < SP::opencl_devices().size(); ++k)
    if(SP::opencl_devices()[k].has_fp64)
      are_equal = are_equal && map(SP::opencl_device(k, SP::OpenCL_device::Precision::DOUBLE), mesh) == sphere;
#endif
  std::cout << "the maps are " << (are_equal ? "equal bit by bit" : "not equal") << '\n';
  return are_equal ? 0 : 1;
}
