// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_DENSE_MATRICES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_DENSE_MATRICES_H

#include <Eigen/Dense>

#include <algorithm>

namespace CGAL::Spherical_parameterization::internal {

/// The matrices of Eigen, by a parameter on which they do not depend. Their expressions take seconds to compile: so
/// they are compiled where what works with them is called, and not where its header is included.
template <class>
struct Dense {
  typedef Eigen::MatrixXd Matrix;
  typedef Eigen::VectorXd Vector;
  typedef Eigen::Matrix3d Matrix_3;
  typedef Eigen::Vector3d Vector_3;
};

/// The same, of floats.
template <class>
struct Floats {
  typedef Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Rows;
};

/// sum += a b, in pieces: so the order of all sums is the same on every machine, while Eigen's follows the sizes of the
/// caches. And the copies that Eigen makes of pieces are small enough for the stack.
template <class A, class B, class Sum>
void add_product(const A& a, const B& b, Sum&& sum)
{
  constexpr Eigen::Index piece = 128;
  for(Eigen::Index k = 0; k < a.cols(); k += piece)
    for(Eigen::Index i = 0; i < a.rows(); i += piece) {
      const Eigen::Index rows = (std::min)(piece, a.rows() - i), depth = (std::min)(piece, a.cols() - k);
      sum.middleRows(i, rows).noalias() += a.block(i, k, rows, depth) * b.middleRows(k, depth);
    }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_DENSE_MATRICES_H
