// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_OPENCL_DEVICE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_OPENCL_DEVICE_H

// The execution policy for OpenCL devices (version 1.2 or later). Include it, and link with OpenCL, to have it:
//
//   const OpenCL_device device = opencl_device();
//   const Result result = parameterize(device, mesh, Balanced(), sphere_map);

#include <CGAL/Spherical_parameterization/OpenCL_error.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_backend.h>
#include <CGAL/Spherical_parameterization/internal/backend/opencl/OpenCL_policy.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <cstdlib>
#include <string>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationPolicies
/// @{

/// Every device of every platform, in an order that stays while no driver comes or goes. No driver: no device.
/// \return what each of them says of itself
inline std::vector<OpenCL_device_info> opencl_devices()
{
  std::vector<OpenCL_device_info> result;
  for(cl_device_id device : internal::opencl_device_ids())
    result.push_back(internal::opencl_device_info(device));
  return result;
}

/// Device `k` of `opencl_devices()`, with a context and a queue of its own.
/// \param k          its number there, from 0
/// \param precision  in what to compute
/// \return the policy
/// \throws OpenCL_error if there is no such device, or if it cannot do with the precision
inline OpenCL_device opencl_device(std::size_t k,
                                   OpenCL_device::Precision precision = OpenCL_device::Precision::AUTOMATIC)
{
  const std::vector<cl_device_id> ids = internal::opencl_device_ids();
  if(k >= ids.size())
    throw OpenCL_error("opencl_device", CL_DEVICE_NOT_FOUND,
                       "no OpenCL device " + std::to_string(k) + " among " + std::to_string(ids.size()));
  cl_int code = CL_SUCCESS;
  const cl::Context context(clCreateContext(nullptr, 1, &ids[k], nullptr, nullptr, &code));
  internal::check_opencl(code, "clCreateContext");
  const cl::CommandQueue queue(clCreateCommandQueue(context(), ids[k], 0, &code));
  internal::check_opencl(code, "clCreateCommandQueue");
  return OpenCL_device(queue, precision);
}

/// The device a user has asked for. Where `wanted` is empty, what the environment variable
/// `CGAL_SPHERICAL_PARAMETERIZATION_DEVICE` says counts; where that is empty, too, the first GPU with double precision;
/// without one, the first device.
/// \param wanted  its number, or a part of its name, in which capitals do not matter; or empty
/// \return its number in `opencl_devices()`
/// \throws OpenCL_error if there is no such device
inline std::size_t find_opencl_device(std::string wanted = std::string())
{
  const char* const variable = "CGAL_SPHERICAL_PARAMETERIZATION_DEVICE";
  const char* const value = std::getenv(variable);
  const bool is_from_variable = wanted.empty() && value;
  if(is_from_variable)
    wanted = value;
  const std::string asked = is_from_variable ? std::string(", as ") + variable + " asks for" : "";
  const auto fail = [](const std::string& explanation) {
    throw OpenCL_error("find_opencl_device", CL_DEVICE_NOT_FOUND, explanation);
  };

  const std::vector<OpenCL_device_info> devices = opencl_devices();
  const auto number_of = [&](auto is_wanted) {
    return static_cast<std::size_t>(std::find_if(devices.begin(), devices.end(), is_wanted) - devices.begin());
  };
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

/// The device that `find_opencl_device()` finds without being told more.
/// \param precision  in what to compute
/// \return the policy
/// \throws OpenCL_error if there is no such device, or if it cannot do with the precision
inline OpenCL_device opencl_device(OpenCL_device::Precision precision = OpenCL_device::Precision::AUTOMATIC)
{
  return opencl_device(find_opencl_device(), precision);
}

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_OPENCL_DEVICE_H
