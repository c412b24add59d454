// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_FACE_HESSIAN_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_FACE_HESSIAN_H

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

inline Block sum(const Block& a, const Block& b) { return {a.ss + b.ss, a.st + b.st, a.ts + b.ts, a.tt + b.tt}; }
inline Block scaled(double r, const Block& a) { return {r * a.ss, r * a.st, r * a.ts, r * a.tt}; }
inline Planar scaled(double r, Planar a) { return {r * a.s, r * a.t}; }
inline Block outer(Planar a, Planar b) { return {a.s * b.s, a.s * b.t, a.t * b.s, a.t * b.t}; }

/// What the gradient of the energy of a face is made of.
struct Face_gradient {
  double of_dirichlet, of_determinant; ///< derivatives of the energy by L and d, see `Star_face`

  /// By the first corner, which is at x.
  vec3 at(vec3 x, const Star_face& f) const
  {
    const vec3 a = sub(f.j, x), b = sub(f.k, x);
    return add_scaled(add_scaled(scale(-of_dirichlet * f.cot_j, b), -of_dirichlet * f.cot_k, a), of_determinant,
                      outer(f.j, sub(f.k, f.j)));
  }
};

/// The second derivative of the energy of a face by the positions of its corners. Per source area the energy is
/// (s^2 + t^2) psi(J) + phi(J), see `Distortion`; in terms of L and d = det, see `Star_face`, its second derivative is
///   psi L'' + psi' (L' d' + d' L') + L psi'' d' d' + L psi' d'',  and phi'' d' d' + phi' d''.
///
/// A multiple `lift` of what would make it indefinite is taken off, 1 for all of it, 2 for absolute values (H. Chen, H.
/// Liu, D. Levin, C. Zheng, A. Jacobson, "Stabler neo-Hookean simulation: absolute eigenvalue filtering for projected
/// Newton", SIGGRAPH 2024): the negative eigenvalues of the same for the flat triangle, whose eigensystem is known (B.
/// Smith, F. de Goes, T. Kim, "Analytic eigensystems for isotropic distortion energies", TOG 2019): a twist, a flip,
/// and two stretches along the principal directions. What the curvature of the sphere adds is kept, since it matters on
/// coarse levels; so that the sum over the faces is not positive for certain, whatever is taken off.
class Face_hessian {
  /// The eigenvectors of what is taken off, times the roots of their negative eigenvalues
  static constexpr int most_modes = 4;

public:
  /// What tangents at a corner are to the face
  struct Frame {
    Tangents tangents;
    Planar turn, pull; ///< products with d', and with what goes with it: slope L' + bend / 2 d'
    Planar mode[most_modes];
  };

  /// The face may be flipped, where psi and phi are finite there.
  template <class Energy>
  Face_hessian(const Energy& energy, vec3 x, const Star_face& f, double lift)
    : x_{x, f.j, f.k}, cotangent_{f.cot_x, f.cot_j, f.cot_k}
  {
    const double determinant = f.determinant(x), dirichlet = f.dirichlet(x), inverse = 1 / f.twice_area;
    const double ratio = determinant * inverse;
    const Distortion::Psi psi = energy.psi(ratio), phi = energy.phi(ratio, psi);
    psi_ = psi.value;
    slope_ = psi.first * inverse;
    twist_force_ = dirichlet * slope_ + phi.first / 2;
    half_bend_ = (dirichlet * psi.second * inverse + phi.second / 2) * inverse / 2;
    lacking_bend_ = (std::max)(0., 2 * (dirichlet * slope_ * slope_ / psi_ - half_bend_));
    value_ = dirichlet * psi.value + f.twice_area / 2 * phi.value;
    for(int k = 0; k < 3; ++k) {
      const int m = (k + 1) % 3, n = (k + 2) % 3;
      pull_[k] = add_scaled(scale(-cotangent_[m], sub(x_[n], x_[k])), -cotangent_[n], sub(x_[m], x_[k]));
      turn_[k] = outer(x_[m], sub(x_[n], x_[m])); // exact relative to the size of the triangle
    }
    if(lift > 0)
      analyse_flat_triangle(energy, {ratio, psi, phi}, f.twice_area, 2 * dirichlet * inverse, lift);
  }

  double value() const { return value_; } ///< of the energy

  Face_gradient gradient() const { return {psi_, twist_force_}; }
  vec3 gradient(int corner) const { return add_scaled(scale(psi_, pull_[corner]), twist_force_, turn_[corner]); }

  Frame frame(int corner, const Tangents& at) const
  {
    Frame result;
    result.tangents = at;
    result.turn = at.products(turn_[corner]);
    result.pull = at.products(add_scaled(scale(slope_, pull_[corner]), half_bend_, turn_[corner]));
    for(int k = 0; k < modes_; ++k)
      result.mode[k] = at.products(mode_[k][corner]);
    return result;
  }

  /// The block of the corners m and n, but for what the bending of the sphere adds to diagonal ones.
  Block block(int m, const Frame& a, int n, const Frame& b) const { return sum(exact_block(m, a, n, b), lift(a, b)); }

  /// ... if nothing is taken off
  Block exact_block(int m, const Frame& a, int n, const Frame& b) const
  {
    return sum(sum(combination(psi_, twist_force_, m, a, n, b), outer(a.turn, b.pull)), outer(a.pull, b.turn));
  }

  /// What is taken off makes this difference: little more than needed.
  Block lift(const Frame& a, const Frame& b) const
  {
    Block result = {0, 0, 0, 0};
    for(int k = 0; k < modes_; ++k)
      result = sum(result, outer(a.mode[k], b.mode[k]));
    return result;
  }

  /// More than needed, and of a flat triangle enough, for psi > 0: without eigenvectors, at half the cost, and stiffer.
  /// psi L'' + psi' (L' d' + d' L') + 2 psi'^2 / psi L d' d' is not negative. What there is less of d' d' is added, and
  /// |f| (L'' - d'') / 2 or |f| (L'' + d'') / 2 to f d'': L'' +- d'' are not negative, since L >= |d|.
  Block stiff_lift(int m, const Frame& a, int n, const Frame& b) const
  {
    const double share = std::abs(twist_force_) / 2;
    return sum(combination(share, twist_force_ < 0 ? share : -share, m, a, n, b),
               outer(scaled(lacking_bend_, a.turn), b.turn));
  }

private:
  /// The block of r L'' + q d''
  Block combination(double r, double q, int m, const Frame& a, int n, const Frame& b) const
  {
    if(m == n) {
      const double stiffness = r * (cotangent_[(m + 1) % 3] + cotangent_[(m + 2) % 3]);
      return {stiffness, 0, 0, stiffness};
    }
    const double stiffness = -r * cotangent_[3 - m - n];
    const vec3 force = scale((n - m + 3) % 3 == 1 ? q : -q, x_[3 - m - n]);
    const auto [s, t] = b.tangents;
    const Planar by_s = a.tangents.products(add_scaled(outer(s, force), stiffness, s));
    const Planar by_t = a.tangents.products(add_scaled(outer(t, force), stiffness, t));
    return {by_s.s, by_t.s, by_s.t, by_t.t};
  }

  /// What the energy depends on the area by
  struct Dependence {
    double ratio; ///< J
    Distortion::Psi psi, phi;
  };

  /// The negative eigenvalues of the flat triangle, if there are any, and their eigenvectors. The determinant of a
  /// needle that goes far round the sphere is much smaller than its area, with which large exponents would make it so
  /// stiff that nothing moves: where psi is smaller at the determinant, the energy is that of the determinant.
  /// \param of_determinant  the dependence at the determinant
  /// \param squares  the sum of the squares of its singular values
  template <class Energy>
  void analyse_flat_triangle(const Energy& energy, const Dependence& of_determinant, double source_twice_area,
                             double squares, double lift)
  {
    const vec3 first = sub(x_[1], x_[0]), second = sub(x_[2], x_[0]), area_vector = outer(first, second);
    const double absolute_area = std::sqrt(inner(area_vector, area_vector));
    if(!(absolute_area > 0))
      return;
    const double twice_area = inner(area_vector, x_[0]) < 0 ? -absolute_area : absolute_area;
    const double inverse = 1 / source_twice_area, flat_ratio = twice_area * inverse;
    const Distortion::Psi flat_psi = energy.psi(flat_ratio);
    const bool is_too_stiff = of_determinant.ratio > 0 && flat_psi.value > of_determinant.psi.value;
    const auto [ratio, psi, phi] =
      is_too_stiff ? of_determinant : Dependence{flat_ratio, flat_psi, energy.phi(flat_ratio, flat_psi)};
    const double slope = squares * psi.first + phi.first;
    const double twist = 2 * psi.value + slope, flip = 2 * psi.value - slope;
    const double mean = 2 * psi.value + 4 * ratio * psi.first + squares * (squares * psi.second + phi.second) / 2;
    const auto half_difference = [squares](double product) { // of the squares
      return std::sqrt((std::max)(0., squares * squares / 4 - product * product));
    };
    const double half = half_difference(ratio);
    const double s12 = 3 * squares * psi.first + squares * ratio * psi.second + phi.first + ratio * phi.second;
    const double s_half = -half * (squares * psi.second + phi.second);
    const double spread = std::sqrt(s_half * s_half + s12 * s12);
    if(!(twist < 0 || flip < 0 || mean < spread))
      return;

    // The principal direction of the image with the larger singular value, from the products of the sides with the
    // pulls, which are those of the linear map with itself; the source triangle itself is not needed.
    const double length = std::sqrt(inner(first, first));
    const vec3 p = scale(1 / length, first), q = outer(scale(1 / twice_area, area_vector), p);
    const double along = inner(second, p), height = twice_area / length;
    const Planar pull_1 = {inner(pull_[1], p), inner(pull_[1], q)}, pull_2 = {inner(pull_[2], p), inner(pull_[2], q)};
    const double pp = length * pull_1.s + along * pull_2.s, pq = length * pull_1.t + along * pull_2.t;
    const double h = (pp - height * pull_2.t) / 2;
    const auto [c, d] = principal_axis(h, pq, std::sqrt(h * h + pq * pq));
    const vec3 large = add_scaled(scale(c, p), d, q), small = add_scaled(scale(-d, p), c, q);

    // The derivatives of the hat functions in the source, along its principal directions
    const double scale_of_hats = inverse / std::sqrt(squares / 2 + half_difference(flat_ratio));
    Planar hat[3];
    for(int k = 0; k < 3; ++k)
      hat[k] =
        scaled(scale_of_hats, Planar{2 * inner(large, pull_[k]), inner(large, sub(x_[(k + 2) % 3], x_[(k + 1) % 3]))});

    // A mode is a change of the linear map between principal directions, by rows.
    const auto add_mode = [&](double eigenvalue, const Block& change) {
      if(!(eigenvalue < 0))
        return;
      const double root = std::sqrt(-eigenvalue * lift * source_twice_area / 2);
      for(int k = 0; k < 3; ++k) {
        const Planar g = scaled(root, hat[k]);
        mode_[modes_][k] =
          add_scaled(scale(change.ss * g.s + change.st * g.t, large), change.ts * g.s + change.tt * g.t, small);
      }
      ++modes_;
    };
    constexpr double root_of_half = 0.7071067811865476;
    add_mode(twist, {0, root_of_half, -root_of_half, 0});
    add_mode(flip, {0, root_of_half, root_of_half, 0});
    const Planar stretch = principal_axis(s_half, s12, spread);
    add_mode(mean + spread, {stretch.s, 0, 0, stretch.t});
    add_mode(mean - spread, {-stretch.t, 0, 0, stretch.s});
  }

  vec3 x_[3];
  double cotangent_[3];
  vec3 pull_[3], turn_[3]; ///< L' and d'
  double psi_, slope_, twist_force_, half_bend_, lacking_bend_, value_;
  int modes_ = 0;
  vec3 mode_[most_modes][3];
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_FACE_HESSIAN_H
