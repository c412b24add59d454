// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_DEVICE_QUERIES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_DEVICE_QUERIES_H

#include <CGAL/Spherical_parameterization/OpenCL_device_info.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_call.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Every device of every platform, in an order that stays while no driver comes or goes.
inline std::vector<cl_device_id> opencl_device_ids()
{
  std::vector<cl_device_id> result;
  cl_uint count = 0;
  if(clGetPlatformIDs(0, nullptr, &count) != CL_SUCCESS || count == 0) // an error where no driver is installed
    return result;
  std::vector<cl_platform_id> platforms(count);
  check_opencl(clGetPlatformIDs(count, platforms.data(), nullptr), "clGetPlatformIDs");
  for(cl_platform_id platform : platforms) {
    if(clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS) // a driver without device
      continue;
    const std::size_t before = result.size();
    result.resize(before + count);
    check_opencl(clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, result.data() + before, nullptr),
                 "clGetDeviceIDs");
  }
  return result;
}

/// What `device` says of itself.
inline OpenCL_device_info opencl_device_info(cl_device_id device)
{
  const auto text = [&](cl_uint key) { return opencl_text(clGetDeviceInfo, "clGetDeviceInfo", device, key); };
  const auto number = [&](cl_uint key) {
    return opencl_value<cl_ulong>(clGetDeviceInfo, "clGetDeviceInfo", device, key);
  };
  OpenCL_device_info info;
  info.platform = opencl_text(
    clGetPlatformInfo, "clGetPlatformInfo",
    opencl_value<cl_platform_id>(clGetDeviceInfo, "clGetDeviceInfo", device, CL_DEVICE_PLATFORM), CL_PLATFORM_NAME);
  info.name = text(CL_DEVICE_NAME);
  info.driver = text(CL_DRIVER_VERSION);
  info.version = text(CL_DEVICE_VERSION);
  info.memory = number(CL_DEVICE_GLOBAL_MEM_SIZE);
  info.largest_allocation = number(CL_DEVICE_MAX_MEM_ALLOC_SIZE);
  info.has_fp64 = text(CL_DEVICE_EXTENSIONS).find("cl_khr_fp64") != std::string::npos;
  info.is_gpu = (number(CL_DEVICE_TYPE) & CL_DEVICE_TYPE_GPU) != 0;
  info.is_cpu = (number(CL_DEVICE_TYPE) & CL_DEVICE_TYPE_CPU) != 0;
  return info;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_DEVICE_QUERIES_H
