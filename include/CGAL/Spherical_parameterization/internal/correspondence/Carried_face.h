// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_CARRIED_FACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_CARRIED_FACE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Face_hessian.h>

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

  /// What the second derivative is without what is negative of it: the sum of weight outer(corner, corner), with
  /// vectors by the places of the carried corners. The eigensystem is known (B. Smith, F. de Goes, T. Kim, "Analytic
  /// eigensystems for isotropic distortion energies", TOG 2019): two stretches, a twist and a flip in the plane of the
  /// triangle, and two turns out of it. Calls f(weight, corners).
  template <class F>
  void for_each_mode(F f) const
  {
    if(!counts())
      return;
    // The linear map by columns, for orthonormal axes of the source, and the derivatives of the hat functions
    const double length = std::sqrt(jj_), along = jk_ / length, height = std::sqrt(square_) / length;
    const vec3 first = scale(1 / length, to_j_), second = scale(1 / height, add_scaled(to_k_, -along, first));
    const double h = (inner(first, first) - inner(second, second)) / 2, pq = inner(first, second);
    const auto [c, d] = principal_axis(h, pq, std::hypot(h, pq));
    const vec3 v = add_scaled(scale(c, first), d, second), w = add_scaled(scale(-d, first), c, second);
    const double s = norm(v), t = determinant_ / s;
    const vec3 area_vector = outer(v, w);
    const double image_area = norm(area_vector);
    if(!(image_area > 1e-12 * s * s))
      return;
    const vec3 large = scale(1 / s, v), up = scale(1 / image_area, area_vector), small = outer(up, large);
    const Planar of_j = {1 / length, -along / (length * height)}, of_k = {0, 1 / height};
    const auto along_axes = [&, c = c, d = d](Planar g) { return Planar{c * g.s + d * g.t, c * g.t - d * g.s}; };
    const Planar hat_j = along_axes(of_j), hat_k = along_axes(of_k);
    const auto mode = [&](double eigenvalue, auto change) {
      if(!(eigenvalue > 0))
        return;
      const vec3 j = change(hat_j), k = change(hat_k);
      f(eigenvalue * area(), std::array<vec3, 3>{scale(-1, add(j, k)), j, k});
    };
    const bool is_flat = !(determinant_ > least_determinant);
    const auto slope = [&](double x) { return is_flat ? 2 * psi() * x : 2 * x - 2 / (x * x * x); };
    const auto bend = [&](double x) { return is_flat ? 2 * psi() : 2 + 6 / (x * x * x * x); };
    const double flip = s - t > 1e-6 * s ? (slope(s) - slope(t)) / (s - t) : bend(s);
    constexpr double root = 0.7071067811865476;
    mode(bend(s), [&](Planar g) { return scale(g.s, large); });
    mode(bend(t), [&](Planar g) { return scale(g.t, small); });
    mode((slope(s) + slope(t)) / (s + t),
         [&](Planar g) { return add_scaled(scale(root * g.t, large), -root * g.s, small); });
    mode(flip, [&](Planar g) { return add_scaled(scale(root * g.t, large), root * g.s, small); });
    mode(slope(s) / s, [&](Planar g) { return scale(g.s, up); });
    mode(slope(t) / t, [&](Planar g) { return scale(g.t, up); });
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
