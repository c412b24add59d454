// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_VERTEX_INSERTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_VERTEX_INSERTION_H

#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Distortion.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Planar.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Star.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Spherical_parameterization::internal {

/// A point well inside the kernel of the star round v, on whose boundary v may lie: the mean of the corners of the
/// kernel polygon in the tangent plane at v (by the gnomonic projection great circles are lines), clipped to a square a
/// few times as large as the star. Found with rounding errors: to be checked.
inline vec3 kernel_point(const Star& star, vec3 v)
{
  typedef boost::container::small_vector<Planar, 24> Polygon;
  const Tangents tangents(v);
  double size = 0;
  for(const Star_face& f : star)
    size = (std::max)(size, inner(sub(f.j, v), sub(f.j, v)));
  size = (std::min)(1., 2 * std::sqrt(size));
  Polygon kernel = {{-size, -size}, {size, -size}, {size, size}, {-size, size}}, clipped;
  for(const Star_face& f : star) {
    const vec3 n = outer(f.j, f.k);
    const double constant = f.determinant(v), slope_s = inner(n, tangents.s), slope_t = inner(n, tangents.t);
    const auto side = [&](Planar p) { return constant + slope_s * p.s + slope_t * p.t; };
    clipped.clear();
    for(std::size_t i = 0; i < kernel.size(); ++i) {
      const Planar a = kernel[i], b = kernel[(i + 1) % kernel.size()];
      const double at_a = side(a), at_b = side(b);
      if(at_a >= 0)
        clipped.push_back(a);
      if((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) {
        const double r = at_a / (at_a - at_b);
        clipped.push_back({a.s + r * (b.s - a.s), a.t + r * (b.t - a.t)});
      }
    }
    kernel.swap(clipped);
  }
  if(kernel.empty())
    return v;
  Planar mean = {0, 0};
  for(const Planar& p : kernel) {
    mean.s += p.s / double(kernel.size());
    mean.t += p.t / double(kernel.size());
  }
  return unit(add_scaled(add_scaled(v, mean.s, tangents.s), mean.t, tangents.t));
}

/// Places a vertex that was collapsed into the one at v, given the star it will have: in the kernel of that, which is
/// not empty, since v sees its whole ring, but which doubles may not resolve. Returns whether there is a position x
/// such that all faces of the star are positively oriented, exactly.
///
/// The best of some candidates is improved by Newton's method.
inline bool insert_vertex(const Distortion& distortion, const Star& star, vec3 v, vec3& x)
{
  constexpr int maximum_steps = 6;
  constexpr double sufficient_gain = 1e-2;
  double best = std::numeric_limits<double>::infinity();
  const auto consider = [&](vec3 candidate) {
    const double energy = star_energy(distortion, star, candidate);
    if(energy < best && is_valid_centre(star, candidate)) {
      best = energy;
      x = candidate;
    }
  };

  vec3 centroid = {0, 0, 0}, harmonic = {0, 0, 0};
  for(const Star_face& f : star) {
    constexpr double least = 0.05;
    centroid = add(centroid, f.j);
    harmonic = add_scaled(harmonic, (std::max)(least, f.cot_j), f.k);
    harmonic = add_scaled(harmonic, (std::max)(least, f.cot_k), f.j);
  }
  const vec3 in_kernel = kernel_point(star, v);
  for(vec3 candidate : {centroid, harmonic})
    if(inner(candidate, candidate) > 0)
      consider(unit(candidate));
  consider(in_kernel);
  // Towards v the kernel never ends.
  constexpr int least_approach = 6, longest_approach = 52;
  double t = 0.5;
  for(int i = 0; i < longest_approach && (i < least_approach || !std::isfinite(best)); ++i, t /= 2)
    for(vec3 far : {unit(centroid), in_kernel})
      consider(unit(add_scaled(v, t, sub(far, v))));
  if(!std::isfinite(best))
    return false;
  for(int step = 0; step < maximum_steps; ++step)
    if(relax_centre(distortion, star, x, best) < sufficient_gain * best)
      break;
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_VERTEX_INSERTION_H
