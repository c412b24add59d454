// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/map_settings.h"

#include "options/mapping_options.h"

#include <stdexcept>

namespace tool {

namespace SP = CGAL::Spherical_parameterization;

Map_settings map_settings(const Mapping_options& options)
{
  Map_settings settings;
  if(options.weights == "mean-value")
    settings.weights = Mean_value_weights();
  else if(options.weights == "conformal") {
    Conformal_weights weights;
    weights.min_degrees = options.min_angle.value_or(weights.min_degrees);
    weights.max_degrees = options.max_angle.value_or(weights.max_degrees);
    settings.weights = weights;
  }

  if(options.method == "balanced") {
    SP::Balanced method;
    method.spring_exponent = options.spring_exponent.value_or(method.spring_exponent);
    settings.method = method;
  } else if(options.method == "isometric") {
    SP::Isometric method;
    method.area_exponent = options.area_exponent.value_or(method.area_exponent);
    settings.method = method;
  } else if(options.method == "automatic") {
    SP::Automatic method;
    method.spring_exponent = options.spring_exponent.value_or(method.spring_exponent);
    method.area_exponent = options.area_exponent.value_or(method.area_exponent);
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
  if(options.iterations)
    settings.iterations = static_cast<std::size_t>(*options.iterations);
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
    return SP::opencl_device(SP::find_opencl_device(options.device), precision);
  }
#endif
  throw std::invalid_argument("unknown policy '" + options.policy + "'");
}

} // namespace tool
