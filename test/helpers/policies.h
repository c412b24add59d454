// SPDX-License-Identifier: GPL-3.0-or-later
// The execution policies of this build.

#ifndef TEST_HELPERS_POLICIES_H
#define TEST_HELPERS_POLICIES_H

#include <CGAL/Spherical_parameterization/Any_policy.h>

#include <iostream>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>

namespace test {

using Policy = CGAL::Spherical_parameterization::Any_policy;

/// All but the first. A build that has no more tests the first: what is tested of the others holds for it, too.
template <class First, class... Others>
std::tuple<Others...> without_first(std::variant<First, Others...>);
template <class First>
std::tuple<First> without_first(std::variant<First>);
using Parallel_policies = decltype(without_first(std::declval<Policy>()));

/// Says that the test is skipped if the machine has nothing for the policy to run on.
template <class P>
std::optional<P> some_policy()
{
  return P();
}

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
/// The device of the user's choice, in double precision, for small meshes, too.
template <>
inline std::optional<CGAL::Spherical_parameterization::OpenCL_device> some_policy()
{
  using CGAL::Spherical_parameterization::OpenCL_device;
  for(const auto& device : CGAL::Spherical_parameterization::opencl_devices())
    if(device.has_fp64)
      return CGAL::Spherical_parameterization::opencl_device(OpenCL_device::Precision::DOUBLE).set_smallest_mesh(0);
  std::cout << "SKIPPED: there is no OpenCL device with double precision; for the CPU, install the Debian package "
               "pocl-opencl-icd"
            << std::endl;
  return {};
}
#endif

/// Has the policy do what it does on a GPU, and returns `true`, if it is one that could be there.
template <class P>
bool treat_as_gpu(P&)
{
  return false;
}
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
inline bool treat_as_gpu(CGAL::Spherical_parameterization::OpenCL_device& device)
{
  device.treat_as_gpu();
  return true;
}
#endif

/// What `Settings` start with: sequential unless the test program was started with `--policy`.
const Policy& default_policy();
const std::string& default_policy_name();

/// By its name in the command-line tool. Says that all tests are skipped, and returns `false`, if the machine has
/// nothing for it to run on. Throws `std::invalid_argument` if this build does not have it.
bool set_default_policy(const std::string& name);

} // namespace test

#endif // TEST_HELPERS_POLICIES_H
