// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_CANONICAL_ORDER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_CANONICAL_ORDER_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/surface/breadth_first.h>

#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// The mean of f(v) over n vertices, to the same bits in whatever order they come: a sum of integers. No coordinate may
/// be above 16.
template <class F>
vec3 mean_in_any_order(int n, F f)
{
  constexpr double resolution = 1 << 27; // so that the sum of 2^31 numbers has room
  std::int64_t x = 0, y = 0, z = 0;
  for(int v = 0; v < n; ++v) {
    const vec3 p = f(v);
    x += std::llround(resolution * p.x);
    y += std::llround(resolution * p.y);
    z += std::llround(resolution * p.z);
  }
  const double unit = 1 / (resolution * n);
  return {double(x) * unit, double(y) * unit, double(z) * unit};
}

/// What tells the vertices of a mesh apart by where they are, seen from the others: a similarity changes nothing. The
/// farthest vertex from the mean of all has the highest rank. Of two that mirror each other, one is on the positive
/// side of the mirror: two moments of the vertices lie in it, and their product is its normal. Returns the function
/// that gives the rank of a vertex.
CGAL_SP_INLINE auto vertex_ranks(const Host_array<vec3>& points)
{
  constexpr double preference = 0.1;
  constexpr double least_sine = 1e-4; // of the angle between the moments, for the mirror to be known
  const int n = static_cast<int>(points.size());
  const vec3 mean = mean_in_any_order(n, [&](int v) { return points[v]; });
  const auto moment = [&](auto weight) {
    return mean_in_any_order(n, [&](int v) {
      const vec3 d = sub(points[v], mean);
      return scale(weight(inner(d, d)), d);
    });
  };
  const vec3 a = moment([](double r2) { return r2; }), b = moment([](double r2) { return r2 * r2; });
  const vec3 normal = outer(a, b);
  const double length2 = inner(normal, normal);
  vec3 mirror = {0, 0, 0}; // its normal, as long as one side is preferred
  if(length2 > least_sine * least_sine * inner(a, a) * inner(b, b))
    mirror = scale(preference / std::sqrt(length2), normal);
  return [&points, mean, mirror](int v) { // ties are decided by the coordinates
    const vec3 p = points[v], d = sub(p, mean);
    const double r2 = inner(d, d);
    return std::make_tuple(r2 + std::sqrt(r2) * inner(mirror, d), p.x, p.y, p.z);
  };
}

/// The vertices of a closed connected mesh, in an order that its shape decides, and not how it is numbered. See
/// in_canonical_order().
struct Canonical_order {
  Host_array<int> vertex;    ///< in this order
  Host_array<int> half_edge; ///< of every vertex of the mesh: the first one of the walk round it
};

/// f(h) for all halfedges that leave the origin of `first`, counterclockwise.
template <class F>
void walk_round(const Corner_table& mesh, int first, F f)
{
  int h = first;
  do {
    f(h);
    h = mesh.twin[Corner_table::previous(h)];
  } while(h != first);
}

/// Breadth-first, and round every vertex counterclockwise from the edge by which it was reached. The first edge goes
/// from the vertex of highest rank to the highest one of its neighbours. The numbers decide only between vertices at
/// one point.
CGAL_SP_INLINE Canonical_order canonical_order(const Corner_table& mesh, const Host_array<vec3>& points)
{
  const auto rank = vertex_ranks(points);
  const int n = static_cast<int>(points.size());
  int farthest = 0;
  auto highest = rank(farthest);
  for(int v = 1; v < n; ++v)
    if(const auto its = rank(v); its > highest) {
      highest = its;
      farthest = v;
    }
  int first = -1;
  for(int h = 0; h < mesh.number_of_halfedges(); ++h)
    if(mesh.origin(h) == farthest && (first < 0 || rank(mesh.target(h)) > rank(mesh.target(first))))
      first = h;

  Canonical_order order = {{}, Host_array<int>(n, -1)};
  order.vertex.reserve(n);
  order.vertex.push_back(farthest);
  order.half_edge[farthest] = first;
  for(int i = 0; i < static_cast<int>(order.vertex.size()); ++i)
    walk_round(mesh, order.half_edge[order.vertex[i]], [&](int h) {
      const int w = mesh.target(h);
      if(order.half_edge[w] < 0) {
        order.half_edge[w] = mesh.twin[h];
        order.vertex.push_back(w);
      }
    });
  return order;
}

/// Scales points so that the mean of their squared distances from their mean is 1, unless they are all one.
inline void scale_to_unit_size(Host_array<vec3>& points)
{
  const double n = static_cast<double>(points.size());
  vec3 mean = {0, 0, 0};
  for(const vec3& p : points)
    mean = add_scaled(mean, 1 / n, p);
  double square = 0;
  for(const vec3& p : points)
    square += squared_distance(p, mean) / n;
  const double factor = square > 0 ? 1 / std::sqrt(square) : 1;
  for(vec3& p : points)
    p = scale(factor, p);
}

/// The problem of a similar mesh, of unit size, with vertices in canonical order, and with faces by their smallest
/// vertices, which come first in them. So its bits do not depend on how the vertices and the faces of the mesh are
/// numbered. And the faces of a star lie close together in memory, as the vertices do: where a mesh is larger than the
/// caches, that is half of the time of the decimation. Springs are left out. Sets the vertices of the problem, in this
/// order. \pre the mesh is simplicial
CGAL_SP_INLINE Problem in_canonical_order(const Watched_loop<Host_loop>& loop, const Problem& problem,
                                          Host_array<int>& vertex)
{
  const Corner_table mesh = problem.copy_of_corner_table(loop);
  loop.check();
  Canonical_order order = canonical_order(mesh, problem.point);
  loop.check();
  vertex = std::move(order.vertex);
  const Host_array<int> index = inverse_permutation(loop.bare(), vertex);
  const int n = problem.size();
  Problem result;
  result.number_of_vertices = n;
  result.as_stored = problem.as_stored;
  const auto take = [&](const auto& from, auto& to) {
    if(from.empty())
      return;
    to.resize(n);
    for_each_index(loop, n, [&](int i) { to[i] = from[vertex[i]]; });
  };
  take(problem.point, result.point);
  scale_to_unit_size(result.point);
  take(problem.position, result.position);
  take(problem.is_fixed, result.is_fixed);
  take(problem.given, result.given);
  result.face.reserve(problem.face.size());
  result.density.reserve(problem.density.size());
  for(int i = 0; i < n; ++i)
    walk_round(mesh, order.half_edge[vertex[i]], [&](int h) {
      const int j = index[mesh.target(h)], k = index[mesh.apex(h)];
      if(i < j && i < k) {
        result.face.push_back({i, j, k});
        if(!problem.density.empty())
          result.density.push_back(problem.density[h / 3]);
      }
    });
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_CANONICAL_ORDER_H
