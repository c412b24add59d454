// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_NEAREST_ROWS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_NEAREST_ROWS_H

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <limits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The nearest of the rows of a matrix of floats, by brute force: the largest x y - y^2 / 2.
///
/// With vectors of the compiler (an extension of g++ and clang++), which are as wide as those of the processor that it
/// runs on: so it is three times as fast as products of Eigen's that are compiled for any processor. The order of the
/// sums does not depend on the width, and so not on the processor.
class Nearest_rows {
public:
  /// \param rows  row by row; finite
  Nearest_rows(const float* rows, int number, int columns)
    : number_(number), columns_(columns), panel_((static_cast<std::size_t>(number) + width - 1) / width * panel_size())
  {
    for(int s = 0; s < number; ++s) {
      float* const entry = panel_.data() + first_entry(s);
      float square = 0;
      for(int k = 0; k < columns; ++k) {
        const float x = *rows++;
        entry[(k + 1) * width] = x;
        square += x * x;
      }
      *entry = -square / 2;
    }
    for(int s = number; s % width != 0; ++s) // what the last panel has too much is never the nearest
      panel_[first_entry(s)] = -std::numeric_limits<float>::infinity();
  }

  /// Calls f(r, s, square) with the nearest row s, the first one if there are several, and its squared distance, for
  /// each row r of another matrix.
  template <class F>
  void for_each_row_of(const float* other, int number, F f) const
  {
    for(int begin = 0; begin < number; begin += together) {
      const float* row[together];
      for(int r = 0; r < together; ++r)
        row[r] = other + static_cast<std::size_t>((std::min)(begin + r, number - 1)) * columns_;
      Found found[together];
      find(row, found);
      for(int r = 0; r < together && begin + r < number; ++r) {
        float square = 0;
        for(int k = 0; k < columns_; ++k)
          square += row[r][k] * row[r][k];
        f(begin + r, found[r].row, (std::max)(0.F, square - 2 * found[r].most));
      }
    }
  }

private:
  static constexpr int width = 16;   ///< rows of a panel
  static constexpr int together = 4; ///< rows that are compared at once: then all sums are in registers

  struct Found {
    int row;
    float most; ///< x y - y^2 / 2
  };

  std::size_t panel_size() const { return static_cast<std::size_t>(width) * (columns_ + 1); }

  /// Of row s; its others follow in steps of `width`.
  std::size_t first_entry(int s) const { return s / width * panel_size() + s % width; }

  typedef float Floats_4 __attribute__((vector_size(16)));
  typedef int Ints_4 __attribute__((vector_size(16)));

  void find(const float* const (&row)[together], Found (&found)[together]) const
  {
#ifdef __x86_64__
    if(__builtin_cpu_supports("avx2"))
      return find_by_avx2(row, found);
#endif
    find_by<Floats_4, Ints_4>(row, found);
  }

#ifdef __x86_64__
  typedef float Floats_8 __attribute__((vector_size(32)));
  typedef int Ints_8 __attribute__((vector_size(32)));

  __attribute__((target("avx2"))) void find_by_avx2(const float* const (&row)[together], Found (&found)[together]) const
  {
    find_by<Floats_8, Ints_8>(row, found);
  }
#endif

  /// Always inlined: so it is compiled for the processor of the function that calls it.
  template <class Floats, class Ints>
  __attribute__((always_inline)) void find_by(const float* const (&row)[together], Found (&found)[together]) const
  {
    constexpr int lanes = static_cast<int>(sizeof(Floats) / sizeof(float)), parts = 2;
    Floats most[together][parts];
    Ints where[together][parts];
    for(int r = 0; r < together; ++r)
      for(int p = 0; p < parts; ++p) {
        most[r][p] = Floats{} - std::numeric_limits<float>::infinity();
        where[r][p] = Ints{};
      }
    for(int s = 0; s < number_; s += parts * lanes) {
      const float* column = panel_.data() + first_entry(s);
      Floats sum[together][parts];
      for(int p = 0; p < parts; ++p) {
        std::memcpy(&sum[0][p], column + p * lanes, sizeof(Floats));
        for(int r = 1; r < together; ++r)
          sum[r][p] = sum[0][p];
      }
      for(int k = 0; k < columns_; ++k) {
        column += width;
        Floats x[parts];
        for(int p = 0; p < parts; ++p)
          std::memcpy(&x[p], column + p * lanes, sizeof(Floats));
        for(int r = 0; r < together; ++r)
          for(int p = 0; p < parts; ++p)
            sum[r][p] += row[r][k] * x[p];
      }
      for(int r = 0; r < together; ++r)
        for(int p = 0; p < parts; ++p) {
          const auto is_more = sum[r][p] > most[r][p];
          most[r][p] = is_more ? sum[r][p] : most[r][p];
          where[r][p] = is_more ? Ints{} + (s + p * lanes) : where[r][p];
        }
    }
    for(int r = 0; r < together; ++r) {
      found[r] = {0, -std::numeric_limits<float>::infinity()};
      for(int p = 0; p < parts; ++p)
        for(int l = 0; l < lanes; ++l) {
          const Found its = {where[r][p][l] + l, most[r][p][l]};
          if(its.most > found[r].most || (its.most == found[r].most && its.row < found[r].row))
            found[r] = its;
        }
    }
  }

  int number_, columns_;
  std::vector<float> panel_; ///< of `width` rows each, column by column: -y^2 / 2, and the others
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_NEAREST_ROWS_H
