// SPDX-License-Identifier: GPL-3.0-or-later
// Prints the number of OpenCL devices, and why there is no default one.

#include <CGAL/Spherical_parameterization/OpenCL_device.h>

#include <iostream>

int main()
{
  namespace SP = CGAL::Spherical_parameterization;
  std::cout << SP::opencl_devices().size() << " devices\n";
  try {
    SP::opencl_device();
  } catch(const SP::OpenCL_error& error) {
    std::cout << error.what() << '\n';
  }
}
