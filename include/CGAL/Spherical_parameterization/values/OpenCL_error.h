// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_OPENCL_ERROR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_OPENCL_ERROR_H

// Includes CL/opencl.hpp for OpenCL 1.2. Settings of the user stay: a newer version works, with and without
// CL_HPP_ENABLE_EXCEPTIONS. The classes of opencl.hpp only own handles and tell what a device is; every other call that
// can fail is one of the C interface.
#ifndef CL_HPP_TARGET_OPENCL_VERSION
#define CL_HPP_TARGET_OPENCL_VERSION 120
#ifndef CL_HPP_MINIMUM_OPENCL_VERSION
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#endif
#endif
#ifndef CL_USE_DEPRECATED_OPENCL_1_2_APIS
#define CL_USE_DEPRECATED_OPENCL_1_2_APIS // clCreateCommandQueue, the only one that every platform has
#endif
#include <CL/opencl.hpp>

#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationPolicies
/// @{

/// The name of an error code of OpenCL, such as `"CL_OUT_OF_RESOURCES"`.
/// \param code  the code that a function of OpenCL has returned
/// \return the name of the macro, or that it is unknown
inline const char* opencl_error_name(cl_int code)
{
  // clang-format off
  static constexpr const char* from_0_down[] = {
    "CL_SUCCESS", "CL_DEVICE_NOT_FOUND", "CL_DEVICE_NOT_AVAILABLE", "CL_COMPILER_NOT_AVAILABLE",
    "CL_MEM_OBJECT_ALLOCATION_FAILURE", "CL_OUT_OF_RESOURCES", "CL_OUT_OF_HOST_MEMORY",
    "CL_PROFILING_INFO_NOT_AVAILABLE", "CL_MEM_COPY_OVERLAP", "CL_IMAGE_FORMAT_MISMATCH",
    "CL_IMAGE_FORMAT_NOT_SUPPORTED", "CL_BUILD_PROGRAM_FAILURE", "CL_MAP_FAILURE", "CL_MISALIGNED_SUB_BUFFER_OFFSET",
    "CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST", "CL_COMPILE_PROGRAM_FAILURE", "CL_LINKER_NOT_AVAILABLE",
    "CL_LINK_PROGRAM_FAILURE", "CL_DEVICE_PARTITION_FAILED", "CL_KERNEL_ARG_INFO_NOT_AVAILABLE"};
  static constexpr const char* from_30_down[] = {
    "CL_INVALID_VALUE", "CL_INVALID_DEVICE_TYPE", "CL_INVALID_PLATFORM", "CL_INVALID_DEVICE", "CL_INVALID_CONTEXT",
    "CL_INVALID_QUEUE_PROPERTIES", "CL_INVALID_COMMAND_QUEUE", "CL_INVALID_HOST_PTR", "CL_INVALID_MEM_OBJECT",
    "CL_INVALID_IMAGE_FORMAT_DESCRIPTOR", "CL_INVALID_IMAGE_SIZE", "CL_INVALID_SAMPLER", "CL_INVALID_BINARY",
    "CL_INVALID_BUILD_OPTIONS", "CL_INVALID_PROGRAM", "CL_INVALID_PROGRAM_EXECUTABLE", "CL_INVALID_KERNEL_NAME",
    "CL_INVALID_KERNEL_DEFINITION", "CL_INVALID_KERNEL", "CL_INVALID_ARG_INDEX", "CL_INVALID_ARG_VALUE",
    "CL_INVALID_ARG_SIZE", "CL_INVALID_KERNEL_ARGS", "CL_INVALID_WORK_DIMENSION", "CL_INVALID_WORK_GROUP_SIZE",
    "CL_INVALID_WORK_ITEM_SIZE", "CL_INVALID_GLOBAL_OFFSET", "CL_INVALID_EVENT_WAIT_LIST", "CL_INVALID_EVENT",
    "CL_INVALID_OPERATION", "CL_INVALID_GL_OBJECT", "CL_INVALID_BUFFER_SIZE", "CL_INVALID_MIP_LEVEL",
    "CL_INVALID_GLOBAL_WORK_SIZE", "CL_INVALID_PROPERTY", "CL_INVALID_IMAGE_DESCRIPTOR", "CL_INVALID_COMPILER_OPTIONS",
    "CL_INVALID_LINKER_OPTIONS", "CL_INVALID_DEVICE_PARTITION_COUNT"};
  // clang-format on
  if(code <= 0 && code > -20)
    return from_0_down[-code];
  if(code <= -30 && code > -69)
    return from_30_down[-code - 30];
  if(code == -1001)
    return "CL_PLATFORM_NOT_FOUND_KHR"; // of the loader, in cl_ext.h
  if(code == -9999)
    return "illegal memory access"; // of NVIDIA's driver, not documented
  return "unknown error code";
}

/// An error of OpenCL. When it is thrown, all memory of the package on the device has been released.
class OpenCL_error : public std::runtime_error {
public:
  /// \param call         what failed: the function of OpenCL or of this package
  /// \param code         the error code of OpenCL
  /// \param explanation  the cause, and what to do
  /// \param build_log    of the compiler, if a build has failed
  OpenCL_error(std::string call, cl_int code, const std::string& explanation = "OpenCL failed",
               std::string build_log = std::string())
    : std::runtime_error(explanation + " (" + call + ": " + opencl_error_name(code) + ", " + std::to_string(code) +
                         ")" + (build_log.empty() ? "" : "\n" + build_log)),
      call_(std::move(call)), code_(code), build_log_(std::move(build_log))
  {}

  /// \return what failed: the function of OpenCL or of this package
  const std::string& call() const { return call_; }
  /// \return the error code of OpenCL
  cl_int code() const { return code_; }
  /// \return its name
  const char* code_name() const { return opencl_error_name(code_); }
  /// \return the messages of the compiler; empty unless a build has failed
  const std::string& build_log() const { return build_log_; }

private:
  std::string call_;
  cl_int code_;
  std::string build_log_;
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_OPENCL_ERROR_H
