// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_STAR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_STAR_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Distortion.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace CGAL::Spherical_parameterization::internal {

/// A vector in a tangent plane, or its product with tangents.
struct Planar {
  double s, t;
};

inline double inner(Planar a, Planar b) { return a.s * b.s + a.t * b.t; }
inline Planar add_scaled(Planar a, double r, Planar b) { return {a.s + r * b.s, a.t + r * b.t}; }

/// The unit eigenvector of the matrix (half, off; off, -half) to its positive eigenvalue `split`.
inline Planar principal_axis(double half, double off, double split)
{
  const Planar axis = half >= 0 ? Planar{split + half, off} : Planar{off, split - half};
  const double norm = std::sqrt(inner(axis, axis));
  return norm > 0 ? Planar{axis.s / norm, axis.t / norm} : Planar{1, 0};
}

/// Tangents at a point of the sphere.
struct Tangents {
  vec3 s, t;

  Planar products(vec3 a) const { return {inner(a, s), inner(a, t)}; }
  vec3 combined(Planar a) const { return add_scaled(scale(a.s, s), a.t, t); }
};

/// Orthonormal ones at the unit vector x, such that outer(s, t) is x: T. Duff et al., "Building an orthonormal basis,
/// revisited", JCGT 2017.
inline Tangents tangents_at(vec3 x)
{
  const double sign = std::copysign(1., x.z), a = -1 / (sign + x.z), b = x.x * x.y * a;
  return {{1 + sign * x.x * x.x * a, sign * b, -sign * x.x}, {b, sign + x.y * x.y * a, -x.y}};
}

/// det(x, y, z), from differences: exact relative to the size of the triangle.
inline double determinant(vec3 x, vec3 y, vec3 z) { return inner(x, outer(sub(y, x), sub(z, x))); }

/// A face (x, j, k) at a vertex x on the sphere: where its other corners are, and what it is in the source.
struct Star_face {
  vec3 j, k;
  double cot_x, cot_j, cot_k;
  double twice_area;

  Star_face(vec3 at_j, vec3 at_k, const Face_metric& metric, double area_scale)
    : j(at_j), k(at_k), cot_x(metric.cotangent[0]), cot_j(metric.cotangent[1]), cot_k(metric.cotangent[2]),
      twice_area(area_scale * metric.twice_area)
  {}

  double determinant(vec3 x) const { return internal::determinant(x, j, k); }

  /// The Dirichlet energy of the chordal triangle: half the sum over the sides of cotangent times squared length.
  double dirichlet(vec3 x) const
  {
    const vec3 a = sub(j, x), b = sub(k, x), c = sub(k, j);
    return (cot_x * inner(c, c) + cot_j * inner(b, b) + cot_k * inner(a, a)) / 2;
  }

  /// The distortion, integrated over the source; infinite unless the face is positive.
  double energy(const Distortion& distortion, vec3 x) const
  {
    const double det = determinant(x);
    return det > 0 ? dirichlet(x) * distortion.value(det / twice_area) : std::numeric_limits<double>::infinity();
  }
};

/// The faces round a vertex.
typedef boost::container::small_vector<Star_face, 12> Star;

/// Whether all faces of the star with centre x are positively oriented, exactly.
CGAL_SP_INLINE bool is_valid_centre(const Star& star, vec3 x)
{
  return std::all_of(star.begin(), star.end(), [x](const Star_face& f) { return is_positively_oriented(x, f.j, f.k); });
}

/// What a star would be with its centre at x.
struct Star_trial {
  double energy = 0;           ///< the distortion, integrated over the source; infinite unless all faces are positive
  bool is_surely_valid = true; ///< whether rounding cannot have made any face positive

  Star_trial(const Distortion& distortion, const Star& star, vec3 x)
  {
    for(const Star_face& f : star) {
      const double determinant = f.determinant(x);
      if(!(determinant > 0)) {
        energy = std::numeric_limits<double>::infinity();
        return;
      }
      energy += f.dirichlet(x) * distortion.value(determinant / f.twice_area);
      // The error is at most 1e-15 sqrt(3) |a| |b|, see `Determinant`.
      const vec3 a = sub(f.j, x), b = sub(f.k, x);
      is_surely_valid =
        is_surely_valid && determinant > 1e-100 && determinant * determinant > 4e-30 * inner(a, a) * inner(b, b);
    }
  }
};

/// Whether the star of the trial, with centre x, has positively oriented faces, exactly.
CGAL_SP_INLINE bool is_valid_trial(const Star_trial& trial, const Star& star, vec3 x)
{
  return trial.is_surely_valid ? std::isfinite(trial.energy) : is_valid_centre(star, x);
}

/// The solution of |H| s = -g, |H| the symmetric matrix with the absolute eigenvalues of H (and none much smaller than
/// the other): a descent direction, and Newton's if H is positive definite.
CGAL_SP_INLINE Planar solve_positive(double h11, double h12, double h22, Planar g)
{
  constexpr double smallest_share = 1e-3;
  const double mean = (h11 + h22) / 2, half = (h11 - h22) / 2;
  const double split = std::sqrt(half * half + h12 * h12);
  const double largest = std::abs(mean) + split;
  if(mean - split > 1e-6 * largest) {
    const double determinant = h11 * h22 - h12 * h12;
    return {(h12 * g.t - h22 * g.s) / determinant, (h12 * g.s - h11 * g.t) / determinant};
  }
  const auto [c, d] = principal_axis(half, h12, split);
  const double a = -(c * g.s + d * g.t) / (std::max)(std::abs(mean + split), smallest_share * largest);
  const double b = -(c * g.t - d * g.s) / (std::max)(std::abs(mean - split), smallest_share * largest);
  return {c * a - d * b, d * a + c * b};
}

/// One step of Newton's method for the centre x of a star, along a geodesic tangent and back to the sphere. It is
/// taken only if the energy falls (Armijo) and all faces stay positively oriented, by the exact predicate: a valid
/// star stays valid. `energy` is that of the star, on return.
/// Returns by how much it fell; 0 if there was no step.
CGAL_SP_INLINE double relax_centre(const Distortion& distortion, const Star& star, vec3& x, double& energy)
{
  constexpr double share_of_the_way_to_a_flip = 0.8, armijo = 1e-4;
  constexpr int maximum_halvings = 12;
  struct Determinant_at {
    double value;
    Planar gradient;
  };
  boost::container::small_vector<Determinant_at, 12> determinants;
  const Tangents tangents = tangents_at(x);
  Planar gradient = {0, 0};
  double h11 = 0, h12 = 0, h22 = 0, radial = 0;
  energy = 0;
  for(const Star_face& f : star) {
    const vec3 to_j = sub(f.j, x), to_k = sub(f.k, x);
    // in the frame of the tangents and x, where most products have few terms
    const Planar a = tangents.products(to_j), b = tangents.products(to_k);
    const double a_x = inner(to_j, x), b_x = inner(to_k, x), inverse = 1 / f.twice_area;
    const Planar c = add_scaled(b, -1, a);
    const double determinant = a.s * b.t - a.t * b.s;
    const double dirichlet = (f.cot_x * (inner(c, c) + (b_x - a_x) * (b_x - a_x)) +
                              f.cot_j * (inner(b, b) + b_x * b_x) + f.cot_k * (inner(a, a) + a_x * a_x)) /
                             2;
    const Distortion::Psi psi = distortion.psi(determinant * inverse);
    const double slope = psi.first * inverse, bend = dirichlet * psi.second * inverse * inverse;
    // gradients of the two factors: L' and d' = j x k
    const Planar l = {-f.cot_j * b.s - f.cot_k * a.s, -f.cot_j * b.t - f.cot_k * a.t};
    const Planar d = {a.t * b_x - a_x * b.t - c.t, a_x * b.s - a.s * b_x + c.s};
    const double stiffness = (f.cot_j + f.cot_k) * psi.value, force = dirichlet * slope;
    gradient.s += psi.value * l.s + force * d.s;
    gradient.t += psi.value * l.t + force * d.t;
    radial += force * determinant - psi.value * (f.cot_j * b_x + f.cot_k * a_x);
    h11 += stiffness + (2 * slope * l.s + bend * d.s) * d.s;
    h22 += stiffness + (2 * slope * l.t + bend * d.t) * d.t;
    h12 += slope * (l.s * d.t + l.t * d.s) + bend * d.s * d.t;
    energy += determinant > 0 ? dirichlet * psi.value : std::numeric_limits<double>::infinity();
    determinants.push_back({determinant, d});
  }
  const Planar newton = solve_positive(h11 - radial, h12, h22 - radial, gradient);
  const double descent = inner(gradient, newton);
  if(!(descent < 0))
    return 0;
  const vec3 step = tangents.combined(newton);
  double t = 1;
  for(const Determinant_at& d : determinants) { // they are linear along the step
    const double slope = inner(newton, d.gradient), most = share_of_the_way_to_a_flip * d.value;
    if(t * slope < -most)
      t = -most / slope;
  }
  for(int halving = 0; halving < maximum_halvings; ++halving, t /= 2) {
    const vec3 y = unit(add_scaled(x, t, step));
    const Star_trial trial(distortion, star, y);
    if(trial.energy <= energy + armijo * t * descent && is_valid_trial(trial, star, y)) {
      const double gain = energy - trial.energy;
      x = y;
      energy = trial.energy;
      return gain;
    }
  }
  return 0;
}

/// A point well inside the kernel of the star round v, on whose boundary v may lie: the mean of the corners of the
/// kernel polygon in the tangent plane at v (by the gnomonic projection great circles are lines), clipped to a square a
/// few times as large as the star. Found with rounding errors: to be checked.
CGAL_SP_INLINE vec3 kernel_point(const Star& star, vec3 v)
{
  typedef boost::container::small_vector<Planar, 24> Polygon;
  const Tangents tangents = tangents_at(v);
  double size = 0;
  for(const Star_face& f : star)
    size = (std::max)(size, squared_distance(f.j, v));
  size = (std::min)(1., 2 * std::sqrt(size));
  Polygon kernel = {{-size, -size}, {size, -size}, {size, size}, {-size, size}}, clipped;
  for(const Star_face& f : star) {
    const double constant = f.determinant(v);
    const Planar slope = tangents.products(outer(f.j, f.k));
    const auto side = [&](Planar p) { return constant + slope.s * p.s + slope.t * p.t; };
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
  for(Planar p : kernel)
    mean = {mean.s + p.s / double(kernel.size()), mean.t + p.t / double(kernel.size())};
  return unit(add_scaled(add_scaled(v, mean.s, tangents.s), mean.t, tangents.t));
}

/// Places a vertex that was collapsed into the one at v, given the star it will have: in the kernel of that, which is
/// not empty, since v sees its whole ring, but which doubles may not resolve. Returns whether there is a position x
/// such that all faces of the star are positively oriented, exactly.
///
/// The best of some candidates is improved by Newton's method. The first one with which the star is distorted no more
/// than `sufficient` in the mean will do.
CGAL_SP_INLINE bool insert_vertex(const Distortion& distortion, const Star& star, vec3 v, double sufficient, vec3& x)
{
  constexpr int maximum_steps = 6;
  constexpr double sufficient_gain = 1e-2;
  double best = std::numeric_limits<double>::infinity();
  const auto consider = [&](vec3 candidate) {
    const Star_trial trial(distortion, star, candidate);
    if(trial.energy < best && is_valid_trial(trial, star, candidate)) {
      best = trial.energy;
      x = candidate;
    }
  };

  vec3 centroid = {0, 0, 0}, harmonic = {0, 0, 0};
  double twice_area = 0;
  for(const Star_face& f : star) {
    constexpr double least = 0.05;
    twice_area += f.twice_area;
    centroid = add(centroid, f.j);
    harmonic = add_scaled(harmonic, (std::max)(least, f.cot_j), f.k);
    harmonic = add_scaled(harmonic, (std::max)(least, f.cot_k), f.j);
  }
  for(vec3 candidate : {harmonic, centroid})
    if(inner(candidate, candidate) > 0 && best > sufficient * twice_area / 2)
      consider(unit(candidate));
  if(best > sufficient * twice_area / 2) {
    const vec3 in_kernel = kernel_point(star, v);
    consider(in_kernel);
    // Towards v the kernel never ends.
    constexpr int least_approach = 6, longest_approach = 52;
    double t = 0.5;
    for(int i = 0; i < longest_approach && (i < least_approach || !std::isfinite(best)); ++i, t /= 2)
      for(vec3 far : {unit(centroid), in_kernel})
        consider(unit(add_scaled(v, t, sub(far, v))));
  }
  if(!std::isfinite(best))
    return false;
  for(int step = 0; step < maximum_steps; ++step)
    if(relax_centre(distortion, star, x, best) < sufficient_gain * best)
      break;
  return true;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_STAR_H
