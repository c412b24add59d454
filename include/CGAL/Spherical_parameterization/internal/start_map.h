// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_START_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_START_MAP_H

#include <CGAL/Spherical_parameterization/internal/Map_task.h>
#include <CGAL/Spherical_parameterization/internal/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/balanced_solver.h>
#include <CGAL/Spherical_parameterization/internal/conjugate_gradients.h>
#include <CGAL/Spherical_parameterization/internal/moebius.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// The harmonic map of level k to the plane, without the triangle `corners`, which goes to an equilateral one (Tutte's
/// embedding with weights). Since only the corners feel a force, L z is a combination of two dipoles between them: two
/// right-hand sides of the singular Laplacian itself, and no other matrix is needed. The planar coordinates are
/// returned in x and y.
template <class Backend>
std::vector<vec3> planar_map(const Backend& backend, Multigrid<Backend>& multigrid, std::size_t k,
                             std::array<int, 3> corners, double accuracy, Monitor& monitor, double share_of_work,
                             std::size_t& iterations)
{
  const int n = multigrid.size(k);
  std::vector<vec3> dipoles(n, make_vec3(0, 0, 0));
  dipoles[corners[0]].x = 1;
  dipoles[corners[1]].y = 1;
  dipoles[corners[2]] = make_vec3(-1, -1, 0);
  typename Backend::Vectors solution = backend.vectors(n);
  iterations = conjugate_gradients(backend, multigrid, k, backend.upload(std::move(dipoles)), accuracy, monitor,
                                   share_of_work, solution);
  std::vector<vec3> z = backend.download(solution);

  // The affine map that sends the corners to the equilateral triangle, clockwise: the face lies outside of it, so that
  // all other faces come out counter-clockwise.
  const vec3 origin = z[corners[2]];
  Eigen::Matrix2d from, to;
  const double angle = 2 * std::acos(-1.) / 3;
  for(int c = 0; c < 2; ++c) {
    from.col(c) << z[corners[c]].x - origin.x, z[corners[c]].y - origin.y;
    to.col(c) << std::cos(-angle * c) - std::cos(-angle * 2), std::sin(-angle * c) - std::sin(-angle * 2);
  }
  const Eigen::Matrix2d m = to * from.inverse();
  for(vec3& p : z) {
    const Eigen::Vector2d q = m * Eigen::Vector2d(p.x - origin.x, p.y - origin.y);
    p = make_vec3(q[0], q[1], 0);
  }
  return z;
}

/// Inverse stereographic projection that keeps the orientation (the origin goes to the north pole), after the median of
/// the points has been moved to the origin and their median distance from it scaled to 1.
inline void to_sphere(std::vector<vec3>& z)
{
  constexpr std::size_t sample_size = 50000; // an estimate is good enough: the Moebius transformation comes after
  const std::size_t stride = 1 + z.size() / sample_size;
  std::vector<double> value;
  const auto median = [&](auto coordinate) {
    value.clear();
    for(std::size_t i = 0; i < z.size(); i += stride)
      value.push_back(coordinate(z[i]));
    const auto middle = value.begin() + value.size() / 2;
    std::nth_element(value.begin(), middle, value.end());
    return *middle;
  };
  const vec3 centre = {median([](vec3 p) { return p.x; }), median([](vec3 p) { return p.y; }), 0};
  const double radius = median([&](vec3 p) { return std::hypot(p.x - centre.x, p.y - centre.y); });
  for(vec3& p : z) {
    const vec3 q = scale(1 / radius, sub(p, centre));
    const double s = inner(q, q);
    p = unit(make_vec3(2 * q.x, 2 * q.y, 1 - s));
  }
}

/// The vertices of level k as seen from the finest one.
struct Coarse_level {
  std::size_t k = 0;
  std::vector<int> vertex_of; ///< by vertex of the finest level
  std::array<int, 3> corners; ///< where the three corners of the largest face went that still has three
};

/// The coarsest level on which a start map is still worth its work, and on which some face is left.
template <class Backend>
Coarse_level coarse_start_level(const Multigrid<Backend>& multigrid, const Map_task& task)
{
  constexpr int smallest_size = 1000;
  Coarse_level level;
  while(level.k + 1 < multigrid.number_of_levels() && multigrid.size(level.k + 1) >= smallest_size)
    ++level.k;
  for(;; --level.k) {
    level.vertex_of.resize(task.size());
    std::iota(level.vertex_of.begin(), level.vertex_of.end(), 0);
    for(std::size_t k = 0; k < level.k; ++k)
      for(int& i : level.vertex_of)
        i = multigrid.aggregate_of(k)[i];
    double largest = -1;
    for(const std::array<int, 3>& f : task.faces) {
      const std::array<int, 3> corners = {level.vertex_of[f[0]], level.vertex_of[f[1]], level.vertex_of[f[2]]};
      if(corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
        continue;
      const vec3 n = normal(task.points, f);
      if(inner(n, n) > largest) {
        largest = inner(n, n);
        level.corners = corners;
      }
    }
    if(largest >= 0)
      return level;
  }
}

/// A map of degree 1 to start from, near the harmonic one of the mesh without fixed vertices: the planar harmonic map
/// of a coarse level brought to the sphere, boosted until the centroid of the source area lies at the centre, and from
/// there up level by level, each map being the descent's start on the next finer one. On the finest level it is only
/// interpolated, and not smooth.
///
/// `multigrid`: of the graph without fixed vertices.
template <class Backend>
typename Backend::Vectors start_map(const Backend& backend, Multigrid<Backend>& multigrid, const Map_task& task)
{
  constexpr double planar_accuracy = 1e-6;
  constexpr Descent_options coarse_descent = {1e-2, 30, 30, 1000, 0, start_share};
  const Coarse_level start = coarse_start_level(multigrid, task);
  std::vector<vec3> z = planar_map(backend, multigrid, start.k, start.corners, planar_accuracy, task.monitor,
                                   start_share, task.result.start_iterations);
  to_sphere(z);
  std::vector<double> area(z.size(), 0);
  for(int i = 0; i < task.size(); ++i)
    area[start.vertex_of[i]] += task.area[i];
  typename Backend::Vectors v = backend.upload(std::move(z));
  {
    constexpr int maximum_steps = 50;
    typename Backend::Vectors scratch = backend.vectors(multigrid.size(start.k));
    centre(backend, backend.upload(std::move(area)), maximum_steps, v, scratch);
  }

  for(std::size_t k = start.k; k > 0; --k) {
    typename Backend::Scalars mass = backend.scalars(multigrid.size(k));
    backend.spring_masses(multigrid.matrix(k), v, mass);
    Balanced_solver<Backend> solver(backend, multigrid.matrix(k), multigrid, k, 2, Gauge::BALANCED, mass);
    task.result.start_iterations += solver.solve(coarse_descent, task.monitor, v).iterations;
    typename Backend::Vectors finer = backend.vectors(multigrid.size(k - 1));
    backend.transfer(multigrid.prolongation(k - 1), v, finer);
    v = backend.vectors(multigrid.size(k - 1));
    backend.normalise(multigrid.matrix(k - 1), finer, v);
  }
  return v;
}

/// The start map of a task with fixed vertices, or of a method without hierarchy: one is set up for the graph without
/// fixed vertices. The map is moved by the Moebius transformation that suits the fixed vertices best.
template <class Backend>
std::vector<vec3> start_positions(const Backend& backend, const Map_task& task)
{
  const auto free_graph = std::make_shared<Weighted_graph>(*task.graph);
  free_graph->update_diagonal({});
  Multigrid<Backend> multigrid(backend, free_graph);
  std::vector<vec3> start = backend.download(start_map(backend, multigrid, task));

  if(task.has_fixed()) {
    std::vector<vec3> from, to;
    for(int i = 0; i < task.size(); ++i)
      if(task.is_fixed[i]) {
        from.push_back(start[i]);
        to.push_back(task.given[i]);
      }
    const Moebius_alignment align(std::move(from), to);
    for(int i = 0; i < task.size(); ++i)
      start[i] = task.is_fixed[i] ? task.given[i] : align(start[i]);
  }
  return start;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_START_MAP_H
