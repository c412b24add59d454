// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/backend.h"

#include "measure/timing.h"

#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace benchmark {
namespace {

namespace SP = CGAL::Spherical_parameterization;

std::vector<Backend> find_backends()
{
  std::vector<Backend> found = {{"sequential", CGAL::Sequential_tag()}};
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

/// Whether there was a mesh to map at all.
bool has_map(SP::Error_code code)
{
  return code == SP::Error_code::OK || code == SP::Error_code::NOT_CONVERGED || code == SP::Error_code::INTERRUPTED ||
         code == SP::Error_code::NOT_BIJECTIVE;
}

} // namespace

const std::vector<Backend>& available_backends()
{
  static const std::vector<Backend> backends = find_backends();
  return backends;
}

std::vector<Backend> backends_by_name(const std::vector<std::string>& names)
{
  const std::vector<Backend>& available = available_backends();
  if(names.empty())
    return available;
  std::vector<Backend> chosen;
  for(const std::string& name : names) {
    const auto found =
      std::find_if(available.begin(), available.end(), [&](const Backend& b) { return b.name == name; });
    if(found == available.end()) {
      std::string all;
      for(const Backend& b : available)
        all += (all.empty() ? "" : ", ") + b.name;
      throw std::runtime_error("no backend \"" + name + "\" here; there is " + all);
    }
    chosen.push_back(*found);
  }
  return chosen;
}

Result compute_map(const Backend& backend, const Mesh& mesh, Weights weights, const Method& method, Sphere_map sphere,
                   double maximum_running_time)
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
  if(!has_map(result.error))
    throw std::runtime_error(std::string(get_error_message(result.error)) + ": " + result.detail);
  return result;
}

std::vector<Result> median_maps(int repetitions, const std::vector<std::function<Result()>>& maps)
{
  return interleaved_medians(repetitions, maps,
                             [](const Result& a, const Result& b) { return a.seconds.total < b.seconds.total; });
}

std::string verdict(const Result& result) { return result ? "valid" : get_error_message(result.error); }

} // namespace benchmark
