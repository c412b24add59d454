// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_SCATTERED_POINTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_SCATTERED_POINTS_H

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/Grid_transform.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Points of the sphere over an `Angular_grid`, each with its kernel's values: 14 by 14 numbers round a point make a
/// value, and the transposed map spreads the value over them.
///
/// Points are sorted by bands of rows, as high as the kernel is wide. Every second band may be spread at once, since no
/// two of them share a row; so sums do not depend on the number of threads. 240 bytes per point.
class Scattered_points {
public:
  /// \param direction  not zero
  template <class Loop>
  Scattered_points(const Loop& loop, const Angular_grid& grid, const Host_array<vec3>& direction)
    : n_(static_cast<int>(direction.size())), place_(direction.size()), weight_(direction.size())
  {
    Host_array<Place> place(direction.size());
    for_each_index<1024>(loop, n_, [&](int i) { place[i] = place_of(grid.n, i, direction[i]); });
    const int bands = (grid.n / 2 + 1) / Kernel::width + 1;
    const auto order = sorted_by_key(n_, bands, band_begin_, [&](int i) { return band(place[i]); });
    for_each_index<1024>(loop, n_, [&](int i) {
      place_[i] = place[order[i]];
      const auto [row, column] = position(grid.n, direction[place_[i].point]);
      for(int j = 0; j < Kernel::width; ++j) {
        weight_[i].row[j] = Kernel::value(row - (place_[i].row + j));
        weight_[i].column[j] = Kernel::value(column - (place_[i].column + j));
      }
    });
  }

  /// The values at the points, field after field.
  template <class Loop>
  void interpolate(const Loop& loop, const Angular_grid& grid, double* values) const
  {
    for_each_index<1024>(loop, n_, [&](int i) {
      const Place& place = place_[i];
      const Weights& weight = weight_[i];
      for(int field = 0; field < grid.fields; ++field) {
        std::array<double, Kernel::width> sum = {};
        const double* row = grid.row(field, place.row) + place.column + Kernel::half_width;
        for(int j = 0; j < Kernel::width; ++j, row += grid.columns())
          for(int k = 0; k < Kernel::width; ++k)
            sum[k] += weight.row[j] * row[k];
        double value = 0;
        for(int k = 0; k < Kernel::width; ++k)
          value += weight.column[k] * sum[k];
        values[static_cast<std::size_t>(field) * n_ + place.point] = value;
      }
    });
  }

  /// Adds the values, field after field, to the grid.
  template <class Loop>
  void spread(const Loop& loop, const double* values, Angular_grid& grid) const
  {
    constexpr int at_a_time = 1 << 14; // points of a band, so that a watched loop is not kept waiting
    const int bands = static_cast<int>(band_begin_.size()) - 1;
    int longest = 0;
    for(int b = 0; b < bands; ++b)
      longest = (std::max)(longest, band_begin_[b + 1] - band_begin_[b]);
    const int passes = (longest + at_a_time - 1) / at_a_time;
    for(int pass = 0; pass < 2 * passes; ++pass) {
      const int parity = pass / passes;
      loop.for_each((bands + 1 - parity) / 2, [&](int b) {
        const int band = 2 * b + parity, begin = band_begin_[band] + pass % passes * at_a_time;
        for(int i = begin; i < (std::min)(band_begin_[band + 1], begin + at_a_time); ++i) {
          const Place& place = place_[i];
          const Weights& weight = weight_[i];
          for(int field = 0; field < grid.fields; ++field) {
            const double value = values[static_cast<std::size_t>(field) * n_ + place.point];
            std::array<double, Kernel::width> share;
            for(int k = 0; k < Kernel::width; ++k)
              share[k] = value * weight.column[k];
            double* row = grid.row(field, place.row) + place.column + Kernel::half_width;
            for(int j = 0; j < Kernel::width; ++j, row += grid.columns())
              for(int k = 0; k < Kernel::width; ++k)
                row[k] += weight.row[j] * share[k];
          }
        }
      });
    }
  }

private:
  struct Place {
    int point, row, column; ///< the first row and column of its kernel
  };
  struct Weights {
    std::array<double, Kernel::width> row, column;
  };

  /// In rows and columns of the grid.
  static std::array<double, 2> position(int n, vec3 p)
  {
    const double longitude = std::atan2(p.y, p.x);
    const double latitude = std::atan2(std::sqrt(p.x * p.x + p.y * p.y), p.z);
    return {latitude * (n / (2 * pi)), (longitude < 0 ? longitude + 2 * pi : longitude) * (n / (2 * pi))};
  }

  static Place place_of(int n, int point, vec3 p)
  {
    const auto [row, column] = position(n, p);
    const auto first = [](double x, int largest) {
      return (std::min)(static_cast<int>(std::ceil(x - Kernel::half_width)), largest);
    };
    return {point, first(row, n / 2 - Kernel::half_width), first(column, n - Kernel::half_width)};
  }

  static int band(const Place& p) { return (p.row + Kernel::half_width) / Kernel::width; }

  int n_;
  Host_array<Place> place_; ///< band after band
  Host_array<Weights> weight_;
  std::vector<int> band_begin_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_SCATTERED_POINTS_H
