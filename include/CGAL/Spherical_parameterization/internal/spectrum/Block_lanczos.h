// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_BLOCK_LANCZOS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_BLOCK_LANCZOS_H

#include <CGAL/Spherical_parameterization/internal/algebra/dense_matrices.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// An orthonormal basis of the vectors x, A x, A^2 x ... of a few random ones, for a symmetric A, and what A is in it,
/// a band matrix T. A vector that is known to be an eigenvector is kept out. G. Golub, R. Underwood, "The block Lanczos
/// method for computing eigenvalues", 1977; with full reorthogonalization.
///
/// A block finds eigenvalues that are as often there as it is wide; and products of matrices take a third of the time
/// of as many products with vectors.
///
/// The rows are in parts, each a matrix of its own: parts stay in the cache, and sums over the rows have an order that
/// does not depend on the number of threads.
template <class Loop, class Operator>
class Block_lanczos {
public:
  typedef typename Dense<Loop>::Matrix Matrix;
  static constexpr int width = Operator::width;

  /// \param known  the eigenvector, of length 1
  Block_lanczos(const Loop& loop, Operator& a, const Host_array<double>& known, int capacity)
    : loop_(loop), operator_(a), n_(a.size()), rows_(static_cast<std::size_t>((n_ + part_rows - 1) / part_rows)),
      t_(Matrix::Zero(0, 0))
  {
    for_each_part([&](int p, Matrix& rows) {
      rows.resize((std::min)(part_rows, n_ - p * part_rows), 1 + width + capacity);
      for(Eigen::Index i = 0; i < rows.rows(); ++i)
        rows(i, 0) = known[p * part_rows + i];
    });
    for(int b = 0; b < width; ++b)
      make_random(1 + b);
    subtract_projection(0, 1, 1, width);
    orthonormalize(1, Matrix::Zero(1, width));
  }

  int size() const { return size_; }
  const Matrix& t() const { return t_; }

  /// By how much A, applied to the last block, leaves the basis: the length of this times the last rows of an
  /// eigenvector of T is the residual of the vector that it stands for.
  const Matrix& rest() const { return rest_; }

  /// Adds a block.
  void grow()
  {
    const int last = 1 + size_, next = last + width; // columns
    operator_.apply([&](int i, int b) { return at(i, last + b); },
                    [&](int i, int b, double x) { at(i, next + b) = x; });
    t_.conservativeResize(size_ + width, size_ + width);
    t_.rightCols(width).setZero();
    t_.bottomRows(width).setZero();
    if(size_ > 0) {
      t_.block(size_, size_ - width, width, width) = rest_;
      t_.block(size_ - width, size_, width, width) = rest_.transpose();
    }
    // First the two blocks that it has most of, then all: the second time there is only rounding left.
    const int near = (std::max)(1, last - width);
    const Matrix largest = subtract_projection(near, next, next, width);
    const Matrix others = subtract_projection(0, next, next, width);
    const Matrix own = largest.bottomRows(width) + others.bottomRows(width);
    t_.bottomRightCorner(width, width) = (own + own.transpose()) / 2;
    rest_ = orthonormalize(next, largest.colwise().norm());
    size_ += width;
  }

  /// The vectors that stand for columns of coefficients: f(i, k, x) gets entry i of vector k.
  template <class F>
  void combine(const Matrix& coefficients, F f)
  {
    for_each_part([&](int p, Matrix& rows) {
      Matrix x = Matrix::Zero(rows.rows(), coefficients.cols());
      add_product(rows.middleCols(1, size_), coefficients, x);
      for(Eigen::Index k = 0; k < x.cols(); ++k)
        for(Eigen::Index i = 0; i < x.rows(); ++i)
          f(p * part_rows + static_cast<int>(i), static_cast<int>(k), x(i, k));
    });
  }

private:
  static constexpr int part_rows = 512;

  double& at(int i, int column) { return rows_[i / part_rows](i % part_rows, column); }

  template <class F>
  void for_each_part(F f)
  {
    loop_.for_each(static_cast<int>(rows_.size()), [&](int p) { f(p, rows_[p]); });
  }

  /// The inner products of columns first ... end-1 with `count` columns from `column` on.
  Matrix products(int first, int end, int column, int count)
  {
    std::vector<Matrix> of_part(rows_.size());
    for_each_part([&](int p, Matrix& rows) {
      of_part[p] = Matrix::Zero(end - first, count);
      add_product(rows.middleCols(first, end - first).transpose(), rows.middleCols(column, count), of_part[p]);
    });
    for(std::size_t p = 1; p < of_part.size(); ++p)
      of_part[0] += of_part[p];
    return of_part[0];
  }

  double length(int column) { return std::sqrt(products(column, column + 1, column, 1)(0, 0)); }

  Matrix subtract_projection(int first, int end, int column, int count)
  {
    Matrix product = products(first, end, column, count);
    const Matrix less = -product;
    for_each_part([&](int, Matrix& rows) {
      add_product(rows.middleCols(first, end - first), less, rows.middleCols(column, count));
    });
    return product;
  }

  void make_random(int column)
  {
    for(int i = 0; i < n_; ++i) // no distribution of the standard library: these differ
      at(i, column) = static_cast<double>(random_()) / static_cast<double>(std::minstd_rand::max()) - 0.5;
  }

  static constexpr double cancellation = 1e-2; ///< of lengths: more is lost than a second subtraction gives back
  static constexpr double rounding = 1e-13;

  /// Makes the block at `column`, which is orthogonal to all columns before, orthonormal; it was that times the
  /// triangle that is returned. By Cholesky's factor of the inner products, twice: Y. Yamamoto, Y. Nakatsukasa,
  /// Y. Yanagisawa, T. Fukaya, "Roundoff error analysis of the CholeskyQR2 algorithm", ETNA 44 (2015).
  /// \param original  a row: lengths before anything was subtracted
  Matrix orthonormalize(int column, const Matrix& original)
  {
    Matrix triangle = Matrix::Identity(width, width);
    for(int twice = 0; twice < 2; ++twice) {
      const Matrix product = products(column, column + width, column, width),
                   length = product.diagonal().cwiseSqrt().transpose();
      const Eigen::LLT<Matrix> factor(
        (length.cwiseInverse().asDiagonal() * product * length.cwiseInverse().asDiagonal()).eval());
      if(twice == 0 && !((length - rounding * original).minCoeff() > 0 && factor.info() == Eigen::Success &&
                         factor.matrixLLT().diagonal().minCoeff() > cancellation))
        return orthonormalize_singly(column, original);
      const Matrix upper = Matrix(factor.matrixU()) * length.asDiagonal();
      const Matrix inverse = upper.template triangularView<Eigen::Upper>().solve(Matrix::Identity(width, width));
      for_each_part(
        [&](int, Matrix& rows) { rows.middleCols(column, width) = rows.middleCols(column, width) * inverse; });
      triangle = upper * triangle;
    }
    return triangle;
  }

  /// The same, column by column. What the columns before it leave nothing of, because the basis holds all that A makes
  /// of it, becomes random, with a zero in the triangle.
  Matrix orthonormalize_singly(int column, const Matrix& original)
  {
    Matrix triangle = Matrix::Zero(width, width);
    for(int b = 0; b < width; ++b) {
      const int own = column + b;
      double before = length(own);
      for(int twice = 0; twice < 2 && b > 0; ++twice)
        triangle.col(b).head(b) += subtract_projection(column, own, own, 1);
      double left = triangle(b, b) = length(own);
      while(left < cancellation * before) { // also of what is not orthogonal to all columns any more
        if(!(left > rounding * original(b))) {
          triangle(b, b) = 0;
          make_random(own);
        }
        before = length(own);
        for(int twice = 0; twice < 2; ++twice)
          subtract_projection(0, own, own, 1);
        left = length(own);
      }
      for_each_part([&](int, Matrix& rows) { rows.col(own) /= left; });
    }
    return triangle;
  }

  const Loop& loop_;
  Operator& operator_;
  int n_, size_ = 0;
  std::vector<Matrix> rows_; ///< by part: the known vector, the basis, and the next block
  Matrix t_, rest_;
  std::minstd_rand random_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPECTRUM_BLOCK_LANCZOS_H
