// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_OPENCL_DEVICE_INFO_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_OPENCL_DEVICE_INFO_H

#include <cstddef>
#include <string>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationPolicies
/// @{

/// The properties of an OpenCL device.
struct OpenCL_device_info {
  std::string platform;               ///< whose driver it is
  std::string name;                   ///< name of the device
  std::string driver;                 ///< its version
  std::string version;                ///< of OpenCL
  std::size_t memory = 0;             ///< in bytes
  std::size_t largest_allocation = 0; ///< of one array, in bytes
  bool has_fp64 = false;              ///< double precision
  bool is_gpu = false;                ///< a graphics processor
  bool is_cpu = false;                ///< works in the memory of the host
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_OPENCL_DEVICE_INFO_H
