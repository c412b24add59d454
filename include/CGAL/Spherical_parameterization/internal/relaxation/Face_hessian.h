// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_FACE_HESSIAN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_FACE_HESSIAN_H

#include <CGAL/Spherical_parameterization/internal/relaxation/Distortion.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// 2x2, by rows
struct Block {
  double ss, st, ts, tt;
};

inline Block transposed(const Block& b) { return {b.ss, b.ts, b.st, b.tt}; }

inline Block product(const Block& a, const Block& b)
{
  return {a.ss * b.ss + a.st * b.ts, a.ss * b.st + a.st * b.tt, a.ts * b.ss + a.tt * b.ts, a.ts * b.st + a.tt * b.tt};
}

/// The second derivative of the energy of a face by the positions of its corners. Per source area the energy is
/// (s^2 + t^2) psi(J) + phi(J), see `Distortion`; in terms of L and d = det, see `Star_face`, its second derivative is
///   psi L'' + psi' (L' d' + d' L') + L psi'' d' d' + L psi' d'',  and phi'' d' d' + phi' d''.
///
/// A share `lift` of what would make it indefinite is taken off: the negative eigenvalues of the same for the flat
/// triangle, whose eigensystem is known (B. Smith, F. de Goes, T. Kim, "Analytic eigensystems for isotropic distortion
/// energies", TOG 2019): a twist, a flip, and two stretches along the principal directions. What the curvature of the
/// sphere adds is kept, since it matters on coarse levels; so that the sum over the faces is not positive for certain,
/// even with `lift` = 1.
class Face_hessian {
public:
  /// Tangents at a corner, and what they are to the face.
  struct Frame {
    Tangents tangents;
    Block axes;        ///< principal directions of the image times tangents
    Planar pull, turn; ///< L' and d'
  };

  /// The face may be flipped, where psi and phi are finite there.
  template <class Energy>
  Face_hessian(const Energy& energy, vec3 x, const Star_face& f, double lift)
    : x_{x, f.j, f.k}, cotangent_{f.cot_x, f.cot_j, f.cot_k}
  {
    const double determinant = f.determinant(x), dirichlet = f.dirichlet(x);
    const double ratio = determinant / f.twice_area;
    const Distortion::Psi psi = energy.psi(ratio), phi = energy.phi(ratio);
    psi_ = psi.value;
    slope_ = psi.first / f.twice_area;
    twist_force_ = dirichlet * slope_ + phi.first / 2;
    bend_ = dirichlet * psi.second / (f.twice_area * f.twice_area) + phi.second / (2 * f.twice_area);
    value_ = dirichlet * psi.value + f.twice_area / 2 * phi.value;
    for(int k = 0; k < 3; ++k) {
      const int m = (k + 1) % 3, n = (k + 2) % 3;
      pull_[k] = add_scaled(scale(-cotangent_[m], sub(x_[n], x_[k])), -cotangent_[n], sub(x_[m], x_[k]));
      turn_[k] = outer(x_[m], sub(x_[n], x_[m])); // exact relative to the size of the triangle
    }
    is_lifted_ = lift > 0;
    if(is_lifted_)
      analyse_flat_triangle(energy, f, dirichlet, lift);
  }

  double value() const { return value_; } ///< of the energy

  vec3 gradient(int corner) const { return add_scaled(scale(psi_, pull_[corner]), twist_force_, turn_[corner]); }

  Frame frame(int corner, const Tangents& at) const
  {
    Block axes = {};
    if(is_lifted_)
      axes = {inner(axis_[0], at.s), inner(axis_[0], at.t), inner(axis_[1], at.s), inner(axis_[1], at.t)};
    return {at, axes, at.products(pull_[corner]), at.products(turn_[corner])};
  }

  /// The block of the corners m and n, but for what the bending of the sphere adds to diagonal ones.
  Block block(int m, const Frame& a, int n, const Frame& b) const
  {
    Block result = is_lifted_ ? lift(m, a.axes, n, b.axes) : Block{0, 0, 0, 0};
    double stiffness, force = 0;
    vec3 apex = {0, 0, 0};
    if(m == n)
      stiffness = psi_ * (cotangent_[(m + 1) % 3] + cotangent_[(m + 2) % 3]);
    else {
      stiffness = -psi_ * cotangent_[3 - m - n];
      force = (n - m + 3) % 3 == 1 ? twist_force_ : -twist_force_;
      apex = x_[3 - m - n];
    }
    const auto [as, at] = a.tangents;
    const auto [bs, bt] = b.tangents;
    const vec3 turned_s = outer(bs, apex), turned_t = outer(bt, apex);
    const auto exact = [&](vec3 u, double pull_u, double turn_u, vec3 v, double pull_v, double turn_v, vec3 turned) {
      return slope_ * (pull_u * turn_v + turn_u * pull_v) + bend_ * turn_u * turn_v + stiffness * inner(u, v) +
             force * inner(u, turned);
    };
    result.ss += exact(as, a.pull.s, a.turn.s, bs, b.pull.s, b.turn.s, turned_s);
    result.st += exact(as, a.pull.s, a.turn.s, bt, b.pull.t, b.turn.t, turned_t);
    result.ts += exact(at, a.pull.t, a.turn.t, bs, b.pull.s, b.turn.s, turned_s);
    result.tt += exact(at, a.pull.t, a.turn.t, bt, b.pull.t, b.turn.t, turned_t);
    return result;
  }

private:
  /// What makes the block positive
  Block lift(int m, const Block& axes_m, int n, const Block& axes_n) const
  {
    const Planar g = gradient_[m], h = gradient_[n];
    const Block principal = {
      stretch_[0] * g.s * h.s + shear_ * g.t * h.t, coupling_ * g.s * h.t + exchange_ * g.t * h.s,
      coupling_ * g.t * h.s + exchange_ * g.s * h.t, stretch_[1] * g.t * h.t + shear_ * g.s * h.s};
    return product(transposed(axes_m), product(principal, axes_n));
  }

  /// The negative eigenvalues of the flat triangle, if there are any, and their eigenvectors.
  template <class Energy>
  void analyse_flat_triangle(const Energy& energy, const Star_face& f, double dirichlet, double share)
  {
    const vec3 first = sub(x_[1], x_[0]), second = sub(x_[2], x_[0]), area_vector = outer(first, second);
    const double absolute_area = std::sqrt(inner(area_vector, area_vector));
    const double twice_area = inner(area_vector, x_[0]) < 0 ? -absolute_area : absolute_area;
    is_lifted_ = absolute_area > 0;
    if(!is_lifted_)
      return;
    // the determinant and the sum of the squares of the singular values, and the eigenvalues
    const double ratio = twice_area / f.twice_area, sum = 2 * dirichlet / f.twice_area;
    const Distortion::Psi psi = energy.psi(ratio), phi = energy.phi(ratio);
    const double slope = sum * psi.first + phi.first;
    const auto excess = [](double e) { return e < 0 ? -e : 0; };
    const double twist = excess(2 * psi.value + slope), flip = excess(2 * psi.value - slope);
    const double common = 2 * psi.value + 4 * ratio * psi.first;
    const double mean = common + sum * sum * psi.second / 2 + sum * phi.second / 2;
    const double half = std::sqrt((std::max)(0., sum * sum / 4 - ratio * ratio)); // of the difference of the squares
    const double s12 = 3 * sum * psi.first + sum * ratio * psi.second + phi.first + ratio * phi.second;
    const double s_half = -half * sum * psi.second - half * phi.second;
    const double spread = std::sqrt(s_half * s_half + s12 * s12);
    const double lift = excess(mean - spread), lift_all = excess(mean + spread); // of the smaller one, and of both
    is_lifted_ = twist > 0 || flip > 0 || lift > 0;
    if(!is_lifted_)
      return;
    const double area = share * f.twice_area / 2;
    shear_ = area * (flip + twist) / 2;
    exchange_ = area * (flip - twist) / 2;
    const double both = area * (lift + lift_all) / 2, one = spread > 0 ? area * (lift - lift_all) / (2 * spread) : 0;
    stretch_[0] = both - one * s_half;
    stretch_[1] = both + one * s_half;
    coupling_ = -one * s12;

    // The source triangle in the plane, its first side on the first axis, and the gradients of its hat functions.
    const double side = std::sqrt(f.twice_area * (f.cot_x + f.cot_j));
    const double apex_x = f.twice_area * f.cot_x / side, apex_y = f.twice_area / side;
    const double gradient[3][2] = {
      {-1 / side, apex_x / (side * apex_y) - 1 / apex_y}, {1 / side, -apex_x / (side * apex_y)}, {0, 1 / apex_y}};
    // The image triangle in its plane, and the linear map (a, b; 0, d).
    const double length = std::sqrt(inner(first, first));
    const vec3 p = scale(1 / length, first), q = outer(scale(1 / twice_area, area_vector), p);
    const double a = length / side, b = length * gradient[1][1] + inner(second, p) / apex_y;
    const double d = inner(second, q) / apex_y;

    // Its singular vectors.
    const double xx = a * a, xy = a * b, yy = b * b + d * d;
    const double h = (xx - yy) / 2, split = std::sqrt(h * h + xy * xy);
    const auto [v1, v2] = principal_axis(h, xy, split);
    const double large = std::sqrt((xx + yy) / 2 + split);
    const double u1 = (a * v1 + b * v2) / large, u2 = d * v2 / large;
    axis_[0] = add_scaled(scale(u1, p), u2, q);
    axis_[1] = add_scaled(scale(-u2, p), u1, q);
    for(int k = 0; k < 3; ++k)
      gradient_[k] = {gradient[k][0] * v1 + gradient[k][1] * v2, -gradient[k][0] * v2 + gradient[k][1] * v1};
  }

  vec3 x_[3];
  double cotangent_[3];
  vec3 pull_[3], turn_[3];
  double psi_, slope_, twist_force_, bend_, value_;
  bool is_lifted_;     ///< there are negative eigenvalues; else the rest is not set
  vec3 axis_[2];       ///< principal directions of the image
  Planar gradient_[3]; ///< of the hat functions, along those of the source
  double stretch_[2], coupling_, shear_, exchange_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_FACE_HESSIAN_H
