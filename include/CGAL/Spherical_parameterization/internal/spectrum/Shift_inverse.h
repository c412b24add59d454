// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_SHIFT_INVERSE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_SHIFT_INVERSE_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The matrices of Eigen, by a parameter on which they do not depend: see `Dense`.
template <class>
struct Sparse {
  typedef Eigen::SparseMatrix<double> Matrix;
  typedef Eigen::SimplicialLDLT<Matrix> Cholesky;
};

/// The inverse of A - shift for A = S L S with S = M^(-1/2), whose eigenvalues are those of L u = lambda M u, and whose
/// eigenvectors are orthonormal as they stand.
///
/// With a shift amid the eigenvalues the matrix is not definite. Without pivoting its L D L^T exists all the same but
/// for few shifts, from which `set_shift()` keeps away, and the signs of D tell how many eigenvalues are below the
/// shift (J. Sylvester's law of inertia). Shifts of this kind for the spectra of surfaces: B. Vallet, B. Levy,
/// "Spectral geometry processing with manifold harmonics", Eurographics 2008.
template <class Loop>
class Shift_inverse {
  typedef typename Sparse<Loop>::Matrix Matrix;

public:
  static constexpr int width = 4; ///< right-hand sides that are solved for at once

  Shift_inverse(const Weighted_graph& laplacian, const std::vector<double>& mass)
    : matrix_(laplacian.size(), laplacian.size()), right_(laplacian.size() * std::size_t(width))
  {
    const int n = laplacian.size();
    diagonal_.resize(n);
    Host_array<double> scale(n);
    for(int i = 0; i < n; ++i)
      scale[i] = 1 / std::sqrt(mass[i]);
    Eigen::Matrix<int, Eigen::Dynamic, 1> size(n);
    for(int i = 0; i < n; ++i)
      size[i] = laplacian.offset[i + 1] - laplacian.offset[i] + 1;
    matrix_.reserve(size);
    for(int i = 0; i < n; ++i) { // column i, of which the lower part is read
      double sum = 0;
      for(int k = laplacian.offset[i]; k < laplacian.offset[i + 1]; ++k)
        sum += laplacian.weight[k];
      diagonal_[i] = sum / mass[i];
      matrix_.insert(i, i) = diagonal_[i];
      for(int k = laplacian.offset[i]; k < laplacian.offset[i + 1]; ++k)
        if(laplacian.target[k] > i)
          matrix_.insert(laplacian.target[k], i) = -laplacian.weight[k] * scale[i] * scale[laplacian.target[k]];
    }
    matrix_.makeCompressed();
    cholesky_.analyzePattern(matrix_);
  }

  int size() const { return static_cast<int>(diagonal_.size()); }

  /// Returns whether the matrix could be factorized by more than rounding.
  bool set_shift(double shift)
  {
    constexpr double rounding = 1e-11; // of a pivot, beside what stood there
    for(int i = 0; i < size(); ++i)
      matrix_.coeffRef(i, i) = diagonal_[i] - shift;
    cholesky_.factorize(matrix_);
    if(cholesky_.info() != Eigen::Success)
      return false;
    below_ = 0;
    const auto& place = cholesky_.permutationP().indices();
    for(int i = 0; i < size(); ++i) {
      const double pivot = cholesky_.vectorD()[place[i]];
      if(!(std::abs(pivot) > rounding * diagonal_[i])) // also of what is not finite
        return false;
      below_ += pivot < 0;
    }
    return true;
  }

  /// How many eigenvalues are below the shift.
  int number_below() const { return below_; }

  /// Multiplies `width` vectors at once, which reads the factor once for all of them.
  /// \param get  get(i, b) is entry i of vector b
  /// \param put  put(i, b, x) takes that of the product
  template <class Get, class Put>
  void apply(Get get, Put put)
  {
    const int n = size();
    const auto& factor = cholesky_.matrixL().nestedExpression();
    const auto& pivot = cholesky_.vectorD();
    const auto& place = cholesky_.permutationP().indices();
    const int* const begin = factor.outerIndexPtr();
    const int* const row = factor.innerIndexPtr();
    const double* const entry = factor.valuePtr();
    const auto at = [&](int i) { return right_.data() + i * std::size_t(width); };
    for(int i = 0; i < n; ++i)
      for(int b = 0; b < width; ++b)
        at(place[i])[b] = get(i, b);
    double x[width];
    for(int j = 0; j < n; ++j) {
      for(int b = 0; b < width; ++b)
        x[b] = at(j)[b];
      for(int k = begin[j]; k < begin[j + 1]; ++k) {
        double* const y = at(row[k]);
        for(int b = 0; b < width; ++b)
          y[b] -= entry[k] * x[b];
      }
    }
    for(int j = n - 1; j >= 0; --j) {
      for(int b = 0; b < width; ++b)
        x[b] = at(j)[b] / pivot[j];
      for(int k = begin[j]; k < begin[j + 1]; ++k) {
        const double* const y = at(row[k]);
        for(int b = 0; b < width; ++b)
          x[b] -= entry[k] * y[b];
      }
      for(int b = 0; b < width; ++b)
        at(j)[b] = x[b];
    }
    for(int i = 0; i < n; ++i)
      for(int b = 0; b < width; ++b)
        put(i, b, at(place[i])[b]);
  }

private:
  Matrix matrix_; ///< the lower triangle
  typename Sparse<Loop>::Cholesky cholesky_;
  Host_array<double> diagonal_; ///< of A
  std::vector<double> right_;   ///< in the order of the elimination
  int below_ = 0;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_SHIFT_INVERSE_H
