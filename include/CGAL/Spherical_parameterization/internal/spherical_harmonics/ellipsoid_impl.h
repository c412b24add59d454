// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_IMPL_H

#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/ellipsoid.h>

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spherical_parameterization::internal {

/// The integrals over the sphere of the cubes of the coordinates along the axes: to which side a shape reaches farther.
inline std::array<double, 3> skewness(const Harmonic_coefficients& shape, const Eigen::Matrix3d& axes)
{
  constexpr int largest = 16; // details do not decide
  Harmonic_coefficients smooth((std::min)(largest, shape.degree()), 3);
  for(int field = 0; field < 3; ++field)
    std::copy_n(shape.field_begin(field), smooth.size(), smooth.field_begin(field));
  const Latitude_rows grid = gauss_legendre_rows(3 * smooth.degree() / 2 + 1, 3 * smooth.degree() + 1);
  const Host_array<double> value = synthesize_on_rows(Host_loop(), smooth, grid);
  const std::size_t n = grid.cos.size() * static_cast<std::size_t>(grid.columns);
  const double scale = 1 / std::sqrt(4 * pi);
  const Eigen::Vector3d centre(scale * shape(0, 0, 0), scale * shape(0, 0, 1), scale * shape(0, 0, 2));
  std::array<double, 3> result = {};
  for(std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d p = axes.transpose() * (Eigen::Vector3d(value[i], value[n + i], value[2 * n + i]) - centre);
    for(int k = 0; k < 3; ++k)
      result[k] += grid.weight[i / static_cast<std::size_t>(grid.columns)] * p[k] * p[k] * p[k];
  }
  return result;
}

CGAL_SP_CORE Ellipsoid ellipsoid_of(const Harmonic_coefficients& shape)
{
  Ellipsoid result;
  Eigen::Matrix3d a;
  const double constant = 1 / std::sqrt(4 * pi), linear = std::sqrt(3.) * constant;
  for(int k = 0; k < 3; ++k) {
    result.centre[k] = constant * shape(0, 0, k);
    a.row(k) << linear * shape(1, 1, k), linear * shape(1, -1, k), linear * shape(1, 0, k);
  }
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d u = svd.matrixU(), v = svd.matrixV();
  // Each pair of columns has a free sign: the first two towards where the shape reaches farther, the third one so that
  // axes are right-handed.
  const std::array<double, 3> skew = skewness(shape, u);
  for(int k = 0; k < 2; ++k)
    if(skew[k] < 0) {
      u.col(k) *= -1;
      v.col(k) *= -1;
    }
  const double mirrored = u.determinant() * v.determinant() < 0 ? -1 : 1;
  if(u.determinant() < 0)
    u.col(2) *= -1;
  if(v.determinant() < 0)
    v.col(2) *= -1;
  for(int k = 0; k < 3; ++k) {
    result.radii[k] = svd.singularValues()[k] * (k == 2 ? mirrored : 1);
    for(int i = 0; i < 3; ++i) {
      result.axes[k][i] = u(i, k);
      result.sphere_axes[k][i] = v(i, k);
    }
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_IMPL_H
