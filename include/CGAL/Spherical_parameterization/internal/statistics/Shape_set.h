// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SHAPE_SET_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SHAPE_SET_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Shapes that correspond, as arrays of vectors: of the vertices, or of the coefficients of three functions. Refers to
/// the arrays of the caller. The mean of squares is the weighted sum of those of the entries. `Number`: double, or
/// const double.
template <class Number>
class Shape_set {
public:
  /// \param first              by shape: x of its first entry
  /// \param entries            of a shape
  /// \param entry_stride       from an entry to the next one
  /// \param coordinate_stride  from x to y to z
  /// \param weights            by entry, or one for all of them
  Shape_set(std::vector<Number*> first, int entries, std::ptrdiff_t entry_stride, std::ptrdiff_t coordinate_stride,
            const std::vector<double>& weights)
    : first_(std::move(first)), entries_(entries), entry_stride_(entry_stride), coordinate_stride_(coordinate_stride),
      weights_(weights)
  {}

  int size() const { return static_cast<int>(first_.size()); }
  int entries() const { return entries_; }
  double weight(int j) const { return weights_[weights_.size() == 1 ? 0 : static_cast<std::size_t>(j)]; }

  Number& operator()(int shape, int entry, int coordinate) const
  {
    return first_[static_cast<std::size_t>(shape)][entry * entry_stride_ + coordinate * coordinate_stride_];
  }

  vec3 get(int shape, int entry) const
  {
    return {(*this)(shape, entry, 0), (*this)(shape, entry, 1), (*this)(shape, entry, 2)};
  }

  void put(int shape, int entry, vec3 p) const
  {
    (*this)(shape, entry, 0) = p.x;
    (*this)(shape, entry, 1) = p.y;
    (*this)(shape, entry, 2) = p.z;
  }

private:
  std::vector<Number*> first_;
  int entries_;
  std::ptrdiff_t entry_stride_, coordinate_stride_;
  const std::vector<double>& weights_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_SHAPE_SET_H
