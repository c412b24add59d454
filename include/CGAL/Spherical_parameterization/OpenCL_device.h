// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_OPENCL_DEVICE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_OPENCL_DEVICE_H

// The execution policy for OpenCL devices (version 1.2 or later). Include it, and link with OpenCL, to have it:
//
//   const OpenCL_device device = opencl_device();
//   const Result result = parameterize(device, mesh, Balanced(), sphere_map);

#include <CGAL/Spherical_parameterization/values/OpenCL_device_info.h>
#include <CGAL/Spherical_parameterization/values/OpenCL_error.h>
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_backend.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_queue.h>

#include <CGAL/tags.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <mutex>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationPolicies
/// @{

/// The execution policy that runs the solvers on an OpenCL device. The host reads the mesh, sets up the multigrid
/// hierarchy, and certifies the result.
///
/// A value type: copies use the same queue and share the kernels. Kernels are compiled when they are first needed. Most
/// drivers keep compiled kernels on disk, so that only the first program waits for the compiler.
///
/// Several threads may call `opencl_device()` at the same time, and `parameterize()` with the same device, or with
/// devices on the same queue. The results are the same; the work on one queue is done sequentially.
///
/// In double precision the results are the same, bit by bit, as with `CGAL::Sequential_tag`, on devices whose division
/// and square root round correctly, as OpenCL demands, and that keep denormal floats, which it does not. In single
/// precision the residual cannot reach the default accuracy: accuracies below 3e-7 sqrt(n), with n vertices, are raised
/// to that; `Result::device` names the precision. The certificate is exact in either case.
///
/// A mesh with fewer than `smallest_mesh()` vertices is mapped on one core of the host, which is faster;
/// `Result::device` says so.
///
/// \cgalModels{SphericalParameterizationPolicy}
class OpenCL_device {
public:
  /// The precision of the computation.
  enum class Precision {
    AUTOMATIC, ///< double if the device supports it
    DOUBLE,    ///< 64 bits, or an `OpenCL_error`
    SINGLE     ///< 32 bits
  };

  /// \param queue      an in-order queue of the device and the context to use
  /// \param precision  in what to compute
  /// \throws OpenCL_error if the device does not have the precision, or the queue is not in order
  explicit OpenCL_device(cl::CommandQueue queue, Precision precision = Precision::AUTOMATIC)
    : queue_(std::move(queue), precision != Precision::SINGLE)
  {
    if(precision == Precision::DOUBLE && !is_double_precision())
      throw OpenCL_error("OpenCL_device", CL_INVALID_DEVICE, info().name + " has single precision only");
  }

  /// \return the queue of all work
  const cl::CommandQueue& queue() const { return queue_.queue(); }
  /// \return what the device says of itself
  const OpenCL_device_info& info() const { return queue_.info(); }
  /// \return whether it computes with 64 bits
  bool is_double_precision() const { return queue_.is_double_precision(); }

  /// \return the smallest number of vertices for which the device is used
  ///
  /// The default is 10,000, which is meant for GPUs. A CPU as a device (PoCL) is as fast as one core at 40,000
  /// vertices.
  std::size_t smallest_mesh() const { return smallest_mesh_; }
  /// Sends smaller meshes to the host.
  /// \param number_of_vertices  the smallest number for which the device is used; 0 for all meshes
  /// \return this device
  OpenCL_device& set_smallest_mesh(std::size_t number_of_vertices)
  {
    smallest_mesh_ = number_of_vertices;
    return *this;
  }

  /// \cond SKIP_IN_MANUAL
  /// What the backend works with.
  operator const internal::OpenCL_queue&() const { return queue_; }
  void treat_as_gpu() { queue_.treat_as_gpu(); }
  /// \endcond

private:
  internal::OpenCL_queue queue_;
  std::size_t smallest_mesh_ = 10000;
};

/// Every device of every platform, in an order that only depends on the drivers. Empty if there is no driver.
/// \return what each of them says of itself
inline std::vector<OpenCL_device_info> opencl_devices()
{
  std::vector<OpenCL_device_info> result;
  for(cl_device_id device : internal::opencl_device_ids())
    result.push_back(internal::opencl_device_info(device));
  return result;
}

/// Device `k` of `opencl_devices()`, with its own context and queue.
/// \param k          its index there, from 0
/// \param precision  in what to compute
/// \return the policy
/// \throws OpenCL_error if there is no such device, or if it does not have the precision
inline OpenCL_device opencl_device(std::size_t k,
                                   OpenCL_device::Precision precision = OpenCL_device::Precision::AUTOMATIC)
{
  const std::vector<cl_device_id> ids = internal::opencl_device_ids();
  if(k >= ids.size())
    throw OpenCL_error("opencl_device", CL_DEVICE_NOT_FOUND,
                       "no OpenCL device " + std::to_string(k) + " among " + std::to_string(ids.size()));
  const std::lock_guard<std::mutex> lock(internal::opencl_start());
  cl_int code = CL_SUCCESS;
  const cl::Context context(clCreateContext(nullptr, 1, &ids[k], nullptr, nullptr, &code));
  internal::check_opencl(code, "clCreateContext");
  const cl::CommandQueue queue(clCreateCommandQueue(context(), ids[k], 0, &code));
  internal::check_opencl(code, "clCreateCommandQueue");
  return OpenCL_device(queue, precision);
}

/// The device that a user has chosen. If `wanted` is empty, it is the device that the environment variable
/// `CGAL_SPHERICAL_PARAMETERIZATION_DEVICE` names; if that is empty, too, the first GPU with double precision, or else
/// the first device.
/// \param wanted  its index, or a part of its name, case-insensitive; or empty
/// \return its index in `opencl_devices()`
/// \throws OpenCL_error if there is no such device
inline std::size_t find_opencl_device(std::string wanted = std::string())
{
  const std::string variable = "CGAL_SPHERICAL_PARAMETERIZATION_DEVICE";
  std::string asked;
  if(const char* value = std::getenv(variable.c_str()); value && wanted.empty()) {
    wanted = value;
    asked = ", as " + variable + " asks for";
  }
  const auto fail = [](const std::string& explanation) {
    throw OpenCL_error("find_opencl_device", CL_DEVICE_NOT_FOUND, explanation);
  };

  const std::vector<OpenCL_device_info> devices = opencl_devices();
  const auto number_of = [&](auto is_wanted) {
    return static_cast<std::size_t>(std::find_if(devices.begin(), devices.end(), is_wanted) - devices.begin());
  };
  if(devices.empty() && !internal::opencl_platform_ids().empty())
    fail("no OpenCL device: no driver that is installed has one (PoCL needs a folder to write to: HOME or "
         "POCL_CACHE_DIR)");
  if(devices.empty())
    fail("no OpenCL device: install a driver (for the CPU, the Debian package pocl-opencl-icd)");
  if(wanted.empty()) {
    const std::size_t gpu = number_of([](const OpenCL_device_info& d) { return d.is_gpu && d.has_fp64; });
    return gpu < devices.size() ? gpu : 0;
  }
  constexpr std::size_t most_digits = 9; // no number of a device is longer
  if(wanted.size() <= most_digits && wanted.find_first_not_of("0123456789") == std::string::npos) {
    const std::size_t k = std::stoul(wanted);
    if(k >= devices.size())
      fail("no OpenCL device " + wanted + asked + ": the last one is " + std::to_string(devices.size() - 1));
    return k;
  }
  const auto lower = [](std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
  };
  const std::size_t named =
    number_of([&](const OpenCL_device_info& d) { return lower(d.name).find(lower(wanted)) != std::string::npos; });
  if(named == devices.size()) {
    std::string names;
    for(const OpenCL_device_info& d : devices)
      names += (names.empty() ? "" : ", ") + d.name;
    fail("no OpenCL device is called '" + wanted + "'" + asked + "; there is " + names);
  }
  return named;
}

/// The device of `find_opencl_device()`: the one of the environment variable, or the default.
/// \param precision  in what to compute
/// \return the policy
/// \throws OpenCL_error if there is no such device, or if it does not have the precision
inline OpenCL_device opencl_device(OpenCL_device::Precision precision = OpenCL_device::Precision::AUTOMATIC)
{
  return opencl_device(find_opencl_device(), precision);
}

/// @}

namespace internal {

/// The backend of an OpenCL device. Set-up on the host is run with `Loop`.
template <class Loop>
struct Backend_for<OpenCL_device, Loop> {
  using type = OpenCL_backend<Loop>;
};

template <>
struct Is_policy<OpenCL_device> : std::true_type {};

/// Small meshes stay on one core of the host.
template <class Loop>
struct Choice_of_backend<OpenCL_device, Loop> {
  template <class F>
  static auto call(const OpenCL_device& device, int n, F f)
  {
    const std::size_t smallest = device.smallest_mesh();
    if(static_cast<std::size_t>(n) >= smallest) {
      const OpenCL_backend<Loop> backend(device);
      return f(backend, backend.device_name());
    } else {
      const Host_backend<Loop> backend{CGAL::Sequential_tag()};
      return f(backend, backend.device_name() + " (the mesh has fewer than " + std::to_string(smallest) + " vertices)");
    }
  }
};

} // namespace internal
} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_OPENCL_DEVICE_H
