// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_QUEUE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_QUEUE_H

#include <CGAL/Spherical_parameterization/values/OpenCL_device_info.h>
#include <CGAL/Spherical_parameterization/values/OpenCL_error.h>
#if !__has_include(<CGAL/Spherical_parameterization/internal/backend/opencl/kernel_sources.h>)
#error                                                                                                                 \
  "CMake writes the sources of the kernels: include the installed package, or the folder include/ of a build as well"
#endif
#include <CGAL/Spherical_parameterization/internal/backend/opencl/kernel_sources.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Throws an OpenCL_error unless `code` is CL_SUCCESS.
inline void check_opencl(cl_int code, const char* call)
{
  if(code != CL_SUCCESS)
    throw OpenCL_error(call, code);
}

/// Held by what starts drivers: where two threads do at the same time, they crash, or there seem to be none (PoCL 3.1,
/// ocl-icd 2.3).
inline std::mutex& opencl_start()
{
  static std::mutex mutex;
  return mutex;
}

/// A platform for each driver.
inline std::vector<cl_platform_id> opencl_platform_ids()
{
  const std::lock_guard<std::mutex> lock(opencl_start());
  cl_uint count = 0;
  if(clGetPlatformIDs(0, nullptr, &count) != CL_SUCCESS || count == 0) // an error where no driver is installed
    return {};
  std::vector<cl_platform_id> platforms(count);
  check_opencl(clGetPlatformIDs(count, platforms.data(), nullptr), "clGetPlatformIDs");
  return platforms;
}

/// Every device of every platform, in an order that stays while no driver comes or goes.
inline std::vector<cl_device_id> opencl_device_ids()
{
  const std::vector<cl_platform_id> platforms = opencl_platform_ids();
  const std::lock_guard<std::mutex> lock(opencl_start());
  std::vector<cl_device_id> result;
  for(cl_platform_id platform : platforms) {
    cl_uint count = 0;
    if(clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, 0, nullptr, &count) != CL_SUCCESS) // a driver without device
      continue;
    const std::size_t before = result.size();
    result.resize(before + count);
    check_opencl(clGetDeviceIDs(platform, CL_DEVICE_TYPE_ALL, count, result.data() + before, nullptr),
                 "clGetDeviceIDs");
  }
  return result;
}

/// What an object of opencl.hpp answers to the query `call` about `key`: a number, a handle or a text.
template <class T, class Object>
T opencl_value(const Object& object, const char* call, cl_uint key)
{
  T value = T();
  check_opencl(object.getInfo(key, &value), call);
  return value;
}

/// A text, without blanks and null characters at its ends, which some drivers add.
template <class Object>
std::string opencl_text(const Object& object, const char* call, cl_uint key)
{
  std::string text = opencl_value<std::string>(object, call, key);
  text.erase(text.find_last_not_of(std::string(" \n\0", 3)) + 1);
  return text.substr((std::min)(text.find_first_not_of(' '), text.size()));
}

/// What a device says of itself.
inline OpenCL_device_info opencl_device_info(cl_device_id id)
{
  const cl::Device device(id, true);
  const char* const call = "clGetDeviceInfo";
  const cl::Platform platform(opencl_value<cl_platform_id>(device, call, CL_DEVICE_PLATFORM));
  const cl_device_type type = opencl_value<cl_device_type>(device, call, CL_DEVICE_TYPE);
  OpenCL_device_info info;
  info.platform = opencl_text(platform, "clGetPlatformInfo", CL_PLATFORM_NAME);
  info.name = opencl_text(device, call, CL_DEVICE_NAME);
  info.driver = opencl_text(device, call, CL_DRIVER_VERSION);
  info.version = opencl_text(device, call, CL_DEVICE_VERSION);
  info.memory = opencl_value<cl_ulong>(device, call, CL_DEVICE_GLOBAL_MEM_SIZE);
  info.largest_allocation = opencl_value<cl_ulong>(device, call, CL_DEVICE_MAX_MEM_ALLOC_SIZE);
  info.has_fp64 = opencl_text(device, call, CL_DEVICE_EXTENSIONS).find("cl_khr_fp64") != std::string::npos;
  info.is_gpu = (type & CL_DEVICE_TYPE_GPU) != 0;
  info.is_cpu = (type & CL_DEVICE_TYPE_CPU) != 0;
  return info;
}

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

/// A command queue, what is known of its device, and the kernels for it. A value: copies share the queue and the
/// kernels.
class OpenCL_queue {
public:
  /// \param queue           in order
  /// \param prefers_double  whether to compute with 64 bits where the device can
  /// Throws an OpenCL_error if the queue is not in order.
  OpenCL_queue(cl::CommandQueue queue, bool prefers_double) : queue_(std::move(queue))
  {
    const char* const call = "clGetCommandQueueInfo";
    device_ = opencl_value<cl_device_id>(queue_, call, CL_QUEUE_DEVICE);
    context_ = opencl_value<cl_context>(queue_, call, CL_QUEUE_CONTEXT);
    info_ = opencl_device_info(device_);
    is_double_ = prefers_double && info_.has_fp64;
    if(opencl_value<cl_command_queue_properties>(queue_, call, CL_QUEUE_PROPERTIES) &
       CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE)
      throw OpenCL_error("OpenCL_device", CL_INVALID_QUEUE_PROPERTIES, "the queue has to be in order");
  }

  const cl::CommandQueue& queue() const { return queue_; }
  cl_context context() const { return context_; } // kept alive by the queue
  cl_device_id device() const { return device_; }
  const OpenCL_device_info& info() const { return info_; }
  bool is_double_precision() const { return is_double_; }

  /// The kernels, compiled by the first call. Most drivers keep what they have compiled on disk. Any number of threads
  /// may ask.
  cl::Program program() const
  {
    const std::lock_guard<std::mutex> lock(kernels_->mutex);
    if(kernels_->program() == nullptr)
      kernels_->program = build_program(context_, device_, kernel_source(),
                                        std::string("-cl-std=CL1.2") +
                                          (is_double_ ? " -D CGAL_SP_DOUBLE" : " -cl-single-precision-constant") +
                                          (info_.is_cpu ? " -D CGAL_SP_CPU" : ""));
    return kernels_->program;
  }

  /// So that what is done on GPUs can be tested without one.
  void treat_as_gpu()
  {
    info_.is_cpu = false;
    kernels_ = std::make_shared<Kernels>();
  }

private:
  struct Kernels {
    std::mutex mutex;
    cl::Program program;
  };

  cl::CommandQueue queue_;
  cl_device_id device_;
  cl_context context_;
  OpenCL_device_info info_;
  bool is_double_;
  std::shared_ptr<Kernels> kernels_ = std::make_shared<Kernels>();
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_QUEUE_H
