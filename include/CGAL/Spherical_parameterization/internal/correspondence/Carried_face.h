// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_CARRIED_FACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_CARRIED_FACE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// A triangle in space at its corner i, and what it becomes where its corners are carried elsewhere: the symmetric
/// Dirichlet energy s^2 + t^2 + 1/s^2 + 1/t^2 of that linear map with the singular values s and t, at least 4, which is
/// isometric. It stays finite: triangles may fold, since their corners are on a surface and they are not.
class Carried_face {
public:
  /// i, j, k: the corners as they are; y: where they are carried.
  Carried_face(vec3 i, vec3 j, vec3 k, vec3 yi, vec3 yj, vec3 yk) : to_j_(sub(yj, yi)), to_k_(sub(yk, yi))
  {
    const vec3 a = sub(j, i), b = sub(k, i);
    jj_ = inner(a, a);
    jk_ = inner(a, b);
    kk_ = inner(b, b);
    square_ = jj_ * kk_ - jk_ * jk_;
    const double yjj = inner(to_j_, to_j_), yjk = inner(to_j_, to_k_), ykk = inner(to_k_, to_k_);
    const double carried = (std::max)(0., yjj * ykk - yjk * yjk);
    trace_ = (yjj * kk_ - 2 * yjk * jk_ + ykk * jj_) / square_;
    determinant_ = std::sqrt(carried / square_);
  }

  /// Of triangles without area nothing is asked.
  bool counts() const { return square_ > 0 && trace_ < largest_stretch * largest_stretch; }
  double area() const { return std::sqrt(square_) / 2; }
  double energy() const { return counts() ? area() * trace_ * psi() : 0; }

  /// By the places of the carried corners i, j and k.
  std::array<vec3, 3> gradients() const
  {
    if(!counts())
      return {};
    const double by_trace = 2 * area() * psi() / square_;
    vec3 j = scale(by_trace, add_scaled(scale(kk_, to_j_), -jk_, to_k_)),
         k = scale(by_trace, add_scaled(scale(jj_, to_k_), -jk_, to_j_));
    if(determinant_ > least_determinant) {
      const double determinant_2 = determinant_ * determinant_;
      const double by_square = -2 * area() * trace_ / (determinant_2 * determinant_2 * square_);
      const double yjj = inner(to_j_, to_j_), yjk = inner(to_j_, to_k_), ykk = inner(to_k_, to_k_);
      j = add_scaled(j, by_square, add_scaled(scale(ykk, to_j_), -yjk, to_k_));
      k = add_scaled(k, by_square, add_scaled(scale(yjj, to_k_), -yjk, to_j_));
    }
    return {scale(-1, add(j, k)), j, k};
  }

private:
  static constexpr double least_determinant = 0.2, largest_stretch = 30;

  double psi() const
  {
    const double determinant = (std::max)(determinant_, least_determinant);
    return 1 + 1 / (determinant * determinant);
  }

  vec3 to_j_, to_k_;
  double jj_, jk_, kk_, square_, trace_, determinant_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_CARRIED_FACE_H
