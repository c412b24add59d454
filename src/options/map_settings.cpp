// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/map_settings.h"

#include "options/mapping_options.h"

#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

namespace tool {

Map_settings map_settings(const Mapping_options& options)
{
  Map_settings settings;
  if(options.weights == "barycentric")
    settings.weights = Barycentric_weights();
  if(options.weights == "mean-value")
    settings.weights = Mean_value_weights();
  if(options.weights == "clamped") {
    const Clamped_weights standard;
    settings.weights = Clamped_weights{options.min_angle.value_or(standard.min_degrees),
                                       options.max_angle.value_or(standard.max_degrees)};
  }

  const double spring_exponent = options.spring_exponent.value_or(SP::Balanced().spring_exponent);
  if(options.method == "balanced")
    settings.method = SP::Balanced{spring_exponent};
  else if(options.method == "isometric")
    settings.method =
      SP::Isometric{options.area_exponent, options.landmark_weight.value_or(SP::Isometric().landmark_weight)};
  else if(options.method == "automatic") {
    SP::Automatic method;
    method.spring_exponent = spring_exponent;
    method.area_exponent = options.area_exponent;
    method.largest_shrinkage = options.largest_shrinkage.value_or(method.largest_shrinkage);
    settings.method = method;
  } else {
    SP::Saddle_point method;
    if(options.splitting == "gauss-seidel")
      method.splitting = SP::Saddle_point::Splitting::GAUSS_SEIDEL;
    if(options.start == "harmonic")
      method.start = SP::Saddle_point::Start::HARMONIC;
    method.relaxation = options.relaxation.value_or(method.relaxation);
    if(options.check_interval)
      method.check_interval = static_cast<std::size_t>(*options.check_interval);
    settings.method = method;
  }

  settings.accuracy = options.accuracy;
  settings.iterations = options.iterations;
  settings.max_time = options.max_time;
  return settings;
}

SP::Any_policy make_policy(const Mapping_options& options)
{
  if(options.policy == "sequential")
    return CGAL::Sequential_tag();
#ifdef CGAL_LINKED_WITH_TBB
  if(options.policy == "tbb")
    return CGAL::Parallel_tag();
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  if(options.policy == "opencl") {
    using Precision = SP::OpenCL_device::Precision;
    const Precision precision = options.precision == "double"   ? Precision::DOUBLE
                                : options.precision == "single" ? Precision::SINGLE
                                                                : Precision::AUTOMATIC;
    // One for all meshes, whose kernels are compiled once. Never deleted: drivers crash after main().
    static std::mutex mutex;
    static auto& devices = *new std::map<std::pair<std::string, Precision>, SP::OpenCL_device>;
    const std::lock_guard<std::mutex> lock(mutex);
    const std::pair key(options.device, precision);
    auto device = devices.find(key);
    if(device == devices.end())
      device = devices.emplace(key, SP::opencl_device(SP::find_opencl_device(options.device), precision)).first;
    return device->second;
  }
#endif
  throw std::invalid_argument("unknown policy '" + options.policy + "'");
}

} // namespace tool
