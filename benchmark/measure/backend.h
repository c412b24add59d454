// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_BACKEND_H
#define BENCHMARK_BACKEND_H

#include "meshes/mesh.h"

#include <CGAL/Spherical_parameterization/Result.h>
#include <CGAL/Spherical_parameterization/Any_policy.h>
#include <CGAL/Spherical_parameterization/methods.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <functional>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace benchmark {

using CGAL::Spherical_parameterization::Balanced;
using CGAL::Spherical_parameterization::Result;
using CGAL::Spherical_parameterization::Saddle_point;

/// Every execution policy of this build.
using Policy = CGAL::Spherical_parameterization::Any_policy;

/// A policy, and on how many cores it may run.
struct Backend {
  std::string name; ///< "sequential", "tbb" or "opencl"
  Policy policy;
  int threads = 1; ///< of TBB; for opencl, of its set-up on the host

  std::string label() const
  {
    return name == "tbb" ? name + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads") : name;
  }
};

/// All backends that this build has and this machine can run, in the order sequential, tbb, opencl; TBB on all cores.
const std::vector<Backend>& available_backends();

/// Those of the given names, or all if there are none. Throws std::runtime_error if one is not available.
std::vector<Backend> backends_by_name(const std::vector<std::string>& names);

/// Calls `f` where TBB uses the backend's number of threads.
template <class F>
void within(const Backend& backend, F f)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::task_arena(backend.threads).execute(f);
#else
  CGAL_USE(backend);
  f();
#endif
}

using Method = std::variant<Balanced, Saddle_point>;

/// One map. A mesh that has none throws std::runtime_error; a map that is not valid is a result like any other.
Result compute_map(const Backend& backend, const Mesh& mesh, Weights weights, const Method& method, Sphere_map sphere,
                   double maximum_running_time = std::numeric_limits<double>::infinity());

/// Computes every map so many times, in turn; returns for each the result whose total time is the median.
std::vector<Result> median_maps(int repetitions, const std::vector<std::function<Result()>>& maps);

/// "valid", or why it is not
std::string verdict(const Result& result);

} // namespace benchmark

#endif // BENCHMARK_BACKEND_H
