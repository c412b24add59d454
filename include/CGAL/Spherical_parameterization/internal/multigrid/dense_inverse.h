// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_DENSE_INVERSE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_DENSE_INVERSE_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/algebra/symmetric_solver.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The inverse of a dense symmetric matrix of size n, by rows. Rows that belong to a pivot that vanishes are 0. Only
/// the lower triangle of `matrix` is read.
///
/// Triangular systems are solved in panels of rows: within a panel row by row, for all other rows at once.
inline Host_array<double> dense_inverse(Host_array<double> matrix, int n)
{
  constexpr int panel = 4;
  const auto l = [&](int i, int j) -> double& { return matrix[std::size_t(i) * n + j]; };
  std::vector<int> pivot(n);
  factorize_symmetric(n, l, pivot);

  Host_array<double> inverse(matrix.size(), 0.);
  const auto x = [&](int i, int j) -> double& { return inverse[std::size_t(i) * n + j]; };
  const auto swap_rows = [&](int a, int b) {
    if(a != b)
      std::swap_ranges(&x(a, 0), &x(a, 0) + n, &x(b, 0));
  };
  // Takes from row i of x the product of factor(k) and the rows k = begin ... end-1.
  const auto subtract = [&](int i, int begin, int end, auto factor) {
    for(int j = 0; j < n; ++j) {
      double sum = 0;
      for(int k = begin; k < end; ++k)
        sum += factor(k) * x(k, j);
      x(i, j) -= sum;
    }
  };
  for(int i = 0; i < n; ++i)
    x(i, i) = 1;
  for(int k = 0; k < n; ++k)
    swap_rows(k, pivot[k]);
  for(int begin = 0; begin < n; begin += panel) { // x = L^-1 x
    const int end = (std::min)(n, begin + panel);
    for(int k = begin; k < end; ++k)
      for(int i = k + 1; i < end; ++i)
        for(int j = 0; j < n; ++j)
          x(i, j) -= x(k, j) * l(i, k);
    for(int i = end; i < n; ++i)
      subtract(i, begin, end, [&](int k) { return l(i, k); });
  }
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      x(i, j) = over_pivot(x(i, j), l(i, i));
  for(int end = n; end > 0; end -= panel) { // x = L^-T x
    const int begin = (std::max)(0, end - panel);
    for(int i = end - 1; i >= begin; --i)
      subtract(i, i + 1, end, [&](int k) { return l(k, i); });
    for(int i = 0; i < begin; ++i)
      subtract(i, begin, end, [&](int k) { return l(k, i); });
  }
  for(int k = n - 1; k >= 0; --k)
    swap_rows(k, pivot[k]);
  return inverse;
}

/// The dense inverse of the matrix of a graph, 0 for fixed vertices. Of a singular matrix, whose kernel are the
/// constants, that of A plus a multiple of 1 1^T: on right-hand sides that sum to zero it makes no difference which.
inline Host_array<double> dense_inverse(const Weighted_graph& a, bool is_singular)
{
  const int n = a.size();
  Host_array<double> m(std::size_t(n) * n, 0.);
  const auto at = [n](int i, int j) { return std::size_t(i) * n + j; };
  double scale = 0;
  for(int i = 0; i < n; ++i) {
    if(a.inverse_diagonal[i] == 0) {
      m[at(i, i)] = 1;
      continue;
    }
    m[at(i, i)] = a.diagonal(i);
    scale = (std::max)(scale, m[at(i, i)]);
    for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
      if(a.inverse_diagonal[a.target[k]] > 0)
        m[at(i, a.target[k])] -= a.weight[k];
  }
  if(is_singular)
    for(double& entry : m)
      entry += scale / n;
  const Host_array<double> x = dense_inverse(std::move(m), n);
  Host_array<double> rows(x.size());
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      const bool is_of_fixed = i == j && a.inverse_diagonal[i] == 0;
      rows[at(i, j)] = is_of_fixed ? 0 : (x[at(i, j)] + x[at(j, i)]) / 2;
    }
  return rows;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_DENSE_INVERSE_H
