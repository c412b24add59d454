// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_SPARSE_CHOLESKY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_SPARSE_CHOLESKY_H

#include <CGAL/Spherical_parameterization/internal/relaxation/Face_hessian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A symmetric matrix of 2x2 blocks on the edges of a graph and its Cholesky factor, which has room for the blocks that
/// the elimination fills. The order is that of minimum degree: A. George, J. Liu, "The evolution of the minimum degree
/// ordering algorithm", SIAM Review 31 (1989). For thousands of rows, and not for millions.
///
/// Its own text, and not a library's: headers of this room need none, and the order of sums is the same everywhere.
class Sparse_cholesky {
public:
  /// \param neighbours  of every vertex; equal ones may be there several times
  explicit Sparse_cholesky(std::vector<std::vector<int>> neighbours)
    : place_(neighbours.size()), rows_(neighbours.size()), blocks_(neighbours.size())
  {
    const int n = static_cast<int>(neighbours.size());
    std::set<std::pair<int, int>> by_degree;
    for(int i = 0; i < n; ++i) {
      sort_and_unite(neighbours[i]);
      by_degree.emplace(static_cast<int>(neighbours[i].size()), i);
    }
    std::vector<int> united;
    for(int k = 0; k < n; ++k) {
      const int i = by_degree.begin()->second;
      by_degree.erase(by_degree.begin());
      place_[i] = k;
      rows_[k] = std::move(neighbours[i]);
      for(int j : rows_[k]) { // which become neighbours of each other
        by_degree.erase({static_cast<int>(neighbours[j].size()), j});
        united.clear();
        std::set_union(neighbours[j].begin(), neighbours[j].end(), rows_[k].begin(), rows_[k].end(),
                       std::back_inserter(united));
        united.erase(std::remove_if(united.begin(), united.end(), [&](int v) { return v == i || v == j; }),
                     united.end());
        neighbours[j] = united;
        by_degree.emplace(static_cast<int>(united.size()), j);
      }
    }
    for(int k = 0; k < n; ++k) {
      for(int& i : rows_[k])
        i = place_[i];
      rows_[k].push_back(k);
      std::sort(rows_[k].begin(), rows_[k].end());
      blocks_[k].resize(rows_[k].size());
    }
  }

  int size() const { return static_cast<int>(rows_.size()); }

  void set_zero()
  {
    for(auto& column : blocks_)
      std::fill(column.begin(), column.end(), Block{0, 0, 0, 0});
  }

  /// Where the block of two vertices is kept; of i, j and j, i only one is.
  struct Place {
    int column, at;
    bool is_transposed;
  };

  /// \pre i == j, or they are neighbours
  Place place(int i, int j) const
  {
    const int row = (std::max)(place_[i], place_[j]), column = (std::min)(place_[i], place_[j]);
    const auto at = std::lower_bound(rows_[column].begin(), rows_[column].end(), row) - rows_[column].begin();
    return {column, static_cast<int>(at), place_[i] < place_[j]};
  }

  void add(const Place& place, const Block& b)
  {
    Block& entry = blocks_[place.column][place.at];
    entry.ss += b.ss;
    entry.st += place.is_transposed ? b.ts : b.st;
    entry.ts += place.is_transposed ? b.st : b.ts;
    entry.tt += b.tt;
  }

  const Block& diagonal(int i) const { return blocks_[place_[i]].front(); }

  /// Puts the factor L, A = L L^T, in the place of the matrix; of the blocks on the diagonal, the inverse. Returns
  /// whether the matrix is positive definite by more than rounding; if not, it is destroyed.
  bool factorize()
  {
    std::vector<Block> original(size());
    for(int k = 0; k < size(); ++k)
      original[k] = blocks_[k].front();
    for(int k = 0; k < size(); ++k) {
      std::vector<Block>& column = blocks_[k];
      const std::vector<int>& rows = rows_[k];
      if(!invert_factor(original[k], column[0]))
        return false;
      const Block inverse = transposed(column[0]);
      for(std::size_t a = 1; a < column.size(); ++a)
        column[a] = product(column[a], inverse);
      for(std::size_t a = 1; a < column.size(); ++a) {
        const std::vector<int>& rows_of_other = rows_[rows[a]];
        std::vector<Block>& other = blocks_[rows[a]];
        const Block y = column[a];
        for(std::size_t b = a, at = 0; b < column.size(); ++b, ++at) {
          while(rows_of_other[at] != rows[b])
            ++at;
          const Block x = column[b];
          Block& entry = other[at];
          entry.ss -= x.ss * y.ss + x.st * y.st;
          entry.st -= x.ss * y.ts + x.st * y.tt;
          entry.ts -= x.ts * y.ss + x.tt * y.st;
          entry.tt -= x.ts * y.ts + x.tt * y.tt;
        }
      }
    }
    return true;
  }

  /// Of a factorized matrix: the solution of A x = b, both by vertex.
  std::vector<Planar> solve(const std::vector<Planar>& b) const
  {
    std::vector<Planar> x(size());
    for(int i = 0; i < size(); ++i)
      x[place_[i]] = b[i];
    for(int k = 0; k < size(); ++k) {
      x[k] = times(blocks_[k][0], x[k]);
      for(std::size_t a = 1; a < rows_[k].size(); ++a)
        x[rows_[k][a]] = add_scaled(x[rows_[k][a]], -1, times(blocks_[k][a], x[k]));
    }
    for(int k = size() - 1; k >= 0; --k) {
      for(std::size_t a = 1; a < rows_[k].size(); ++a)
        x[k] = add_scaled(x[k], -1, times(transposed(blocks_[k][a]), x[rows_[k][a]]));
      x[k] = times(transposed(blocks_[k][0]), x[k]);
    }
    std::vector<Planar> result(size());
    for(int i = 0; i < size(); ++i)
      result[i] = x[place_[i]];
    return result;
  }

private:
  static Planar times(const Block& a, Planar x) { return {a.ss * x.s + a.st * x.t, a.ts * x.s + a.tt * x.t}; }

  static void sort_and_unite(std::vector<int>& list)
  {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  /// Replaces a block on the diagonal, or what the elimination has left of it, by the inverse of its Cholesky factor.
  static bool invert_factor(const Block& original, Block& a)
  {
    constexpr double rounding = 1e-14;
    if(!(a.ss > rounding * original.ss))
      return false;
    const double l = std::sqrt(a.ss), m = a.ts / l, square = a.tt - m * m;
    if(!(square > rounding * original.tt))
      return false;
    const double r = std::sqrt(square);
    a = {1 / l, 0, -m / (l * r), 1 / r};
    return true;
  }

  std::vector<int> place_;                 ///< of every vertex in the order of the elimination
  std::vector<std::vector<int>> rows_;     ///< of every column from the diagonal on down, ascending
  std::vector<std::vector<Block>> blocks_; ///< in these
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_SPARSE_CHOLESKY_H
