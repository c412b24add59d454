// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_ROTATIONS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_ROTATIONS_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// By rows.
typedef std::array<std::array<double, 3>, 3> Matrix_3;

inline vec3 rotated(const Matrix_3& r, vec3 p)
{
  const auto row = [&](int i) { return r[i][0] * p.x + r[i][1] * p.y + r[i][2] * p.z; };
  return {row(0), row(1), row(2)};
}

inline Matrix_3 product(const Matrix_3& a, const Matrix_3& b)
{
  Matrix_3 c = {};
  for(int i = 0; i < 3; ++i)
    for(int j = 0; j < 3; ++j)
      for(int k = 0; k < 3; ++k)
        c[i][j] += a[i][k] * b[k][j];
  return c;
}

inline Matrix_3 transposed(const Matrix_3& r)
{
  return {{{r[0][0], r[1][0], r[2][0]}, {r[0][1], r[1][1], r[2][1]}, {r[0][2], r[1][2], r[2][2]}}};
}

/// Of the quaternion w + x i + y j + z k, which need not be of length 1.
inline Matrix_3 rotation_of_quaternion(const std::array<double, 4>& q)
{
  const double s = 1 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  const auto twice = [&](int i, int j) { return 2 * s * q[i] * q[j]; };
  return {{{1 - twice(2, 2) - twice(3, 3), twice(1, 2) - twice(0, 3), twice(1, 3) + twice(0, 2)},
           {twice(1, 2) + twice(0, 3), 1 - twice(1, 1) - twice(3, 3), twice(2, 3) - twice(0, 1)},
           {twice(1, 3) - twice(0, 2), twice(2, 3) + twice(0, 1), 1 - twice(1, 1) - twice(2, 2)}}};
}

/// About the axis r by the angle |r|.
inline Matrix_3 rotation_about(vec3 r)
{
  const double angle = std::sqrt(inner(r, r));
  const double s = angle > 0 ? std::sin(angle / 2) / angle : 0;
  return rotation_of_quaternion({std::cos(angle / 2), s * r.x, s * r.y, s * r.z});
}

/// The eigenvector of the largest eigenvalue of a symmetric 4x4 matrix, by Jacobi's rotations.
inline std::array<double, 4> leading_eigenvector(std::array<std::array<double, 4>, 4> a)
{
  constexpr int sweeps = 30; // the off-diagonal part falls quadratically: six are enough
  std::array<std::array<double, 4>, 4> v = {};
  for(int i = 0; i < 4; ++i)
    v[i][i] = 1;
  for(int sweep = 0; sweep < sweeps; ++sweep)
    for(int p = 0; p < 4; ++p)
      for(int q = p + 1; q < 4; ++q) {
        if(a[p][q] == 0)
          continue;
        const double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
        const double c = 1 / std::sqrt(t * t + 1), s = t * c;
        const auto rotate = [&](double& x, double& y) { std::tie(x, y) = std::pair(c * x - s * y, s * x + c * y); };
        for(int k = 0; k < 4; ++k)
          rotate(a[k][p], a[k][q]);
        for(int k = 0; k < 4; ++k) {
          rotate(a[p][k], a[q][k]);
          rotate(v[k][p], v[k][q]);
        }
      }
  int largest = 0;
  for(int i = 1; i < 4; ++i)
    if(a[i][i] > a[largest][largest])
      largest = i;
  return {v[0][largest], v[1][largest], v[2][largest], v[3][largest]};
}

/// The rotation R for which the sum of to_k . R from_k is largest, of the matrix that is the sum of from_k to_k^T:
/// B. Horn, "Closed-form solution of absolute orientation using unit quaternions", JOSA A 4 (1987).
inline Matrix_3 rotation_of_products(const Matrix_3& s)
{
  const double trace = s[0][0] + s[1][1] + s[2][2];
  const std::array<double, 3> skew = {s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]};
  std::array<std::array<double, 4>, 4> n;
  n[0][0] = trace;
  for(int i = 0; i < 3; ++i) {
    n[0][i + 1] = n[i + 1][0] = skew[i];
    for(int j = 0; j < 3; ++j)
      n[i + 1][j + 1] = s[i][j] + s[j][i] - (i == j ? trace : 0);
  }
  return rotation_of_quaternion(leading_eigenvector(n));
}

/// The same of the vectors themselves. `Range`: random access to vec3.
template <class Range>
Matrix_3 best_rotation(const Range& from, const Range& to)
{
  Matrix_3 s = {};
  for(std::size_t k = 0; k < from.size(); ++k) {
    const std::array<double, 3> f = {from[k].x, from[k].y, from[k].z}, t = {to[k].x, to[k].y, to[k].z};
    for(int i = 0; i < 3; ++i)
      for(int j = 0; j < 3; ++j)
        s[i][j] += f[i] * t[j];
  }
  return rotation_of_products(s);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_ROTATIONS_H
