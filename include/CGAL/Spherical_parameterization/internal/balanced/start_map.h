// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_START_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_START_MAP_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Float_cycle.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>
#include <CGAL/Spherical_parameterization/internal/balanced/balanced_solver.h>
#include <CGAL/Spherical_parameterization/internal/moebius/moebius.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The harmonic map of level k to the plane, without the triangle `corners`, which goes to an equilateral one (Tutte's
/// embedding with weights). Since only the corners feel a force, L z is a combination of two dipoles between them: two
/// right-hand sides of the singular Laplacian itself, and no other matrix is needed. The planar coordinates are
/// returned in x and y; the iterations are added to `iterations`.
template <class Backend>
Host_array<vec3> planar_map(const Backend& backend, Multigrid<Backend>& multigrid, std::size_t k,
                            std::array<int, 3> corners, double accuracy, Monitor& monitor, double share_of_work,
                            std::size_t& iterations)
{
  const int n = multigrid.size(k);
  Host_array<vec3> dipoles(n, make_vec3(0, 0, 0));
  dipoles[corners[0]].x = 1;
  dipoles[corners[1]].y = 1;
  dipoles[corners[2]] = make_vec3(-1, -1, 0);
  typename Backend::Vectors solution = backend.vectors(n);
  iterations += conjugate_gradients(backend, multigrid, k, backend.upload(std::move(dipoles)), accuracy, monitor,
                                    share_of_work, solution);
  Host_array<vec3> z = backend.download(solution);

  // The affine map that sends the corners to the equilateral triangle, clockwise: the face lies outside of it, so that
  // all other faces come out counter-clockwise.
  const vec3 origin = z[corners[2]];
  const vec3 a = sub(z[corners[0]], origin), b = sub(z[corners[1]], origin);
  const double angle = 2 * pi / 3;
  const double cosine = std::cos(-angle * 2), sine = std::sin(-angle * 2);
  const vec3 to_a = {1 - cosine, -sine, 0}, to_b = {std::cos(-angle) - cosine, std::sin(-angle) - sine, 0};
  const double inverse = 1 / (a.x * b.y - a.y * b.x);
  const vec3 x = add_scaled(scale(b.y * inverse, to_a), -a.y * inverse, to_b);
  const vec3 y = add_scaled(scale(-b.x * inverse, to_a), a.x * inverse, to_b);
  for(vec3& p : z) {
    const vec3 q = sub(p, origin);
    p = make_vec3(x.x * q.x + y.x * q.y, x.y * q.x + y.y * q.y, 0);
  }
  return z;
}

/// Inverse stereographic projection that keeps the orientation (the origin goes to the north pole), after the median of
/// the points has been moved to the origin and their median distance from it scaled to 1. Points that are not finite,
/// since doubles cannot tell the corners of the planar map apart, go to the south pole: the certificate counts them.
inline void to_sphere(Host_array<vec3>& z)
{
  constexpr std::size_t sample_size = 50000; // an estimate is good enough: the Moebius transformation comes after
  const std::size_t stride = 1 + z.size() / sample_size;
  std::vector<double> value;
  const auto median = [&](auto coordinate) {
    value.clear();
    for(std::size_t i = 0; i < z.size(); i += stride)
      if(const double x = coordinate(z[i]); std::isfinite(x))
        value.push_back(x);
    if(value.empty())
      return 0.;
    const auto middle = value.begin() + value.size() / 2;
    std::nth_element(value.begin(), middle, value.end());
    return *middle;
  };
  const vec3 centre = {median([](vec3 p) { return p.x; }), median([](vec3 p) { return p.y; }), 0};
  const double radius = median([&](vec3 p) { return std::hypot(p.x - centre.x, p.y - centre.y); });
  const double factor = radius > 0 ? 1 / radius : 1; // most of the points may be as good as the same
  for(vec3& p : z) {
    const vec3 q = scale(factor, sub(p, centre));
    const double s = inner(q, q);
    p = s < 1e100 ? unit(make_vec3(2 * q.x, 2 * q.y, 1 - s)) : make_vec3(0, 0, -1);
  }
}

/// The mesh as level k of the hierarchy sees it, with a vertex for every aggregate.
struct Coarse_mesh {
  Host_array<int> vertex_of;            ///< by vertex of the finest level; -1: none
  Host_array<std::array<int, 3>> faces; ///< the faces that still have three vertices
  std::array<int, 3> largest_face;      ///< of these, where the largest face of the mesh went
  bool is_complete = false;             ///< whether no vertex was lost (negative weights can do that), and a face left

  template <class Backend>
  Coarse_mesh(const Backend& backend, const Multigrid<Backend>& multigrid, std::size_t k, const Problem& problem)
  {
    const auto& loop = backend.host_loop();
    vertex_of.resize(problem.size());
    const int lost = first_index(loop, problem.size(), [&](int i) {
      int c = i;
      for(std::size_t level = 0; level < k && c >= 0; ++level)
        c = multigrid.level(level).aggregates->of_vertex[c];
      vertex_of[i] = c;
      return c < 0;
    });
    if(lost < problem.size())
      return;

    struct Part {
      std::vector<std::array<int, 3>> faces;
      double largest = -1; // squared area
      std::array<int, 3> largest_face;
    };
    const std::vector<Part> parts =
      results_of_parts(loop, static_cast<int>(problem.face.size()), [&](int begin, int end) {
        Part part;
        for(int f = begin; f < end; ++f) {
          const std::array<int, 3>& fine = problem.face[f];
          const std::array<int, 3> coarse = {vertex_of[fine[0]], vertex_of[fine[1]], vertex_of[fine[2]]};
          if(coarse[0] == coarse[1] || coarse[1] == coarse[2] || coarse[2] == coarse[0])
            continue;
          part.faces.push_back(coarse);
          const vec3 n = normal(problem.point, fine);
          if(inner(n, n) > part.largest) {
            part.largest = inner(n, n);
            part.largest_face = coarse;
          }
        }
        return part;
      });
    double largest = -1;
    for(const Part& part : parts) {
      faces.insert(faces.end(), part.faces.begin(), part.faces.end());
      if(part.largest > largest) {
        largest = part.largest;
        largest_face = part.largest_face;
      }
    }
    is_complete = !faces.empty();
  }
};

/// The planar harmonic map of a coarse level brought to the sphere, boosted until the centroid of the source area lies
/// at the centre. Returns the level: the coarsest one on which a start map is still worth its work, and whose map has
/// degree 1; else the finest one, whatever its degree. (Aggregates need not be discs: orientation may be lost or
/// reversed on the way down.) Throws Error where no face of the mesh has three vertices.
template <class Backend>
std::size_t coarse_start_map(const Backend& backend, Multigrid<Backend>& multigrid, const Problem& problem,
                             Monitor& monitor, std::size_t& iterations, typename Backend::Vectors& v)
{
  constexpr int smallest_size = 400;
  // The boost may enlarge what lies far inside a million times.
  const double planar_accuracy = (std::max)(1e-12, backend.best_accuracy(problem.size()));
  std::size_t k = 0;
  while(k + 1 < multigrid.number_of_levels() && multigrid.size(k + 1) >= smallest_size)
    ++k;
  for(;; --k) {
    const Coarse_mesh mesh(backend, multigrid, k, problem);
    if(!mesh.is_complete) {
      if(k == 0)
        throw Input_error(Error_code::NOT_BIJECTIVE, "every face of the mesh has a vertex twice");
      continue;
    }
    Host_array<vec3> z =
      planar_map(backend, multigrid, k, mesh.largest_face, planar_accuracy, monitor, start_share, iterations);
    to_sphere(z);
    const int degree = certify(backend.host_loop(), mesh.faces, z).degree;
    if(k > 0 && std::abs(degree) != 1)
      continue;
    if(degree == -1)
      for(vec3& p : z)
        p.x = -p.x;
    Host_array<double> area(z.size(), 0);
    const Host_array<double>& source_area = problem.vertex_area(backend.host_loop());
    for(int i = 0; i < problem.size(); ++i)
      area[mesh.vertex_of[i]] += source_area[i];
    v = backend.upload(std::move(z));
    typename Backend::Vectors scratch = backend.vectors(multigrid.size(k));
    centre(backend, backend.upload(std::move(area)), 0, v, scratch);
    return k;
  }
}

/// A map to start from, of degree 1 if a level has one, near the harmonic one of the mesh without fixed vertices: that
/// of a coarse level, and from there up level by level, each map being the descent's start on the next finer one. On
/// the finest level it is only interpolated, and not smooth.
///
/// `multigrid`: of the graph without fixed vertices.
template <class Backend>
typename Backend::Vectors start_map(const Backend& backend, Multigrid<Backend>& multigrid, Float_cycle<Backend>& cycle,
                                    const Problem& problem, Monitor& monitor, std::size_t& iterations)
{
  constexpr Descent_options coarse_descent = {1e-2, 30, 0, start_share};
  typename Backend::Vectors v;
  for(std::size_t k = coarse_start_map(backend, multigrid, problem, monitor, iterations, v); k > 0; --k) {
    typename Backend::Scalars mass = backend.scalars(multigrid.size(k));
    backend.spring_masses(multigrid.matrix(k), v, mass);
    Balanced_solver<Backend> solver(backend, multigrid.matrix(k), cycle, k, 2, Gauge::BALANCED, mass);
    iterations += solver.solve(coarse_descent, monitor, v).iterations;
    typename Backend::Vectors finer = backend.vectors(multigrid.size(k - 1));
    multigrid.prolong(k - 1, v, finer);
    v = backend.vectors(multigrid.size(k - 1));
    backend.normalize(multigrid.matrix(k - 1), finer, v);
  }
  return v;
}

/// The start map of a problem with fixed vertices, or of a method without hierarchy: one is set up for the graph
/// without fixed vertices. The map is moved by the Moebius transformation that suits the fixed vertices best.
template <class Backend>
Host_array<vec3> start_positions(const Backend& backend, const Problem& problem, Monitor& monitor,
                                 std::size_t& iterations)
{
  Multigrid<Backend> multigrid(backend, problem.graph, &monitor);
  Float_cycle<Backend> cycle(backend, multigrid, 1); // the map is not improved on level 0
  Host_array<vec3> start = backend.download(start_map(backend, multigrid, cycle, problem, monitor, iterations));

  if(problem.has_fixed()) {
    Host_array<vec3> from, to;
    for(int i = 0; i < problem.size(); ++i)
      if(problem.is_fixed[i]) {
        from.push_back(start[i]);
        to.push_back(problem.given[i]);
      }
    const Moebius_alignment align(std::move(from), to);
    for(int i = 0; i < problem.size(); ++i)
      start[i] = problem.is_fixed[i] ? problem.given[i] : align(start[i]);
  }
  return start;
}

/// The graph of a problem, in which the vertices that are fixed do not move.
CGAL_SP_INLINE Shared_graph with_fixed_vertices(const Host_loop& loop, const Problem& problem)
{
  if(!problem.has_fixed())
    return problem.graph;
  const auto graph = std::make_shared<Weighted_graph>(*problem.graph);
  graph->update_diagonal(problem.is_fixed, loop);
  return graph;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_START_MAP_H
