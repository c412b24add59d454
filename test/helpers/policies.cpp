// SPDX-License-Identifier: GPL-3.0-or-later

#include "policies.h"

#include <stdexcept>

namespace test {
namespace {

Policy policy = CGAL::Sequential_tag();

template <class P>
bool set()
{
  const std::optional<P> chosen = some_policy<P>();
  if(chosen)
    policy = *chosen;
  return chosen.has_value();
}

} // namespace

const Policy& default_policy() { return policy; }

bool set_default_policy(const std::string& name)
{
  if(name == "sequential")
    return set<CGAL::Sequential_tag>();
#ifdef CGAL_LINKED_WITH_TBB
  if(name == "tbb")
    return set<CGAL::Parallel_tag>();
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  if(name == "opencl")
    return set<CGAL::Spherical_parameterization::OpenCL_device>();
#endif
  throw std::invalid_argument("this build has no policy '" + name + "'");
}

} // namespace test
