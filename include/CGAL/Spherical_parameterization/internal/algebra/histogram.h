// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_HISTOGRAM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_HISTOGRAM_H

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Where a value is shared between two bins whose centres are nearest, so that a small change of the value is a small
/// change of the histogram.
struct Place_between_bins {
  std::size_t bin; ///< there is another one behind it
  double share;    ///< of that

  /// \param position  from 0 to the number of bins, which is 2 or more; what lies outside counts in the first or last
  /// bin
  Place_between_bins(double position, std::size_t bins)
  {
    const double last = static_cast<double>(bins) - 1, x = std::clamp(position - 0.5, 0., last);
    const double floor = (std::min)(std::floor(x), last - 1);
    bin = static_cast<std::size_t>(floor);
    share = x - floor;
  }
};

/// A weighted histogram of equal bins over [low, high]; what lies outside counts in the first or the last bin.
class Histogram {
public:
  /// \pre bins >= 2, low < high, and both are finite
  Histogram(std::size_t bins, double low, double high)
    : low_(low), width_((high - low) / static_cast<double>(bins)), bins_(bins, 0.)
  {}

  void add(double value, double weight)
  {
    bins_[static_cast<std::size_t>(std::clamp(std::floor(position(value)), 0., last()))] += weight;
  }

  void add_interpolated(double value, double weight)
  {
    const Place_between_bins place(position(value), bins_.size());
    bins_[place.bin] += weight * (1 - place.share);
    bins_[place.bin + 1] += weight * place.share;
  }

  /// The weights of the bins over their sum.
  std::vector<double> shares() const
  {
    const double total = std::accumulate(bins_.begin(), bins_.end(), 0.);
    std::vector<double> result = bins_;
    for(double& weight : result)
      weight /= total;
    return result;
  }

private:
  double position(double value) const { return (value - low_) / width_; }
  double last() const { return static_cast<double>(bins_.size()) - 1; }

  double low_, width_;
  std::vector<double> bins_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ALGEBRA_HISTOGRAM_H
