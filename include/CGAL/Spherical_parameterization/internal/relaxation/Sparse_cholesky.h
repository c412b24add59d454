// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_SPARSE_CHOLESKY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_SPARSE_CHOLESKY_H

#include <CGAL/Spherical_parameterization/internal/relaxation/Face_hessian.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <queue>
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
  explicit Sparse_cholesky(std::vector<std::vector<int>> neighbours) : place_(neighbours.size(), -1)
  {
    const int n = static_cast<int>(neighbours.size());
    typedef std::pair<int, int> Candidate; // degree, which may have changed since, and vertex
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> queue;
    const auto enqueue = [&](int i) { queue.emplace(static_cast<int>(neighbours[i].size()), i); };
    for(int i = 0; i < n; ++i) {
      std::sort(neighbours[i].begin(), neighbours[i].end());
      neighbours[i].erase(std::unique(neighbours[i].begin(), neighbours[i].end()), neighbours[i].end());
      enqueue(i);
    }
    std::vector<int> order, united;
    while(!queue.empty()) {
      const auto [degree, i] = queue.top();
      queue.pop();
      if(place_[i] >= 0 || degree != static_cast<int>(neighbours[i].size()))
        continue;
      place_[i] = static_cast<int>(order.size());
      order.push_back(i);
      const std::vector<int>& around = neighbours[i];
      for(int j : around) { // which become neighbours of each other
        united.clear();
        std::set_union(neighbours[j].begin(), neighbours[j].end(), around.begin(), around.end(),
                       std::back_inserter(united));
        united.erase(std::remove_if(united.begin(), united.end(), [i = i, j](int v) { return v == i || v == j; }),
                     united.end());
        neighbours[j].swap(united);
        enqueue(j);
      }
    }
    for(int i : order) {
      first_.push_back(static_cast<int>(row_.size()));
      row_.push_back(place_[i]);
      for(int j : neighbours[i])
        row_.push_back(place_[j]);
      std::sort(row_.begin() + first_.back(), row_.end());
    }
    first_.push_back(static_cast<int>(row_.size()));
    block_.resize(row_.size());
  }

  int size() const { return static_cast<int>(place_.size()); }

  void set_zero() { std::fill(block_.begin(), block_.end(), Block{0, 0, 0, 0}); }

  /// Where the block of two vertices is kept; of i, j and j, i only one is.
  struct Place {
    int at;
    bool is_transposed;
  };

  /// \pre i == j, or they are neighbours
  Place place(int i, int j) const
  {
    const int row = (std::max)(place_[i], place_[j]), column = (std::min)(place_[i], place_[j]);
    const auto begin = row_.begin() + first_[column], end = row_.begin() + first_[column + 1];
    return {static_cast<int>(std::lower_bound(begin, end, row) - row_.begin()), place_[i] < place_[j]};
  }

  typedef std::vector<Block> Blocks;

  static void add(Blocks& blocks, const Place& place, const Block& b)
  {
    Block& entry = blocks[place.at];
    entry = sum(entry, place.is_transposed ? transposed(b) : b);
  }

  void add(const Place& place, const Block& b) { add(block_, place, b); }

  /// The matrix becomes a + r b, whose blocks are at these places; it is zero elsewhere.
  void set_sum(const std::vector<int>& at, const Blocks& a, double r, const Blocks& b)
  {
    set_zero();
    for(std::size_t k = 0; k < at.size(); ++k)
      block_[at[k]] = sum(a[k], scaled(r, b[k]));
  }

  const Block& diagonal(int i) const { return block_[first_[place_[i]]]; }

  /// Puts the factor L, A = L L^T, in the place of the matrix; of the blocks on the diagonal, the inverse. Returns
  /// whether the matrix is positive definite by more than rounding; if not, it is destroyed.
  bool factorize()
  {
    std::vector<Block> original(size());
    for(int k = 0; k < size(); ++k)
      original[k] = block_[first_[k]];
    for(int k = 0; k < size(); ++k) {
      const int begin = first_[k], end = first_[k + 1];
      if(!invert_factor(original[k], block_[begin]))
        return false;
      const Block inverse = transposed(block_[begin]);
      for(int a = begin + 1; a < end; ++a)
        block_[a] = product(block_[a], inverse);
      for(int a = begin + 1; a < end; ++a) {
        const Block y = block_[a];
        for(int b = a, at = first_[row_[a]]; b < end; ++b, ++at) {
          while(row_[at] != row_[b])
            ++at;
          const Block x = block_[b];
          Block& entry = block_[at];
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
      x[k] = times(block_[first_[k]], x[k]);
      for(int a = first_[k] + 1; a < first_[k + 1]; ++a)
        x[row_[a]] = add_scaled(x[row_[a]], -1, times(block_[a], x[k]));
    }
    for(int k = size() - 1; k >= 0; --k) {
      for(int a = first_[k] + 1; a < first_[k + 1]; ++a)
        x[k] = add_scaled(x[k], -1, times(transposed(block_[a]), x[row_[a]]));
      x[k] = times(transposed(block_[first_[k]]), x[k]);
    }
    std::vector<Planar> result(size());
    for(int i = 0; i < size(); ++i)
      result[i] = x[place_[i]];
    return result;
  }

private:
  static Planar times(const Block& a, Planar x) { return {a.ss * x.s + a.st * x.t, a.ts * x.s + a.tt * x.t}; }

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

  std::vector<int> place_; ///< of every vertex in the order of the elimination
  std::vector<int> first_; ///< of every column: where it begins, and in the end where the last one ends
  std::vector<int> row_;   ///< of every block; in a column from the diagonal on down, ascending
  Blocks block_;           ///< by columns
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_SPARSE_CHOLESKY_H
