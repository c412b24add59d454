// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_DENSE_INVERSE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_DENSE_INVERSE_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The inverse of a dense symmetric matrix of size n, by rows, from P A P^T = L D L^T with diagonal pivoting, as in
/// Symmetric_solver. Rows of the inverse that belong to a pivot that vanishes are 0.
class Dense_inverse {
public:
  /// Only the lower triangle of `a` is read.
  Dense_inverse(Host_array<double> a, int n) : n_(n), l_(std::move(a)), pivot_(n) { factorize(); }

  Host_array<double> operator()() const
  {
    Host_array<double> x(l_.size(), 0.);
    for(int i = 0; i < n_; ++i)
      x[at(i, i)] = 1;
    for(int k = 0; k < n_; ++k)
      swap_rows(x, k, pivot_[k]);
    forward(x);
    for(int i = 0; i < n_; ++i) {
      const double d = l_[at(i, i)];
      for(int j = 0; j < n_; ++j)
        x[at(i, j)] = std::abs(d) > (std::numeric_limits<double>::min)() ? x[at(i, j)] / d : 0;
    }
    backward(x);
    for(int k = n_ - 1; k >= 0; --k)
      swap_rows(x, k, pivot_[k]);
    return x;
  }

private:
  /// Triangular systems are solved in panels of so many rows: within a panel row by row, for all other rows at once.
  static constexpr int panel = 4;

  std::size_t at(int i, int j) const { return static_cast<std::size_t>(i) * n_ + j; }

  void factorize()
  {
    std::vector<double> scaled(n_);
    for(int k = 0; k < n_; ++k) {
      int pivot = k;
      for(int i = k + 1; i < n_; ++i)
        if(std::abs(l_[at(i, i)]) > std::abs(l_[at(pivot, pivot)]))
          pivot = i;
      swap_symmetrically(k, pivot);
      for(int j = 0; j < k; ++j)
        scaled[j] = l_[at(j, j)] * l_[at(k, j)];
      for(int i = k; i < n_; ++i) {
        double sum = 0;
        for(int j = 0; j < k; ++j)
          sum += l_[at(i, j)] * scaled[j];
        l_[at(i, k)] -= sum;
      }
      if(std::abs(l_[at(k, k)]) > 0)
        for(int i = k + 1; i < n_; ++i)
          l_[at(i, k)] /= l_[at(k, k)];
    }
  }

  void swap_symmetrically(int k, int p)
  {
    pivot_[k] = p;
    if(p == k)
      return;
    for(int j = 0; j < k; ++j)
      std::swap(l_[at(k, j)], l_[at(p, j)]);
    for(int i = p + 1; i < n_; ++i)
      std::swap(l_[at(i, k)], l_[at(i, p)]);
    std::swap(l_[at(k, k)], l_[at(p, p)]);
    for(int i = k + 1; i < p; ++i)
      std::swap(l_[at(i, k)], l_[at(p, i)]);
  }

  void swap_rows(Host_array<double>& x, int a, int b) const
  {
    if(a != b)
      std::swap_ranges(x.begin() + at(a, 0), x.begin() + at(a, 0) + n_, x.begin() + at(b, 0));
  }

  /// x = L^-1 x
  void forward(Host_array<double>& x) const
  {
    for(int begin = 0; begin < n_; begin += panel) {
      const int end = (std::min)(n_, begin + panel);
      for(int k = begin; k < end; ++k)
        for(int i = k + 1; i < end; ++i)
          for(int j = 0; j < n_; ++j)
            x[at(i, j)] -= x[at(k, j)] * l_[at(i, k)];
      subtract(x, begin, end, end, n_, [&](int i, int k) { return l_[at(i, k)]; });
    }
  }

  /// x = L^-T x
  void backward(Host_array<double>& x) const
  {
    for(int end = n_; end > 0; end -= panel) {
      const int begin = (std::max)(0, end - panel);
      for(int i = end - 1; i >= begin; --i)
        for(int j = 0; j < n_; ++j) {
          double sum = 0;
          for(int k = i + 1; k < end; ++k)
            sum += l_[at(k, i)] * x[at(k, j)];
          x[at(i, j)] -= sum;
        }
      subtract(x, begin, end, 0, begin, [&](int i, int k) { return l_[at(k, i)]; });
    }
  }

  /// From the rows first ... last-1 of x, the product of `factor` and the rows begin ... end-1.
  template <class Factor>
  void subtract(Host_array<double>& x, int begin, int end, int first, int last, Factor factor) const
  {
    for(int i = first; i < last; ++i)
      for(int j = 0; j < n_; ++j) {
        double sum = 0;
        for(int k = begin; k < end; ++k)
          sum += factor(i, k) * x[at(k, j)];
        x[at(i, j)] -= sum;
      }
  }

  int n_;
  Host_array<double> l_; ///< L below the diagonal, D on it; by rows
  std::vector<int> pivot_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_DENSE_INVERSE_H
