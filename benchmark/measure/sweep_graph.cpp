// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "measure/sweep_graph.h"

#include "measure/timing.h"

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/spherical_parameterization.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace benchmark {
namespace {

namespace internal = CGAL::Spherical_parameterization::internal;
using internal::Host_array;
using internal::vec3;

/// The graph on a device, with the vectors that a sweep works on.
template <class ExecutionPolicy>
class Sweeper {
  typedef internal::Backend<ExecutionPolicy> Device;
  typedef typename Device::Vectors Vectors;

public:
  Sweeper(const ExecutionPolicy& policy, const internal::Weighted_graph& graph, const Host_array<vec3>& start,
          Sweep sweep, int size_of_copy)
    : device_(policy), sweep_(sweep), matrix_(device_.upload(std::make_shared<const internal::Weighted_graph>(graph))),
      v_(device_.upload(start)), u_(sweep == Sweep::COPY ? device_.vectors(size_of_copy) : device_.upload(start)),
      w_(device_.vectors(sweep == Sweep::COPY ? size_of_copy : graph.size())), last_(device_.vectors(1))
  {}

  void operator()(int count)
  {
    for(int k = 0; k < count; ++k)
      switch(sweep_) {
      case Sweep::LAPLACIAN: device_.multiply(matrix_, u_, w_); break;
      case Sweep::JACOBI:
        device_.jacobi_sweep(matrix_, 0.95, v_, u_, w_);
        std::swap(u_, w_);
        break;
      case Sweep::COPY: device_.copy(u_, w_); break;
      }
    device_.dot(last_, last_); // its result is there when all sweeps are done, also where they only have been enqueued
  }

private:
  Device device_;
  Sweep sweep_;
  typename Device::Matrix matrix_;
  Vectors v_, u_, w_, last_;
};

} // namespace

Sweep_graph::Sweep_graph(const Mesh& mesh, Weights weights)
{
  internal::Source_mesh<Mesh> source(mesh, mesh.points());
  visit_weights(weights, mesh, [&](auto map) { source.set_weights(mesh, map, internal::Host_loop()); });
  source.graph->update_diagonal({});
  graph_ = std::move(*source.graph);
  points_ = std::move(source.point);
  faces_ = std::move(source.face);
  position_ = std::move(source.position);
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
    for(int k = graph_.offset[i]; k < graph_.offset[i + 1]; ++k)
      row.emplace_back(number[graph_.target[k]], graph_.weight[k]);
    std::sort(row.begin(), row.end());
    for(const auto& [j, weight] : row) {
      result.graph_.target.push_back(j);
      result.graph_.weight.push_back(weight);
    }
    result.graph_.offset.push_back(static_cast<int>(result.graph_.target.size()));
    result.points_.push_back(points_[i]);
    result.position_.push_back(position_[i]);
  }
  for(const std::array<int, 3>& f : faces_)
    result.faces_.push_back({number[f[0]], number[f[1]], number[f[2]]});
  result.graph_.update_diagonal({});
  return result;
}

std::vector<int> Sweep_graph::neighbours(int vertex) const
{
  return {graph_.target.begin() + graph_.offset[vertex], graph_.target.begin() + graph_.offset[vertex + 1]};
}

std::vector<Point_3> Sweep_graph::points() const
{
  std::vector<Point_3> points;
  for(const vec3& p : points_)
    points.emplace_back(p.x, p.y, p.z);
  return points;
}

double Sweep_graph::bytes(Sweep sweep) const
{
  const double graph = sizeof(int) * (size() + 1.) + (sizeof(int) + sizeof(double)) * double(graph_.target.size());
  return sweep == Sweep::LAPLACIAN
           ? graph + 2. * sizeof(vec3) * size()                     // x and y
           : graph + (sizeof(double) + 3. * sizeof(vec3)) * size(); // inverse diagonal, v, u and w
}

double Sweep_graph::residual(const Mesh& mesh, Sphere_map sphere) const
{
  const std::vector<Mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  Host_array<vec3> v;
  for(int i : position_) {
    const Point_3& p = sphere[vertices[i]];
    v.push_back({p.x(), p.y(), p.z()});
  }
  const CGAL::Sequential_tag one_core;
  return std::sqrt(internal::Backend<CGAL::Sequential_tag>(one_core).barycentric_residual2(
    std::make_shared<const internal::Weighted_graph>(graph_), v));
}

std::function<void(int)> Sweep_graph::sweeps(const Backend& backend, Sweep sweep) const
{
  Host_array<vec3> start;
  for(const vec3& p : points_) // the bounding box starts at the origin: nothing here is 0 but the origin itself
    start.push_back(internal::inner(p, p) > 0 ? internal::unit(p) : vec3{0, 0, 1});
  const int size_of_copy = static_cast<int>(bytes(Sweep::COPY) / (2 * sizeof(vec3)));
  return std::visit(
    [&](const auto& policy) -> std::function<void(int)> {
      typedef Sweeper<std::decay_t<decltype(policy)>> Sweeper_on_device;
      std::shared_ptr<Sweeper_on_device> sweeper;
      within(backend,
             [&] { sweeper = std::make_shared<Sweeper_on_device>(policy, graph_, start, sweep, size_of_copy); });
      return [backend, sweeper](int count) { within(backend, [&] { (*sweeper)(count); }); };
    },
    backend.policy);
}

std::vector<double> seconds_per_sweep(const std::vector<std::function<void(int)>>& sweeps)
{
  constexpr int rounds = 11;
  constexpr double shortest_batch = 0.01;
  std::vector<std::function<double()>> measurements;
  for(const auto& sweep : sweeps) {
    int count = 1;
    for(;; count *= 2) {
      const Stopwatch watch;
      sweep(count);
      if(watch.seconds() >= shortest_batch)
        break;
    }
    measurements.emplace_back([&sweep, count] {
      const Stopwatch watch;
      sweep(count);
      return watch.seconds() / count;
    });
  }
  return interleaved_medians(rounds, measurements, std::less<double>());
}

} // namespace benchmark
