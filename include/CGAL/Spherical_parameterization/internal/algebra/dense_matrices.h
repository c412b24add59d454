// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_DENSE_MATRICES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_DENSE_MATRICES_H

#include <Eigen/Dense>

namespace CGAL::Spherical_parameterization::internal {

/// The matrices of Eigen, by a parameter on which they do not depend. Their expressions take seconds to compile: so
/// they are compiled where what works with them is called, and not where its header is included.
template <class>
struct Dense {
  typedef Eigen::MatrixXd Matrix;
  typedef Eigen::VectorXd Vector;
};

/// The same, of floats.
template <class>
struct Floats {
  typedef Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Rows;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_DENSE_MATRICES_H
