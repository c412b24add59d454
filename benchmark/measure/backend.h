// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef BENCHMARK_BACKEND_H
#define BENCHMARK_BACKEND_H

#include "meshes/mesh.h"

#include <CGAL/Spherical_parameterization/values/Result.h>
#include <CGAL/Spherical_parameterization/Any_policy.h>
#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/values/methods.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <array>
#include <limits>
#include <string>
#include <variant>
#include <vector>

namespace benchmark {

using CGAL::Spherical_parameterization::Balanced;
using CGAL::Spherical_parameterization::Result;
using CGAL::Spherical_parameterization::Saddle_point;

/// The two weights of the paper.
enum class Weights { BARYCENTRIC, CLAMPED };
constexpr std::array<Weights, 2> both_weights = {Weights::BARYCENTRIC, Weights::CLAMPED};
inline const char* name(Weights weights) { return weights == Weights::BARYCENTRIC ? "barycentric" : "clamped"; }

/// Calls `f` with the weight map, and returns what it does.
template <class F>
auto visit_weights(Weights weights, const Mesh& mesh, F f)
{
  return weights == Weights::BARYCENTRIC ? f(CGAL::Spherical_parameterization::barycentric_weights(mesh))
                                         : f(CGAL::Spherical_parameterization::clamped_weights(mesh));
}

/// A policy, and on how many cores it may run.
struct Backend {
  std::string name = "sequential"; ///< or "tbb" or "opencl"
  CGAL::Spherical_parameterization::Any_policy policy = CGAL::Sequential_tag();
  int threads = 1; ///< of TBB; for opencl, of its set-up on the host

  std::string label() const
  {
    return name == "tbb" ? name + ", " + std::to_string(threads) + (threads == 1 ? " thread" : " threads") : name;
  }
};

/// Those of the given names. Without names: all that this build has and this machine can run, in the order sequential,
/// tbb, opencl; TBB on all cores. Throws std::runtime_error if one is not available.
std::vector<Backend> backends(const std::vector<std::string>& names);

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

/// One map. A mesh that has none throws std::runtime_error; a map that is not valid is a result like any other.
Result compute_map(const Backend& backend, const Mesh& mesh, Weights weights,
                   const std::variant<Balanced, Saddle_point>& method, Sphere_map sphere,
                   double maximum_running_time = std::numeric_limits<double>::infinity());

/// "valid", or why it is not
std::string verdict(const Result& result);

} // namespace benchmark

#endif // BENCHMARK_BACKEND_H
