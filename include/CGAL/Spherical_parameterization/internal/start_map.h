// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_START_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_START_MAP_H

#include <CGAL/Spherical_parameterization/internal/Map_task.h>
#include <CGAL/Spherical_parameterization/internal/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/conjugate_gradients.h>
#include <CGAL/Spherical_parameterization/internal/moebius.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// The harmonic map of the mesh without the face `outer` to the plane, `outer` going to an equilateral triangle
/// (Tutte's embedding with weights). Since only the corners of `outer` feel a force, L z is a combination of two
/// dipoles between them: two right-hand sides of the singular Laplacian itself, and no other matrix is needed. The
/// planar coordinates are returned in x and y.
template <class Backend>
std::vector<vec3> planar_map(const Backend& backend, const typename Backend::Matrix& a, Multigrid<Backend>& multigrid,
                             std::array<int, 3> outer, double accuracy, Monitor& monitor, double share_of_work, int n,
                             std::size_t& iterations)
{
  std::vector<vec3> dipoles(n, make_vec3(0, 0, 0));
  dipoles[outer[0]].x = 1;
  dipoles[outer[1]].y = 1;
  dipoles[outer[2]] = make_vec3(-1, -1, 0);
  typename Backend::Vectors solution = backend.vectors(n);
  iterations = conjugate_gradients(backend, a, multigrid, backend.upload(std::move(dipoles)), accuracy, monitor,
                                   share_of_work, solution);
  std::vector<vec3> z = backend.download(solution);

  // The affine map that sends the corners to the equilateral triangle, clockwise: the face lies outside of it, so that
  // all other faces come out counter-clockwise.
  const vec3 origin = z[outer[2]];
  Eigen::Matrix2d from, to;
  const double angle = 2 * std::acos(-1.) / 3;
  for(int k = 0; k < 2; ++k) {
    from.col(k) << z[outer[k]].x - origin.x, z[outer[k]].y - origin.y;
    to.col(k) << std::cos(-angle * k) - std::cos(-angle * 2), std::sin(-angle * k) - std::sin(-angle * 2);
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

/// The planar harmonic map brought to the sphere, boosted until the centroid of the source area lies at the centre, of
/// degree 1. With fixed vertices moved by the Moebius transformation that suits them best.
template <class Backend>
std::vector<vec3> harmonic_start(const Backend& backend, const typename Backend::Matrix& matrix,
                                 Multigrid<Backend>& multigrid, const Map_task& task, double share_of_work)
{
  // The descent does not need more: on 40 models its number of iterations, and the flips in the end (none), were the
  // same for 1e-3 and 1e-11. But the masses of the balance are taken from here, and should not depend on the
  // numbering of the vertices.
  constexpr double accuracy = 1e-6;
  constexpr double balance_tolerance = 1e-6;
  constexpr int maximum_steps = 50;
  std::vector<vec3> start = planar_map(backend, matrix, multigrid, task.largest_face, accuracy, task.monitor,
                                       share_of_work, task.size(), task.result.start_iterations);
  to_sphere(start);

  const typename Backend::Scalars mass = backend.upload(task.area);
  typename Backend::Vectors v = backend.upload(std::move(start)), scratch = backend.vectors(task.size());
  Moments moments = backend.transform(mass, make_vec3(0, 0, 0), v, scratch);
  balance(backend, mass, balance_tolerance, maximum_steps, v, scratch, moments);
  start = backend.download(v);

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

/// The harmonic start of a task without hierarchy: sets one up for the graph without fixed vertices.
template <class Backend>
std::vector<vec3> harmonic_start(const Backend& backend, Map_task& task, double share_of_work)
{
  Weighted_graph free_graph = task.graph;
  free_graph.update_diagonal({});
  const typename Backend::Matrix matrix = backend.upload(free_graph);
  Multigrid<Backend> multigrid(backend, free_graph, matrix);
  return harmonic_start(backend, matrix, multigrid, task, share_of_work);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_START_MAP_H
