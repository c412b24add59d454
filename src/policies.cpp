// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "policies.h"

namespace tool {

const std::vector<Named_policy>& available_policies()
{
  static const std::vector<Named_policy> policies = {{"sequential", "one core", CGAL::Sequential_tag()}};
  return policies;
}

} // namespace tool
