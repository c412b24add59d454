// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_SYMMETRIC_SOLVER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_SYMMETRIC_SOLVER_H

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// Solves small symmetric systems A x = b by P A P^T = L D L^T with diagonal pivoting (G. Golub, C. Van Loan, "Matrix
/// Computations", section 4.4). Components along a pivot that vanishes are 0.
///
/// Its own text, and not a library's: the order of its sums does not depend on the vector registers that a compiler may
/// use, so that results are the same bits everywhere.
template <int N>
class Symmetric_solver {
public:
  typedef std::array<double, N> Vector;
  typedef std::array<Vector, N> Matrix;

  /// Only the lower triangle of `a` is read.
  explicit Symmetric_solver(const Matrix& a) : l_(a)
  {
    for(int k = 0; k < N; ++k) {
      int pivot = k;
      for(int i = k + 1; i < N; ++i)
        if(std::abs(l_[i][i]) > std::abs(l_[pivot][pivot]))
          pivot = i;
      swap(k, pivot);
      Vector scaled{};
      for(int j = 0; j < k; ++j)
        scaled[j] = l_[j][j] * l_[k][j];
      for(int i = k; i < N; ++i) {
        double sum = 0;
        for(int j = 0; j < k; ++j)
          sum += l_[i][j] * scaled[j];
        l_[i][k] -= sum;
      }
      if(std::abs(l_[k][k]) > 0)
        for(int i = k + 1; i < N; ++i)
          l_[i][k] /= l_[k][k];
    }
  }

  Vector solve(Vector x) const
  {
    for(int k = 0; k < N; ++k)
      std::swap(x[k], x[pivot_[k]]);
    for(int i = 1; i < N; ++i) {
      double sum = 0;
      for(int j = 0; j < i; ++j)
        sum += l_[i][j] * x[j];
      x[i] -= sum;
    }
    for(int i = 0; i < N; ++i)
      x[i] = std::abs(l_[i][i]) > (std::numeric_limits<double>::min)() ? x[i] / l_[i][i] : 0;
    for(int i = N - 2; i >= 0; --i) {
      double sum = 0;
      for(int j = i + 1; j < N; ++j)
        sum += l_[j][i] * x[j];
      x[i] -= sum;
    }
    for(int k = N - 1; k >= 0; --k)
      std::swap(x[k], x[pivot_[k]]);
    return x;
  }

private:
  /// Exchanges rows and columns k and p >= k of the symmetric matrix, of which the lower triangle is stored.
  void swap(int k, int p)
  {
    pivot_[k] = p;
    if(p == k)
      return;
    for(int j = 0; j < k; ++j)
      std::swap(l_[k][j], l_[p][j]);
    for(int i = p + 1; i < N; ++i)
      std::swap(l_[i][k], l_[i][p]);
    std::swap(l_[k][k], l_[p][p]);
    for(int i = k + 1; i < p; ++i)
      std::swap(l_[i][k], l_[p][i]);
  }

  Matrix l_; ///< L below the diagonal, D on it
  std::array<int, N> pivot_{};
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BASE_SYMMETRIC_SOLVER_H
