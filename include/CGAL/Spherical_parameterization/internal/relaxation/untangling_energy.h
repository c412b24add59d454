// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLING_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLING_ENERGY_H

#include <CGAL/Spherical_parameterization/internal/base/vec3.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// An energy that is finite for flipped faces, and drives them to become positive: V. Garanzha, I. Kaporin, L.
/// Kudryavtseva, F. Protais, N. Ray, D. Sokolov, "Foldover-free maps in 50 lines of code", ACM Trans. Graph. 40 (2021).
/// Of a face with determinant J and Dirichlet energy L, both relative to `Star_face::twice_area`, it is
///   (L + a (1 + J^2)) / chi(J),  chi(J) = (J + sqrt(e^2 + J^2)) / 2.
/// Without the share `a` of the areas it would be MIPS for e = 0, and lead faces to shrink to points for e > 0.
class Untangling_energy {
public:
  explicit Untangling_energy(double regularization) : e2_(regularization * regularization) {}

  /// Of the star with centre x
  double value(const Star& star, vec3 x) const
  {
    double sum = 0;
    for(const Star_face& f : star) {
      const double ratio = f.determinant(x) / f.twice_area;
      sum += (f.dirichlet(x) / f.twice_area + share_of_areas * (1 + ratio * ratio)) * weight(ratio).value;
    }
    return sum;
  }

  /// One step of Newton's method for the centre x of a star, as relax_centre() does it, that faces may be flipped by.
  /// `energy` is that of the star, on entry and on return. Returns by how much it fell.
  double relax_centre(const Star& star, vec3& x, double& energy) const
  {
    constexpr double armijo = 1e-4, longest_step = 0.5;
    constexpr int maximum_halvings = 12;
    const Tangents tangents = tangents_at(x);
    Planar gradient = {0, 0};
    double h11 = 0, h12 = 0, h22 = 0, radial = 0;
    for(const Star_face& f : star) {
      const double per_area = 1 / f.twice_area;
      const double ratio = per_area * f.determinant(x), dirichlet = per_area * f.dirichlet(x);
      const Distortion::Psi psi = weight(ratio);
      const double areas = 1 + ratio * ratio;
      // derivatives of the energy in the determinant, the Dirichlet energy held
      const double slope = dirichlet * psi.first + share_of_areas * (2 * ratio * psi.value + areas * psi.first);
      const double bend =
        dirichlet * psi.second + share_of_areas * (2 * psi.value + 4 * ratio * psi.first + areas * psi.second);
      const vec3 pull = scale(per_area, add_scaled(scale(-f.cot_j, sub(f.k, x)), -f.cot_k, sub(f.j, x)));
      const Planar l = tangents.products(pull), d = tangents.products(scale(per_area, outer(f.j, f.k)));
      const double stiffness = per_area * (f.cot_j + f.cot_k) * psi.value;
      gradient = add_scaled(add_scaled(gradient, psi.value, l), slope, d);
      radial += psi.value * inner(pull, x) + slope * ratio;
      h11 += stiffness + 2 * psi.first * l.s * d.s + bend * d.s * d.s;
      h22 += stiffness + 2 * psi.first * l.t * d.t + bend * d.t * d.t;
      h12 += psi.first * (l.s * d.t + l.t * d.s) + bend * d.s * d.t;
    }
    const Planar newton = solve_positive(h11 - radial, h12, h22 - radial, gradient);
    const double descent = inner(gradient, newton);
    if(!(descent < 0))
      return 0;
    const vec3 step = tangents.combined(newton);
    double t = (std::min)(1., longest_step / norm(step));
    for(int halving = 0; halving < maximum_halvings; ++halving, t /= 2) {
      const vec3 y = unit(add_scaled(x, t, step));
      const double next = value(star, y);
      if(next <= energy + armijo * t * descent) {
        const double gain = energy - next;
        x = y;
        energy = next;
        return gain;
      }
    }
    return 0;
  }

private:
  static constexpr double share_of_areas = 0.05;

  /// 1 / chi and its derivatives
  Distortion::Psi weight(double ratio) const
  {
    const double root = std::sqrt(e2_ + ratio * ratio);
    const double chi = ratio > 0 ? (ratio + root) / 2 : e2_ / 2 / (root - ratio);
    const double first = chi / root, second = e2_ / (2 * root * root * root); // derivatives of chi
    const double value = 1 / chi;
    return {value, -first * value * value, (2 * first * first * value - second) * value * value};
  }

  double e2_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLING_ENERGY_H
