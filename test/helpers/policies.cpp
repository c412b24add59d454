// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/policies.h"

#include <stdexcept>

namespace test {
namespace {

Policy policy = CGAL::Sequential_tag();
std::string policy_name = "sequential";

template <class P>
bool set(const std::string& name)
{
  const std::optional<P> chosen = some_policy<P>();
  if(chosen) {
    policy = *chosen;
    policy_name = name;
  }
  return chosen.has_value();
}

} // namespace

const Policy& default_policy() { return policy; }
const std::string& default_policy_name() { return policy_name; }

bool set_default_policy(const std::string& name)
{
  if(name == "sequential")
    return set<CGAL::Sequential_tag>(name);
#ifdef CGAL_LINKED_WITH_TBB
  if(name == "tbb")
    return set<CGAL::Parallel_tag>(name);
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  if(name == "opencl")
    return set<CGAL::Spherical_parameterization::OpenCL_device>(name);
#endif
  throw std::invalid_argument("this build has no policy '" + name + "'");
}

} // namespace test
