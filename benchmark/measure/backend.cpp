// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/backend.h"

#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;

std::vector<Backend> find_backends()
{
  std::vector<Backend> found = {Backend()};
#ifdef CGAL_LINKED_WITH_TBB
  const int threads = tbb::this_task_arena::max_concurrency();
  found.push_back({"tbb", CGAL::Parallel_tag(), threads});
#else
  [[maybe_unused]] const int threads = 1;
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  try {
    // what the device can do is measured, on small meshes, too
    found.push_back({"opencl", SP::opencl_device().set_smallest_mesh(0), threads});
  } catch(const std::exception&) { // no device: the backend is not available
  }
#endif
  return found;
}

} // namespace

std::vector<Backend> backends(const std::vector<std::string>& names)
{
  std::vector<Backend> available = find_backends();
  if(names.empty())
    return available;
  std::vector<Backend> chosen;
  for(const std::string& name : names) {
    const auto found =
      std::find_if(available.begin(), available.end(), [&](const Backend& b) { return b.name == name; });
    if(found == available.end())
      throw std::runtime_error("no backend \"" + name + "\" here: this build or this machine does not have it");
    chosen.push_back(*found);
  }
  return chosen;
}

Result compute_map(const Backend& backend, const Mesh& mesh, Weights weights,
                   const std::variant<Balanced, Saddle_point>& method, Sphere_map sphere, double maximum_running_time)
{
  Result result;
  within(backend, [&] {
    result = visit_weights(weights, mesh, [&](auto weight_map) {
      const auto np = CGAL::parameters::edge_weight_map(weight_map).maximum_running_time(maximum_running_time);
      return std::visit(
        [&](const auto& policy, const auto& m) { return SP::parameterize(policy, mesh, m, sphere, np); },
        backend.policy, method);
    });
  });
  using SP::Error_code;
  if(!result && result.error != Error_code::NOT_CONVERGED && result.error != Error_code::INTERRUPTED &&
     result.error != Error_code::NOT_BIJECTIVE)
    throw std::runtime_error(std::string(get_error_message(result.error)) + ": " + result.detail);
  return result;
}

std::string verdict(const Result& result) { return result ? "valid" : get_error_message(result.error); }

} // namespace benchmark
