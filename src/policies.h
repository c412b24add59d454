// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_POLICIES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_POLICIES_H

#include <CGAL/tags.h>

#include <string>
#include <variant>
#include <vector>

namespace tool {

/// Every execution policy of this build. `map_to_sphere()` visits it: a new policy is added here and in
/// `available_policies()`, and nowhere else.
using Policy = std::variant<CGAL::Sequential_tag>;

struct Named_policy {
  std::string name;
  std::string description;
  Policy policy;
};

const std::vector<Named_policy>& available_policies();

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_POLICIES_H
