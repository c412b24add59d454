// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_PROGRAM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_PROGRAM_H

#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_call.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/kernel_sources.h>

#include <cstddef>
#include <mutex>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// `source` compiled for `device`. Throws an OpenCL_error with the build log where it does not compile.
inline cl::Program build_program(cl_context context, cl_device_id device, const std::string& source,
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

inline std::string build_options(bool is_double, bool is_cpu)
{
  return std::string("-cl-std=CL1.2") + (is_double ? " -D CGAL_SP_DOUBLE" : "") + (is_cpu ? " -D CGAL_SP_CPU" : "");
}

/// The kernels of this package for one device, compiled when they are asked for first. Most drivers keep what
/// they have compiled on disk. Any number of threads may ask.
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

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_PROGRAM_H
