// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_MOEBIUS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_MOEBIUS_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>

#include <Eigen/Dense>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline Eigen::Vector3d to_eigen(vec3 a) { return {a.x, a.y, a.z}; }
inline vec3 to_vec3(const Eigen::Vector3d& a) { return {a[0], a[1], a[2]}; }
inline Eigen::Vector3d first_moment(const Moments& m) { return {m.first[0], m.first[1], m.first[2]}; }

/// sum m_i, since the v_i are unit vectors
inline double total_mass(const Moments& m) { return m.second[0] + m.second[3] + m.second[5]; }

/// N = sum m_i P_i, the 3x3 matrix that turns a boost into the motion of the weighted centroid.
inline Eigen::Matrix3d boost_matrix(const Moments& m)
{
  const std::array<double, 6>& s = m.second;
  Eigen::Matrix3d n;
  n << s[3] + s[5], -s[1], -s[2], -s[1], s[0] + s[5], -s[4], -s[2], -s[4], s[0] + s[3];
  return n;
}

/// Boosts v until |sum m_i v_i| <= tolerance sum m_i, by at most so many steps of Newton's method in the ball, with
/// backtracking. `scratch` has the size of v; `moments` are those of v, on entry and on return.
template <class Backend>
void balance(const Backend& backend, const typename Backend::Scalars& mass, double tolerance, int maximum_steps,
             typename Backend::Vectors& v, typename Backend::Vectors& scratch, Moments& moments)
{
  constexpr int maximum_halvings = 30;
  constexpr double maximum_step = 0.9; // the ball ends at 1
  for(int it = 0; it < maximum_steps; ++it) {
    const double distance = first_moment(moments).norm();
    if(!(distance > tolerance * total_mass(moments)))
      return;
    Eigen::Vector3d c = boost_matrix(moments).ldlt().solve(first_moment(moments)) / 2;
    if(c.norm() > maximum_step)
      c *= maximum_step / c.norm();
    bool is_nearer = false;
    for(int h = 0; !is_nearer && h < maximum_halvings; ++h, c /= 2) {
      const Moments next = backend.transform(mass, to_vec3(c), v, scratch);
      is_nearer = first_moment(next).norm() < distance;
      if(is_nearer) {
        std::swap(v, scratch);
        moments = next;
      }
    }
    if(!is_nearer)
      return;
  }
}

/// Boosts v, unit vectors, until the centroid of `area` is at the centre of the sphere. `scratch` has the size of v.
template <class Backend>
void centre(const Backend& backend, const typename Backend::Scalars& area, typename Backend::Vectors& v,
            typename Backend::Vectors& scratch)
{
  constexpr int maximum_steps = 50;
  constexpr double tolerance = 1e-5;
  Moments moments = backend.moments(area, v);
  balance(backend, area, tolerance, maximum_steps, v, scratch, moments);
}

/// The Moebius transformation of orientation 1 (boosts and rotations) that brings `from` closest to `to` in the sense
/// of least squares, by the Gauss-Newton method from the best rotation; exact for three points. Returned as a sequence
/// of boosts, each followed by a rotation.
class Moebius_alignment {
public:
  Moebius_alignment(Host_array<vec3> from, const Host_array<vec3>& to)
  {
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for(std::size_t k = 0; k < from.size(); ++k)
      covariance += to_eigen(to[k]) * to_eigen(from[k]).transpose();
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Vector3d signs(1, 1, (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1);
    apply({Eigen::Vector3d::Zero(), svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose()}, from);

    constexpr int maximum_iterations = 100;
    double error = distance2(from, to);
    for(int it = 0; it < maximum_iterations && error > 1e-30 * from.size(); ++it) {
      const Eigen::Matrix<double, 6, 1> step = gauss_newton_step(from, to);
      bool is_nearer = false;
      for(double t = 1; !is_nearer && t > 1e-9; t /= 2) {
        Step candidate = {t * step.tail<3>(), rotation(t * step.head<3>())};
        if(candidate.centre.norm() >= 0.9)
          continue;
        Host_array<vec3> moved = from;
        for(vec3& p : moved)
          p = transformed(candidate, p);
        const double next = distance2(moved, to);
        is_nearer = next < error;
        if(is_nearer) {
          steps_.push_back(candidate);
          from = moved;
          error = next;
        }
      }
      if(!is_nearer)
        return;
    }
  }

  vec3 operator()(vec3 p) const
  {
    for(const Step& s : steps_)
      p = transformed(s, p);
    return p;
  }

private:
  struct Step {
    Eigen::Vector3d centre;
    Eigen::Matrix3d rotation;
  };

  static vec3 transformed(const Step& s, vec3 p)
  {
    return unit(to_vec3(s.rotation * to_eigen(boost(p, to_vec3(s.centre)))));
  }

  void apply(const Step& s, Host_array<vec3>& points)
  {
    steps_.push_back(s);
    for(vec3& p : points)
      p = transformed(s, p);
  }

  static Eigen::Matrix3d rotation(const Eigen::Vector3d& r)
  {
    const double angle = r.norm();
    return angle > 0 ? Eigen::AngleAxisd(angle, r / angle).toRotationMatrix() : Eigen::Matrix3d::Identity();
  }

  static double distance2(const Host_array<vec3>& a, const Host_array<vec3>& b)
  {
    double sum = 0;
    for(std::size_t k = 0; k < a.size(); ++k)
      sum += inner(sub(a[k], b[k]), sub(a[k], b[k]));
    return sum;
  }

  /// Rotation vector and boost centre, from d x = r x x - 2 P_x c.
  static Eigen::Matrix<double, 6, 1> gauss_newton_step(const Host_array<vec3>& from, const Host_array<vec3>& to)
  {
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for(std::size_t k = 0; k < from.size(); ++k) {
      const Eigen::Vector3d x = to_eigen(from[k]);
      Eigen::Matrix<double, 3, 6> j;
      j << 0, x[2], -x[1], 0, 0, 0, -x[2], 0, x[0], 0, 0, 0, x[1], -x[0], 0, 0, 0, 0;
      j.rightCols<3>() = -2 * (Eigen::Matrix3d::Identity() - x * x.transpose());
      normal += j.transpose() * j;
      right += j.transpose() * (to_eigen(to[k]) - x);
    }
    normal.diagonal().array() += 1e-12 * normal.trace();
    return normal.ldlt().solve(right);
  }

  std::vector<Step> steps_;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_MOEBIUS_H
