// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_POLICY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_POLICY_H

#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_call.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_program.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationPolicies
/// @{

/// What a device says of itself.
struct OpenCL_device_info {
  std::string platform;               ///< whose driver it is
  std::string name;                   ///< of the device
  std::string driver;                 ///< its version
  std::string version;                ///< of OpenCL
  std::size_t memory = 0;             ///< in bytes
  std::size_t largest_allocation = 0; ///< of one array, in bytes
  bool has_fp64 = false;              ///< double precision
  bool is_gpu = false;                ///< a graphics processor
  bool is_cpu = false;                ///< works in the memory of the host
};

namespace internal {

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

} // namespace internal

/// The execution policy that runs the solvers on an OpenCL device. The mesh is read, the multigrid hierarchy is set up,
/// and the result is certified on the host.
///
/// A value: copies stand for the same queue and share the kernels, which are compiled when they are needed first.
/// Most drivers keep compiled kernels on disk, so that only the first program waits for the compiler. Any number of
/// threads may call `parameterize()` with the same device, or with devices on the same queue, at once: results do not
/// depend on it, but the work on one queue is done one after the other.
///
/// In double precision results are those of `CGAL::Sequential_tag` bit by bit, on devices whose division and square
/// root round correctly, as OpenCL demands, and for spring exponent 2 (for the others the `pow()` of the device
/// counts, too). In single precision the residual does not come down to the default accuracy: accuracies below
/// 3e-7 sqrt(n), with n vertices, are taken for that; `Result::device` names the precision. The certificate is exact in
/// either case.
///
/// A mesh with fewer than `smallest_mesh()` vertices is mapped on one core of the host, which is done before a device
/// has been told everything; `Result::device` says so.
///
/// \cgalModels{SphericalParameterizationPolicy}
class OpenCL_device {
public:
  /// In what the device computes.
  enum class Precision {
    AUTOMATIC, ///< double where the device has it
    DOUBLE,    ///< 64 bits, or an `OpenCL_error`
    SINGLE     ///< 32 bits
  };

  /// \param queue      in order, of the device and the context in which to work
  /// \param precision  in what to compute
  /// \throws OpenCL_error if the device cannot do with the precision, or the queue is not in order
  explicit OpenCL_device(cl::CommandQueue queue, Precision precision = Precision::AUTOMATIC)
    : queue_(std::move(queue)), program_(std::make_shared<internal::OpenCL_program>())
  {
    const auto of_queue = [&](cl_uint key, auto value) {
      return internal::opencl_value<decltype(value)>(clGetCommandQueueInfo, "clGetCommandQueueInfo", queue_(), key);
    };
    device_ = of_queue(CL_QUEUE_DEVICE, cl_device_id());
    context_ = of_queue(CL_QUEUE_CONTEXT, cl_context());
    info_ = internal::opencl_device_info(device_);
    is_double_ = precision == Precision::DOUBLE || (precision == Precision::AUTOMATIC && info_.has_fp64);
    if(is_double_ && !info_.has_fp64)
      throw OpenCL_error("OpenCL_device", CL_INVALID_DEVICE, info_.name + " has single precision only");
    if(of_queue(CL_QUEUE_PROPERTIES, cl_command_queue_properties()) & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE)
      throw OpenCL_error("OpenCL_device", CL_INVALID_QUEUE_PROPERTIES, "the queue has to be in order");
  }

  /// \return the queue that all work goes to
  const cl::CommandQueue& queue() const { return queue_; }
  /// \return what the device says of itself
  const OpenCL_device_info& info() const { return info_; }
  /// \return whether it computes with 64 bits
  bool is_double_precision() const { return is_double_; }

  /// \return the least number of vertices that the device gets
  ///
  /// With PoCL a CPU as a device draws level with one core at 40,000; the default is lower for the sake of GPUs.
  std::size_t smallest_mesh() const { return smallest_mesh_; }
  /// Sends smaller meshes to the host.
  /// \param number_of_vertices  the least that the device gets; 0 for all meshes
  /// \return this device
  OpenCL_device& set_smallest_mesh(std::size_t number_of_vertices)
  {
    smallest_mesh_ = number_of_vertices;
    return *this;
  }

  /// \cond SKIP_IN_MANUAL
  cl_context context() const { return context_; } // kept alive by the queue
  cl_device_id device() const { return device_; }
  cl::Program program() const { return program_->get(context_, device_, is_double_, info_.is_cpu); }
  /// So that what is done on GPUs can be tested without one.
  void treat_as_gpu()
  {
    info_.is_cpu = false;
    program_ = std::make_shared<internal::OpenCL_program>();
  }
  /// \endcond

private:
  cl::CommandQueue queue_;
  cl_device_id device_;
  cl_context context_;
  OpenCL_device_info info_;
  bool is_double_;
  std::size_t smallest_mesh_ = 10000;
  std::shared_ptr<internal::OpenCL_program> program_;
};

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BACKEND_OPENCL_OPENCL_POLICY_H
