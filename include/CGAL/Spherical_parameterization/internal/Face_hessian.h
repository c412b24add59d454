// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FACE_HESSIAN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FACE_HESSIAN_H

#include <CGAL/Spherical_parameterization/internal/Distortion.h>
#include <CGAL/Spherical_parameterization/internal/Star.h>
#include <CGAL/Spherical_parameterization/internal/vertex_formulas.h>

#include <cmath>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// A vector in a tangent plane, or its product with tangents.
struct Planar {
  double s, t;
};

/// 2x2, by rows
struct Block {
  double ss, st, ts, tt;
};

inline Block transposed(const Block& b) { return {b.ss, b.ts, b.st, b.tt}; }

inline Block product(const Block& a, const Block& b)
{
  return {a.ss * b.ss + a.st * b.ts, a.ss * b.st + a.st * b.tt, a.ts * b.ss + a.tt * b.ts, a.ts * b.st + a.tt * b.tt};
}

/// The second derivative of the distortion of a face by the positions of its corners, made positive semidefinite: the
/// chordal triangle in its plane, with the eigensystem of B. Smith, F. de Goes, T. Kim, "Analytic eigensystems for
/// isotropic distortion energies", TOG 2019, its negative eigenvalues set to zero. The four eigenvectors are a twist, a
/// flip, and two stretches along the principal directions.
class Face_hessian {
public:
  /// \pre the triangle x, f.j, f.k is not degenerate
  Face_hessian(const Distortion& distortion, vec3 x, const Star_face& f)
  {
    // The source triangle in the plane, its first side on the first axis, and the gradients of its hat functions.
    const double side = std::sqrt(f.twice_area * (f.cot_x + f.cot_j));
    const double apex_x = f.twice_area * f.cot_x / side, apex_y = f.twice_area / side;
    const double gradient[3][2] = {{-1 / side, apex_x / (side * apex_y) - 1 / apex_y},
                                   {1 / side, -apex_x / (side * apex_y)},
                                   {0, 1 / apex_y}};
    // The image triangle in its plane, and the linear map (a, b; 0, d).
    const vec3 first = sub(f.j, x), second = sub(f.k, x), normal = unit(outer(first, second));
    const double length = std::sqrt(inner(first, first));
    const vec3 p = scale(1 / length, first), q = outer(normal, p);
    const double a = length / side, b = length * gradient[1][1] + inner(second, p) / apex_y;
    const double d = inner(second, q) / apex_y;

    // Its singular values and vectors.
    const double xx = a * a, xy = a * b, yy = b * b + d * d;
    const double half = (xx - yy) / 2, split = std::sqrt(half * half + xy * xy);
    double v1 = half >= 0 ? split + half : xy, v2 = half >= 0 ? xy : split - half;
    const double norm = std::sqrt(v1 * v1 + v2 * v2);
    v1 = norm > 0 ? v1 / norm : 1;
    v2 = norm > 0 ? v2 / norm : 0;
    const double large = std::sqrt((xx + yy) / 2 + split), small = a * d / large;
    const double u1 = (a * v1 + b * v2) / large, u2 = d * v2 / large;
    axis_[0] = add_scaled(scale(u1, p), u2, q);
    axis_[1] = add_scaled(scale(-u2, p), u1, q);
    for(int k = 0; k < 3; ++k) {
      gradient_[k].s = gradient[k][0] * v1 + gradient[k][1] * v2;
      gradient_[k].t = -gradient[k][0] * v2 + gradient[k][1] * v1;
    }

    const Distortion::Psi psi = distortion.psi(large * small);
    const double sum = large * large + small * small, area = f.twice_area / 2;
    const auto positive = [](double e) { return e > 0 ? e : 0; };
    const double twist = positive(2 * psi.value + sum * psi.first), flip = positive(2 * psi.value - sum * psi.first);
    shear_ = area * (flip + twist) / 2;
    exchange_ = area * (flip - twist) / 2;
    const double common = 2 * psi.value + 4 * large * small * psi.first;
    double s11 = common + sum * small * small * psi.second, s22 = common + sum * large * large * psi.second;
    double s12 = 3 * sum * psi.first + sum * large * small * psi.second;
    const double mean = (s11 + s22) / 2, spread = std::sqrt((s11 - s22) * (s11 - s22) / 4 + s12 * s12);
    if(mean - spread < 0) { // keep the larger eigenvalue only
      const double e = positive(mean + spread), c = spread > 0 ? (s11 - s22) / (4 * spread) : 0;
      s11 = e * (0.5 + c);
      s22 = e * (0.5 - c);
      s12 = spread > 0 ? e * s12 / (2 * spread) : 0;
    }
    stretch_[0] = area * s11;
    stretch_[1] = area * s22;
    coupling_ = area * s12;
  }

  /// The principal directions of the image in terms of the tangents (s, t) at a corner.
  Block frame(vec3 s, vec3 t) const
  {
    return {inner(axis_[0], s), inner(axis_[0], t), inner(axis_[1], s), inner(axis_[1], t)};
  }

  /// The block of the corners m and n, whose frames are given.
  Block block(int m, const Block& frame_m, int n, const Block& frame_n) const
  {
    const Planar g = gradient_[m], h = gradient_[n];
    const Block principal = {stretch_[0] * g.s * h.s + shear_ * g.t * h.t, coupling_ * g.s * h.t + exchange_ * g.t * h.s,
                             coupling_ * g.t * h.s + exchange_ * g.s * h.t, stretch_[1] * g.t * h.t + shear_ * g.s * h.s};
    return product(transposed(frame_m), product(principal, frame_n));
  }

private:
  vec3 axis_[2];       ///< principal directions of the image
  Planar gradient_[3]; ///< of the hat functions, along those of the source
  double stretch_[2], coupling_, shear_, exchange_;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_FACE_HESSIAN_H
