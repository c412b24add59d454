// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_KD_TREE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_KD_TREE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A balanced tree of points that finds some point near another one: the nearest of those in its leaf, which is not
/// always the nearest of all. That is enough to start a walk, and takes one way down the tree.
class Kd_tree {
public:
  /// \param points  at least one
  Kd_tree(const Host_loop& loop, const Host_array<vec3>& points) : order_(points.size())
  {
    std::iota(order_.begin(), order_.end(), 0);
    std::size_t nodes = 0;
    for(std::size_t size = points.size(); size > leaf_size; size = (size + 1) / 2)
      nodes = 2 * nodes + 1;
    nodes_.resize(nodes);
    // Level by level, the nodes of a level on different threads.
    std::vector<Range> level = {{0, order_.size()}};
    for(std::size_t first = 0; first < nodes; first = 2 * first + 1) {
      std::vector<Range> next(2 * level.size());
      loop.for_each(static_cast<int>(level.size()), [&](int i) {
        const Range range = level[i];
        if(range.end - range.begin <= leaf_size)
          return;
        const std::size_t middle = split(points, nodes_[first + i], range);
        next[2 * i] = {range.begin, middle};
        next[2 * i + 1] = {middle, range.end};
      });
      level.swap(next);
    }
  }

  /// The points in the order of the leaves: what is near in space is mostly near in this order.
  const std::vector<int>& order() const { return order_; }

  /// The position in `order()` of a point near `q`. `sorted` has the points in that order.
  int near(vec3 q, const Host_array<vec3>& sorted) const
  {
    std::size_t node = 0, begin = 0, end = order_.size();
    while(node < nodes_.size() && end - begin > leaf_size) {
      const std::size_t middle = begin + (end - begin) / 2;
      const bool is_below = coordinate(q, nodes_[node].axis) < nodes_[node].value;
      node = 2 * node + (is_below ? 1 : 2);
      (is_below ? end : begin) = middle;
    }
    int best = static_cast<int>(begin);
    double least = std::numeric_limits<double>::infinity();
    for(std::size_t i = begin; i < end; ++i)
      if(const double square = squared_distance(sorted[i], q); square < least) {
        least = square;
        best = static_cast<int>(i);
      }
    return best;
  }

private:
  static constexpr std::size_t leaf_size = 6;

  struct Node {
    float value = 0; // as good for a start, and half the memory to go through
    int axis = 0;
  };

  struct Range {
    std::size_t begin = 0, end = 0;
  };

  static double coordinate(vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

  /// Returns where the second half begins.
  std::size_t split(const Host_array<vec3>& points, Node& node, Range range)
  {
    const auto begin = order_.begin() + range.begin, end = order_.begin() + range.end;
    double extent = -1;
    for(int axis = 0; axis < 3; ++axis) {
      const auto extremes = std::minmax_element(
        begin, end, [&](int i, int j) { return coordinate(points[i], axis) < coordinate(points[j], axis); });
      const double size = coordinate(points[*extremes.second], axis) - coordinate(points[*extremes.first], axis);
      if(size > extent) {
        extent = size;
        node.axis = axis;
      }
    }
    const std::size_t middle = range.begin + (range.end - range.begin) / 2;
    std::nth_element(begin, order_.begin() + middle, end,
                     [&](int i, int j) { return coordinate(points[i], node.axis) < coordinate(points[j], node.axis); });
    node.value = static_cast<float>(coordinate(points[order_[middle]], node.axis));
    return middle;
  }

  std::vector<int> order_;
  std::vector<Node> nodes_; ///< the children of node i are 2i+1 and 2i+2
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_KD_TREE_H
