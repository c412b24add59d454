// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_POLICIES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_POLICIES_H

#include <CGAL/Spherical_parameterization/Any_policy.h>

#include <string>
#include <vector>

namespace tool {

/// Every execution policy of this build.
using Policy = CGAL::Spherical_parameterization::Any_policy;

/// "sequential", "tbb", "opencl": those of this build.
const std::vector<std::string>& policy_names();

/// The fastest one that every machine can run: results do not depend on it.
const std::string& default_policy_name();

/// What an OpenCL device has to be.
struct Device_request {
  std::string device;    ///< number or part of the name; empty: the default one
  std::string precision; ///< "double", "single", or empty: double where the device has it
};

/// Looks for the device only if it is for the policy, since drivers take their time to start.
/// Throws an `OpenCL_error` if there is no such device.
Policy make_policy(const std::string& name, const Device_request& request);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_POLICIES_H
