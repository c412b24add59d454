// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <boost/functional/hash.hpp>

#include <array>
#include <unordered_map>
#include <vector>

namespace tool {

/// Numbers the different points, in the order in which they appear first.
class Welded_points {
public:
  using Point = std::array<double, 3>;

  /// \param points  where they go, each once
  explicit Welded_points(std::vector<Point>& points) : points_(points) {}

  int index_of(const Point& p)
  {
    if(p != p) { // NaN is nowhere, and all points with one would be compared with each other
      points_.push_back(p);
      return static_cast<int>(points_.size()) - 1;
    }
    const auto [place, is_new] = index_.try_emplace(p, static_cast<int>(points_.size()));
    if(is_new)
      points_.push_back(p);
    return place->second;
  }

private:
  std::vector<Point>& points_;
  std::unordered_map<Point, int, boost::hash<Point>> index_;
};

} // namespace tool
