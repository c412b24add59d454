// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_SYMMETRIC_SOLVER_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_SYMMETRIC_SOLVER_H

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// P A P^T = L D L^T (G. Golub, C. Van Loan, "Matrix Computations", section 4.4) in the place of the symmetric matrix
/// of size n whose entries are a(i, j), of which only the lower triangle is read: L comes below the diagonal, D on it.
/// The largest entries of the diagonal of A come first, which is enough for matrices that are definite or semidefinite.
/// Step k exchanges k and pivot[k].
///
/// Its own text, and not a library's: the order of its sums does not depend on the vector registers that a compiler may
/// use, so that results are the same bits everywhere.
template <class Entry, class Pivots>
void factorize_symmetric(int n, Entry a, Pivots& pivot)
{
  const auto exchange = [&](int k, int p) { // k <= p
    for(int j = 0; j < k; ++j)
      std::swap(a(k, j), a(p, j));
    for(int i = p + 1; i < n; ++i)
      std::swap(a(i, k), a(i, p));
    std::swap(a(k, k), a(p, p));
    for(int i = k + 1; i < p; ++i)
      std::swap(a(i, k), a(p, i));
  };
  std::vector<double> scaled(n);
  for(int k = 0; k < n; ++k) {
    pivot[k] = k;
    for(int i = k + 1; i < n; ++i)
      if(std::abs(a(i, i)) > std::abs(a(pivot[k], pivot[k])))
        pivot[k] = i;
    if(pivot[k] != k)
      exchange(k, pivot[k]);
    for(int j = 0; j < k; ++j)
      scaled[j] = a(j, j) * a(k, j);
    for(int i = k; i < n; ++i) {
      double sum = 0;
      for(int j = 0; j < k; ++j)
        sum += a(i, j) * scaled[j];
      a(i, k) -= sum;
    }
    if(std::abs(a(k, k)) > 0)
      for(int i = k + 1; i < n; ++i)
        a(i, k) /= a(k, k);
  }
}

/// x / pivot, and 0 for a pivot that vanishes
inline double over_pivot(double x, double pivot)
{
  return std::abs(pivot) > (std::numeric_limits<double>::min)() ? x / pivot : 0;
}

/// Solves small symmetric systems A x = b. Components along a pivot that vanishes are 0.
template <int N>
class Symmetric_solver {
public:
  typedef std::array<double, N> Vector;
  typedef std::array<Vector, N> Matrix;

  /// Only the lower triangle of `a` is read.
  explicit Symmetric_solver(const Matrix& a) : l_(a)
  {
    factorize_symmetric(
      N, [&](int i, int j) -> double& { return l_[i][j]; }, pivot_);
  }

  Vector solve(Vector x) const
  {
    for(int k = 0; k < N; ++k)
      std::swap(x[k], x[pivot_[k]]);
    for(int i = 1; i < N; ++i)
      x[i] -= std::inner_product(x.begin(), x.begin() + i, l_[i].begin(), 0.);
    for(int i = 0; i < N; ++i)
      x[i] = over_pivot(x[i], l_[i][i]);
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
  Matrix l_; ///< L below the diagonal, D on it
  std::array<int, N> pivot_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_SYMMETRIC_SOLVER_H
