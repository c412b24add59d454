// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_PROGRAM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_PROGRAM_H

#include <CGAL/Spherical_parameterization/internal/backend/opencl/Binary_cache.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_call.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/kernel_sources.h>

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline cl::Program program_from_source(cl_context context, cl_device_id device, const std::string& source,
                                       const std::string& options)
{
  const char* text = source.c_str();
  cl_int code = CL_SUCCESS;
  cl::Program program(clCreateProgramWithSource(context, 1, &text, nullptr, &code));
  check_opencl(code, "clCreateProgramWithSource");
  code = clBuildProgram(program(), 1, &device, options.c_str(), nullptr, nullptr);
  if(code != CL_SUCCESS) {
    std::size_t size = 0;
    clGetProgramBuildInfo(program(), device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &size);
    std::string log(size, '\0');
    clGetProgramBuildInfo(program(), device, CL_PROGRAM_BUILD_LOG, size, &log[0], nullptr);
    log.erase(log.find_last_not_of(std::string(" \n\0", 3)) + 1);
    throw OpenCL_error("clBuildProgram", code, "the kernels do not compile on this device", log);
  }
  return program;
}

/// Nothing where the driver does not like the binary: it may be from before an update.
inline std::optional<cl::Program> program_from_binary(cl_context context, cl_device_id device,
                                                      const std::string& binary, const std::string& options)
{
  const std::size_t size = binary.size();
  const unsigned char* bytes = reinterpret_cast<const unsigned char*>(binary.data());
  cl_int status = CL_SUCCESS, code = CL_SUCCESS;
  const cl::Program program(clCreateProgramWithBinary(context, 1, &device, &size, &bytes, &status, &code));
  if(code != CL_SUCCESS || status != CL_SUCCESS ||
     clBuildProgram(program(), 1, &device, options.c_str(), nullptr, nullptr) != CL_SUCCESS)
    return {};
  return program;
}

/// Empty where the driver hands out none.
inline std::string binary_of(const cl::Program& program, cl_device_id device)
{
  const auto devices = opencl_values<cl_device_id>(clGetProgramInfo, "clGetProgramInfo", program(), CL_PROGRAM_DEVICES);
  const auto sizes =
    opencl_values<std::size_t>(clGetProgramInfo, "clGetProgramInfo", program(), CL_PROGRAM_BINARY_SIZES);
  const std::size_t k = std::find(devices.begin(), devices.end(), device) - devices.begin();
  if(k >= sizes.size())
    return {};
  std::string binary(sizes[k], '\0');
  std::vector<unsigned char*> where(sizes.size(), nullptr); // null: not wanted
  where[k] = reinterpret_cast<unsigned char*>(&binary[0]);
  check_opencl(clGetProgramInfo(program(), CL_PROGRAM_BINARIES, where.size() * sizeof where[0], where.data(), nullptr),
               "clGetProgramInfo");
  return binary;
}

/// All that a compiled program depends on.
inline std::string program_key(cl_device_id device, const std::string& source, const std::string& options)
{
  const cl_platform_id platform =
    opencl_value<cl_platform_id>(clGetDeviceInfo, "clGetDeviceInfo", device, CL_DEVICE_PLATFORM);
  std::string key;
  for(cl_uint what : {CL_PLATFORM_NAME, CL_PLATFORM_VERSION})
    key += opencl_text(clGetPlatformInfo, "clGetPlatformInfo", platform, what) + '\n';
  for(cl_uint what : {CL_DEVICE_NAME, CL_DEVICE_VERSION, CL_DRIVER_VERSION})
    key += opencl_text(clGetDeviceInfo, "clGetDeviceInfo", device, what) + '\n';
  return key + options + '\n' + source;
}

/// `source` compiled for `device`, or taken from the cache.
inline cl::Program build_program(cl_context context, cl_device_id device, const std::string& source,
                                 const std::string& options, const Binary_cache& cache = Binary_cache())
{
  const std::string key = program_key(device, source, options);
  if(const std::optional<std::string> binary = cache.load(key))
    if(const std::optional<cl::Program> program = program_from_binary(context, device, *binary, options))
      return *program;
  cl::Program program = program_from_source(context, device, source, options);
  const std::string binary = binary_of(program, device);
  if(!binary.empty())
    cache.store(key, binary);
  return program;
}

inline std::string build_options(bool is_double, bool is_cpu)
{
  return std::string("-cl-std=CL1.2") + (is_double ? " -D CGAL_SP_DOUBLE" : "") + (is_cpu ? " -D CGAL_SP_CPU" : "");
}

/// The kernels of this package for one device, compiled when they are asked for first. Any number of threads may ask.
class OpenCL_program {
public:
  cl::Program get(cl_context context, cl_device_id device, bool is_double, bool is_cpu)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if(program_() == nullptr)
      program_ = build_program(context, device, kernel_source(), build_options(is_double, is_cpu));
    return program_;
  }

private:
  std::mutex mutex_;
  cl::Program program_;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_PROGRAM_H
