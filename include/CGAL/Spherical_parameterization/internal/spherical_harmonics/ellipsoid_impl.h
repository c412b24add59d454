// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_IMPL_H

#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/ellipsoid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spherical_parameterization::internal {

/// The integrals over the sphere of the cubes of the coordinates along the axes: to which side a shape reaches farther.
template <class Loop>
std::array<double, 3> skewness(const Loop& loop, const Harmonic_coefficients& shape,
                               const typename Dense<Loop>::Matrix_3& axes)
{
  typedef typename Dense<Loop>::Vector_3 Vector;
  constexpr int largest = 16; // details do not decide
  const Harmonic_coefficients smooth = with_degree(shape, (std::min)(largest, shape.degree()));
  const Latitude_rows grid = gauss_legendre_rows(3 * smooth.degree() / 2 + 1, 3 * smooth.degree() + 1);
  const Host_array<double> value = synthesize_on_rows(loop, smooth, grid);
  const std::size_t n = grid.cos.size() * static_cast<std::size_t>(grid.columns);
  const double scale = 1 / std::sqrt(4 * pi);
  const Vector centre(scale * shape(0, 0, 0), scale * shape(0, 0, 1), scale * shape(0, 0, 2));
  std::array<double, 3> result = {};
  for(std::size_t i = 0; i < n; ++i) {
    const Vector p = axes.transpose() * (Vector(value[i], value[n + i], value[2 * n + i]) - centre);
    for(int k = 0; k < 3; ++k)
      result[k] += grid.weight[i / static_cast<std::size_t>(grid.columns)] * p[k] * p[k] * p[k];
  }
  return result;
}

template <class Loop>
First_order_ellipsoid ellipsoid_of(const Loop& loop, const Harmonic_coefficients& of_any_size)
{
  typedef typename Dense<Loop>::Matrix_3 Matrix;
  Harmonic_coefficients shape = of_any_size;
  const int exponent = scale_to_one(shape.values().data(), shape.values().data() + shape.values().size());
  First_order_ellipsoid result;
  Matrix a;
  const double constant = 1 / std::sqrt(4 * pi), linear = std::sqrt(3.) * constant;
  for(int k = 0; k < 3; ++k) {
    result.centre[k] = std::ldexp(constant * shape(0, 0, k), exponent);
    a.row(k) << linear * shape(1, 1, k), linear * shape(1, -1, k), linear * shape(1, 0, k);
  }
  const Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix u = svd.matrixU(), v = svd.matrixV();
  // Each pair of columns has a free sign: the first two towards where the shape reaches farther, the third one so that
  // axes are right-handed.
  const std::array<double, 3> skew = skewness(loop, shape, u);
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
    result.radii[k] = std::ldexp(svd.singularValues()[k] * (k == 2 ? mirrored : 1), exponent);
    for(int i = 0; i < 3; ++i) {
      result.axes[k][i] = u(i, k);
      result.sphere_axes[k][i] = v(i, k);
    }
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_ELLIPSOID_IMPL_H
