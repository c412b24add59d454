// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_SPARSE_ROWS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_SPARSE_ROWS_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Collects one sparse row at a time: values are added by column, and read out in the order of first use.
///
/// Where an entry is, is looked up in an array over all columns. It comes from calloc, so that pages that are never
/// touched take no memory: with many accumulators, each working on a part of the matrix, that is most of them.
class Row_accumulator {
public:
  explicit Row_accumulator(int columns)
    : position_(static_cast<int*>(std::calloc(static_cast<std::size_t>(columns) + 1, sizeof(int))), &std::free)
  {
    if(!position_)
      throw std::bad_alloc();
  }

  /// Adds factor value[k] to column[k] for all k < count.
  ///
  /// Whether a column is new cannot be foreseen: the loop does the same in either case, since a branch taken wrongly
  /// would cost more than all the rest.
  void add(const int* column, const double* value, int count, double factor)
  {
    if(size_ + count >= static_cast<int>(entry_.size()))
      entry_.resize(2 * (size_ + count) + 64, Entry{0, 0});
    int* const position = position_.get();
    Entry* const entry = entry_.data();
    int size = size_;
    for(int k = 0; k < count; ++k) {
      const int c = column[k];
      const int known = position[c]; // from 1 on
      const int here = known == 0 ? size + 1 : known;
      size += known == 0;
      position[c] = here;
      entry[here].column = c;
      entry[here].value += factor * value[k];
    }
    size_ = size;
  }

  int size() const { return size_; }
  int column(int k) const { return entry_[k + 1].column; }
  double value(int k) const { return entry_[k + 1].value; }

  void clear()
  {
    for(int k = 1; k <= size_; ++k) {
      position_.get()[entry_[k].column] = 0;
      entry_[k].value = 0;
    }
    size_ = 0;
  }

private:
  struct Entry {
    int column;
    double value;
  };
  std::unique_ptr<int[], void (*)(void*)> position_;
  std::vector<Entry> entry_; // the first one is not used; beyond the last one, values are 0
  int size_ = 0;
};

/// Builds a sparse matrix in parallel, part by part: `append_rows(begin, end, rows)` appends the rows from `begin` to
/// `end` to `rows`, a matrix of its own.
template <class AppendRows>
Sparse_matrix build_rows(const Host_loop& loop, int n, AppendRows append_rows)
{
  constexpr int parts_per_thread = 4;
  constexpr int rows_per_part = 256;
  const int threads = loop.concurrency();
  const int parts = threads == 1 ? 1 : (std::min)(parts_per_thread * threads, n / rows_per_part + 1);
  const auto begin = [&](int part) { return static_cast<int>(static_cast<long long>(n) * part / parts); };
  std::vector<Sparse_matrix> rows_of(parts);
  loop.for_each(parts, [&](int part) { append_rows(begin(part), begin(part + 1), rows_of[part]); });

  if(parts == 1)
    return std::move(rows_of[0]);

  std::vector<int> first(parts + 1, 0);
  for(int part = 0; part < parts; ++part)
    first[part + 1] = first[part] + static_cast<int>(rows_of[part].column.size());
  Sparse_matrix result;
  result.offset.resize(n + 1);
  result.column.resize(first[parts]);
  result.value.resize(first[parts]);
  loop.for_each(parts, [&](int part) {
    const Sparse_matrix rows = std::move(rows_of[part]);
    for(int i = 1; i <= rows.rows(); ++i)
      result.offset[begin(part) + i] = first[part] + rows.offset[i];
    std::copy(rows.column.begin(), rows.column.end(), result.column.begin() + first[part]);
    std::copy(rows.value.begin(), rows.value.end(), result.value.begin() + first[part]);
  });
  return result;
}

/// The transpose, rows of ascending columns. `columns`: how many the matrix has.
inline Sparse_matrix transposed(const Host_loop& loop, const Sparse_matrix& a, int columns)
{
  // Every part of the rows counts its entries by column; from the counts each part knows where its own go.
  constexpr int rows_per_part = 65536;
  const int n = a.rows();
  const int parts = (std::min)(loop.concurrency(), n / rows_per_part + 1);
  const auto begin = [&](int part) { return static_cast<int>(static_cast<long long>(n) * part / parts); };
  std::vector<Host_array<int>> position(parts);
  loop.for_each(parts, [&](int part) {
    position[part].assign(columns, 0);
    for(int k = a.offset[begin(part)]; k < a.offset[begin(part + 1)]; ++k)
      ++position[part][a.column[k]];
  });
  Sparse_matrix t;
  t.offset.resize(columns + 1);
  int total = 0;
  for(int c = 0; c < columns; ++c) {
    for(int part = 0; part < parts; ++part)
      total += std::exchange(position[part][c], total);
    t.offset[c + 1] = total;
  }
  t.column.resize(total);
  t.value.resize(total);
  loop.for_each(parts, [&](int part) {
    for(int r = begin(part); r < begin(part + 1); ++r)
      for(int k = a.offset[r]; k < a.offset[r + 1]; ++k) {
        const int at = position[part][a.column[k]]++;
        t.column[at] = r;
        t.value[at] = a.value[k];
      }
  });
  return t;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MULTIGRID_SPARSE_ROWS_H
