// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/policies.h"

#include <stdexcept>

namespace tool {

const std::vector<std::string>& policy_names()
{
  static const std::vector<std::string> names = {
    "sequential",
#ifdef CGAL_LINKED_WITH_TBB
    "tbb",
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
    "opencl",
#endif
  };
  return names;
}

const std::string& default_policy_name()
{
#ifdef CGAL_LINKED_WITH_TBB
  static const std::string name = "tbb";
#else
  static const std::string name = "sequential";
#endif
  return name;
}

Policy make_policy(const std::string& name, [[maybe_unused]] const Device_request& request)
{
  if(name == "sequential")
    return CGAL::Sequential_tag();
#ifdef CGAL_LINKED_WITH_TBB
  if(name == "tbb")
    return CGAL::Parallel_tag();
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  if(name == "opencl") {
    using Precision = CGAL::Spherical_parameterization::OpenCL_device::Precision;
    const Precision precision = request.precision == "double"   ? Precision::DOUBLE
                                : request.precision == "single" ? Precision::SINGLE
                                                                : Precision::AUTOMATIC;
    using CGAL::Spherical_parameterization::find_opencl_device;
    return CGAL::Spherical_parameterization::opencl_device(find_opencl_device(request.device), precision);
  }
#endif
  throw std::invalid_argument("unknown policy '" + name + "'");
}

} // namespace tool
