// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the number of OpenCL devices and why there is no default one, as two threads find them that start the drivers
// at the same time.

#include <CGAL/Spherical_parameterization/OpenCL_device.h>

#include <array>
#include <cstddef>
#include <iostream>
#include <sstream>
#include <thread>

int main()
{
  namespace SP = CGAL::Spherical_parameterization;
  std::array<std::ostringstream, 2> found;
  const auto look = [&found](std::size_t i) {
    try {
      found[i] << SP::opencl_devices().size() << " devices\n";
      SP::opencl_device();
    } catch(const SP::OpenCL_error& error) {
      found[i] << error.what() << '\n';
    }
  };
  std::thread other(look, 0);
  look(1);
  other.join();
  std::cout << found[0].str() << found[1].str();
}
