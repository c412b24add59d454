// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_STAR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_STAR_H

#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Distortion.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Spherical_parameterization::internal {

/// A face (x, j, k) at a vertex x on the sphere: where its other corners are, and what it is in the source.
struct Star_face {
  vec3 j, k;
  double cot_x, cot_j, cot_k;
  double twice_area;

  /// det(x, j, k), from differences: exact relative to the size of the triangle.
  double determinant(vec3 x) const { return inner(x, outer(sub(j, x), sub(k, x))); }

  /// The Dirichlet energy of the chordal triangle: half the sum over the sides of cotangent times squared length.
  double dirichlet(vec3 x) const
  {
    const vec3 a = sub(j, x), b = sub(k, x), c = sub(k, j);
    return (cot_x * inner(c, c) + cot_j * inner(b, b) + cot_k * inner(a, a)) / 2;
  }
};

/// The faces round a vertex.
typedef boost::container::small_vector<Star_face, 12> Star;

/// Orthonormal tangents at the unit vector x.
struct Tangents {
  vec3 s, t;

  explicit Tangents(vec3 x)
  {
    s = unit(outer(x, std::abs(x.x) < 0.6 ? make_vec3(1, 0, 0) : make_vec3(0, 1, 0)));
    t = outer(x, s);
  }
};

/// The distortion of the star with centre x, integrated over the source; infinite unless all faces are positive.
inline double star_energy(const Distortion& distortion, const Star& star, vec3 x)
{
  double energy = 0;
  for(const Star_face& f : star) {
    const double determinant = f.determinant(x);
    if(!(determinant > 0))
      return std::numeric_limits<double>::infinity();
    energy += f.dirichlet(x) * distortion.value(determinant / f.twice_area);
  }
  return energy;
}

/// Whether all faces of the star with centre x are positively oriented, exactly.
inline bool is_valid_centre(const Star& star, vec3 x)
{
  return std::all_of(star.begin(), star.end(), [x](const Star_face& f) { return is_positively_oriented(x, f.j, f.k); });
}

/// The solution s of |H| s = -g, |H| the symmetric matrix with the absolute eigenvalues of H (and none much smaller
/// than the other): a descent direction, and Newton's if H is positive definite.
inline void solve_positive(double h11, double h12, double h22, double g1, double g2, double& s1, double& s2)
{
  constexpr double smallest_share = 1e-3;
  const double mean = (h11 + h22) / 2, half = (h11 - h22) / 2;
  const double split = std::sqrt(half * half + h12 * h12);
  const double largest = std::abs(mean) + split;
  if(mean - split > 1e-6 * largest) {
    const double determinant = h11 * h22 - h12 * h12;
    s1 = (h12 * g2 - h22 * g1) / determinant;
    s2 = (h12 * g1 - h11 * g2) / determinant;
    return;
  }
  // (c, d): unit eigenvector of mean + split
  double c = half >= 0 ? split + half : h12, d = half >= 0 ? h12 : split - half;
  const double norm = std::sqrt(c * c + d * d);
  c = norm > 0 ? c / norm : 1;
  d = norm > 0 ? d / norm : 0;
  const double a = -(c * g1 + d * g2) / (std::max)(std::abs(mean + split), smallest_share * largest);
  const double b = -(c * g2 - d * g1) / (std::max)(std::abs(mean - split), smallest_share * largest);
  s1 = c * a - d * b;
  s2 = d * a + c * b;
}

/// One step of Newton's method for the centre x of a star, along a geodesic tangent and back to the sphere. It is
/// taken only if the energy falls (Armijo) and all faces stay positively oriented, by the exact predicate: a valid
/// star stays valid. `energy` is that of the star, on entry and on return.
/// Returns by how much it fell; 0 if there was no step.
inline double relax_centre(const Distortion& distortion, const Star& star, vec3& x, double& energy)
{
  constexpr double share_of_the_way_to_a_flip = 0.8, armijo = 1e-4;
  constexpr int maximum_halvings = 12;
  const Tangents tangents(x);
  double g1 = 0, g2 = 0, h11 = 0, h12 = 0, h22 = 0, radial = 0;
  for(const Star_face& f : star) {
    const vec3 a = sub(f.j, x), b = sub(f.k, x), c = sub(f.k, f.j);
    const double determinant = inner(x, outer(a, b));
    const double dirichlet = (f.cot_x * inner(c, c) + f.cot_j * inner(b, b) + f.cot_k * inner(a, a)) / 2;
    const Distortion::Psi psi = distortion.psi(determinant / f.twice_area);
    const double slope = psi.first / f.twice_area, bend = dirichlet * psi.second / (f.twice_area * f.twice_area);
    // gradients of the two factors: L' and d'
    const vec3 pull = add_scaled(scale(-f.cot_j, b), -f.cot_k, a), turn = outer(f.j, f.k);
    const double l1 = inner(pull, tangents.s), l2 = inner(pull, tangents.t);
    const double d1 = inner(turn, tangents.s), d2 = inner(turn, tangents.t);
    const double stiffness = (f.cot_j + f.cot_k) * psi.value;
    g1 += psi.value * l1 + dirichlet * slope * d1;
    g2 += psi.value * l2 + dirichlet * slope * d2;
    radial += psi.value * inner(pull, x) + dirichlet * slope * determinant;
    h11 += stiffness + 2 * slope * l1 * d1 + bend * d1 * d1;
    h22 += stiffness + 2 * slope * l2 * d2 + bend * d2 * d2;
    h12 += slope * (l1 * d2 + l2 * d1) + bend * d1 * d2;
  }
  double s1, s2;
  solve_positive(h11 - radial, h12, h22 - radial, g1, g2, s1, s2);
  const double descent = g1 * s1 + g2 * s2;
  if(!(descent < 0))
    return 0;
  const vec3 step = add_scaled(scale(s1, tangents.s), s2, tangents.t);
  double t = 1;
  for(const Star_face& f : star) { // the determinants are linear along the step
    const double slope = inner(step, outer(f.j, f.k));
    if(slope < 0)
      t = (std::min)(t, -share_of_the_way_to_a_flip * f.determinant(x) / slope);
  }
  for(int halving = 0; halving < maximum_halvings; ++halving, t /= 2) {
    const vec3 y = unit(add_scaled(x, t, step));
    const double next = star_energy(distortion, star, y);
    if(next <= energy + armijo * t * descent && is_valid_centre(star, y)) {
      const double gain = energy - next;
      x = y;
      energy = next;
      return gain;
    }
  }
  return 0;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_STAR_H
