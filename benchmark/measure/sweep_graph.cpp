// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/sweep_graph.h"

#include "measure/measure.h"

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/driver/read_springs.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace benchmark {
namespace {

namespace internal = CGAL::Spherical_parameterization::internal;
using internal::Host_array;
using internal::vec3;

/// The graph on a device, with the vectors that a sweep works on.
template <class Device>
struct Sweeper {
  Device device;
  Sweep sweep;
  typename Device::Matrix matrix;
  typename Device::Vectors v, u, w, last = device.vectors(1);

  template <class ExecutionPolicy>
  Sweeper(const ExecutionPolicy& policy, const internal::Weighted_graph& graph, const Host_array<vec3>& start, Sweep s)
    : device(policy), sweep(s), matrix(device.upload(std::make_shared<const internal::Weighted_graph>(graph))),
      v(device.upload(start)), u(device.upload(start)), w(device.vectors(static_cast<int>(start.size())))
  {}

  void operator()(int count)
  {
    for(int k = 0; k < count; ++k)
      switch(sweep) {
      case Sweep::LAPLACIAN: device.multiply(matrix, u, w); break;
      case Sweep::JACOBI:
        device.jacobi_sweep(matrix, 0.95, v, u, w);
        std::swap(u, w);
        break;
      case Sweep::COPY: device.copy(u, w); break;
      }
    device.dot(last, last); // its result is there when all sweeps are done, also where they only have been enqueued
  }
};

} // namespace

Sweep_graph::Sweep_graph(const Mesh& mesh, Weights weights)
{
  const internal::Host_loop one_core;
  internal::Monitor no_limit(std::numeric_limits<double>::infinity(), nullptr, false);
  const internal::Watched_loop watched(one_core, no_limit);
  internal::Vertices<Mesh> vertex;
  const internal::Surface source =
    internal::read_surface(mesh, mesh.points(), internal::Reading::BREADTH_FIRST, one_core, vertex);
  visit_weights(weights, mesh,
                [&](auto map) { graph = internal::read_springs(mesh, source, vertex, map, watched).graph; });
  graph.update_diagonal({});
  for(const vec3& p : source.point)
    point.emplace_back(p.x, p.y, p.z);
  face.assign(source.face.begin(), source.face.end());
  position.assign(source.position.begin(), source.position.end());
}

Sweep_graph Sweep_graph::renumbered(const std::vector<int>& order) const
{
  std::vector<int> number(order.size());
  for(std::size_t k = 0; k < order.size(); ++k)
    number[order[k]] = static_cast<int>(k);

  Sweep_graph result;
  std::vector<std::pair<int, double>> row;
  for(int i : order) {
    row.clear();
    for(int k = graph.offset[i]; k < graph.offset[i + 1]; ++k)
      row.emplace_back(number[graph.target[k]], graph.weight[k]);
    std::sort(row.begin(), row.end());
    for(const auto& [j, weight] : row) {
      result.graph.target.push_back(j);
      result.graph.weight.push_back(weight);
    }
    result.graph.offset.push_back(static_cast<int>(result.graph.target.size()));
    result.point.push_back(point[i]);
    result.position.push_back(position[i]);
  }
  for(const std::array<int, 3>& f : face)
    result.face.push_back({number[f[0]], number[f[1]], number[f[2]]});
  result.graph.update_diagonal({});
  return result;
}

double Sweep_graph::bytes_of_jacobi_sweep() const
{
  return sizeof(int) * (size() + 1.) + (sizeof(int) + sizeof(double)) * double(graph.target.size()) +
         (sizeof(double) + 3. * sizeof(vec3)) * size(); // inverse diagonal, v, u and w
}

double Sweep_graph::residual(Sphere_map sphere) const
{
  Host_array<vec3> v;
  for(int i : position) {
    const Point_3& p = sphere[Mesh::Vertex_index(i)];
    v.push_back({p.x(), p.y(), p.z()});
  }
  const CGAL::Sequential_tag one_core;
  return std::sqrt(internal::Backend<CGAL::Sequential_tag>(one_core).barycentric_residual2(
    std::make_shared<const internal::Weighted_graph>(graph), v));
}

std::function<void(int)> Sweep_graph::sweeps(const Backend& backend, Sweep sweep) const
{
  Host_array<vec3> start;
  for(const Point_3& p : point) { // the bounding box starts at the origin: nothing here is 0 but the origin itself
    const vec3 v = {p.x(), p.y(), p.z()};
    start.push_back(internal::inner(v, v) > 0 ? internal::unit(v) : vec3{0, 0, 1});
  }
  if(sweep == Sweep::COPY)
    start.resize(static_cast<std::size_t>(bytes_of_jacobi_sweep() / (2 * sizeof(vec3))));
  return std::visit(
    [&](const auto& policy) -> std::function<void(int)> {
      typedef Sweeper<internal::Backend<std::decay_t<decltype(policy)>>> Sweeper_on_device;
      std::shared_ptr<Sweeper_on_device> sweeper;
      within(backend, [&] { sweeper = std::make_shared<Sweeper_on_device>(policy, graph, start, sweep); });
      return [backend, sweeper](int count) { within(backend, [&] { (*sweeper)(count); }); };
    },
    backend.policy);
}

std::vector<double> seconds_per_sweep(const std::vector<std::function<void(int)>>& sweeps)
{
  constexpr int rounds = 11;
  constexpr double shortest_batch = 0.01;
  const auto seconds = [](const std::function<void(int)>& sweep, int count) {
    const Stopwatch watch;
    sweep(count);
    return watch.seconds();
  };
  std::vector<std::pair<std::function<void(int)>, int>> batches;
  for(const auto& sweep : sweeps) {
    int count = 1;
    while(seconds(sweep, count) < shortest_batch)
      count *= 2;
    batches.emplace_back(sweep, count);
  }
  return interleaved_medians(
    rounds, batches, [&](const auto& batch) { return seconds(batch.first, batch.second) / batch.second; },
    [](double s) { return s; });
}

} // namespace benchmark
