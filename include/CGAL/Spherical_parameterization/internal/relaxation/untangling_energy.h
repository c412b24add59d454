// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLING_ENERGY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLING_ENERGY_H

#include <CGAL/Spherical_parameterization/internal/relaxation/Distortion.h>

#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// An energy that is finite for flipped faces, and drives them to become positive: V. Garanzha, I. Kaporin, L.
/// Kudryavtseva, F. Protais, N. Ray, D. Sokolov, "Foldover-free maps in 50 lines of code", ACM Trans. Graph. 40 (2021).
/// Of a face with principal stretches s, t and J = s t, per area,
///   (s^2 + t^2 + 2 a (1 + J^2)) / chi(J),  chi(J) = (J + sqrt(e^2 + J^2)) / 2.
/// Without the share `a` of the areas it would be MIPS for e = 0, and lead faces to shrink to points for e > 0.
class Untangling_energy {
public:
  explicit Untangling_energy(double regularization) : e2_(regularization * regularization) {}

  /// 1 / chi and its derivatives
  Distortion::Psi psi(double ratio) const
  {
    const double root = std::sqrt(e2_ + ratio * ratio);
    const double chi = ratio > 0 ? (ratio + root) / 2 : e2_ / 2 / (root - ratio);
    const double first = chi / root, second = e2_ / (2 * root * root * root); // derivatives of chi
    const double value = 1 / chi;
    return {value, -first * value * value, (2 * first * first * value - second) * value * value};
  }

  /// The share of the areas and its derivatives. \param psi  of the same ratio
  Distortion::Psi phi(double ratio, const Distortion::Psi& psi) const
  {
    constexpr double share_of_areas = 0.05;
    const auto [value, first, second] = psi;
    const double areas = 2 * share_of_areas * (1 + ratio * ratio);
    const double slope = 4 * share_of_areas * ratio, bend = 4 * share_of_areas;
    return {areas * value, slope * value + areas * first, bend * value + 2 * slope * first + areas * second};
  }

private:
  double e2_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_UNTANGLING_ENERGY_H
