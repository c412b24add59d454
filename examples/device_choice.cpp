// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// An OpenCL device of the user's choice: DEVICE is its index in the printed list, or a part of its name.
// Without it, the environment variable CGAL_SPHERICAL_PARAMETERIZATION_DEVICE decides, or else the first GPU. On a
// machine without any device the host maps the mesh.
//
//   device_choice [DEVICE]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/OpenCL_device.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/spherical_parameterization.h>

#include <iostream>
#include <optional>
#include <vector>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;

std::optional<SP::OpenCL_device> choose_device(const char* wanted)
{
  const std::vector<SP::OpenCL_device_info> devices = SP::opencl_devices();
  for(std::size_t k = 0; k < devices.size(); ++k)
    std::cerr << k << ": " << devices[k].name << (devices[k].has_fp64 ? "" : ", single precision only") << '\n';
  if(devices.empty() && !*wanted)
    return std::nullopt;
  return SP::opencl_device(SP::find_opencl_device(wanted)); // throws if there is no such device
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  SP::make_icosphere(5, mesh, mesh.points());
  for(Point_3& p : mesh.points())
    p = Point_3(p.x(), 2 * p.y(), 3 * p.z());
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point_3>("v:sphere").first;
  try {
    const auto device = choose_device(argc > 1 ? argv[1] : "");
    const SP::Result result =
      device ? SP::parameterize(*device, mesh, SP::Balanced(), sphere) : SP::parameterize(mesh, sphere);
    std::cerr << "ran on: " << result.device << '\n';
    std::cout << SP::get_error_message(result.error) << " of " << result.number_of_vertices << " vertices\n";
    return result ? 0 : 1;
  } catch(const SP::OpenCL_error& error) { // what failed, the code by its name, and a build log if there is one
    std::cerr << error.what() << '\n';
    return 1;
  }
}
