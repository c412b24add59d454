// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INVERSE_KD_TREE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INVERSE_KD_TREE_H

#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// A balanced tree of points that finds some point near another one: the nearest of those in its leaf, which is not
/// always the nearest of all. That is enough to start a walk, and takes one way down the tree.
class Kd_tree {
public:
  /// \param points  at least one
  explicit Kd_tree(const std::vector<vec3>& points) : order_(points.size())
  {
    std::iota(order_.begin(), order_.end(), 0);
    std::size_t nodes = 0;
    for(std::size_t size = points.size(); size > leaf_size; size = (size + 1) / 2)
      nodes = 2 * nodes + 1;
    nodes_.resize(nodes);
    split(points, 0, 0, order_.size());
  }

  /// The points in the order of the leaves: what is near in space is mostly near in this order.
  const std::vector<int>& order() const { return order_; }

  /// The position in `order()` of a point near `q`. `sorted` has the points in that order.
  int near(vec3 q, const std::vector<vec3>& sorted) const
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
    for(std::size_t i = begin; i < end; ++i) {
      const vec3 d = sub(sorted[i], q);
      if(inner(d, d) < least) {
        least = inner(d, d);
        best = static_cast<int>(i);
      }
    }
    return best;
  }

private:
  static constexpr std::size_t leaf_size = 6;

  struct Node {
    float value = 0; // as good for a start, and half the memory to go through
    int axis = 0;
  };

  static double coordinate(vec3 p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

  void split(const std::vector<vec3>& points, std::size_t node, std::size_t begin, std::size_t end)
  {
    if(node >= nodes_.size() || end - begin <= leaf_size)
      return;
    double extent = -1;
    for(int axis = 0; axis < 3; ++axis) {
      const auto range = std::minmax_element(order_.begin() + begin, order_.begin() + end, [&](int i, int j) {
        return coordinate(points[i], axis) < coordinate(points[j], axis);
      });
      const double size = coordinate(points[*range.second], axis) - coordinate(points[*range.first], axis);
      if(size > extent) {
        extent = size;
        nodes_[node].axis = axis;
      }
    }
    const std::size_t middle = begin + (end - begin) / 2;
    const int axis = nodes_[node].axis;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](int i, int j) { return coordinate(points[i], axis) < coordinate(points[j], axis); });
    nodes_[node].value = static_cast<float>(coordinate(points[order_[middle]], axis));
    split(points, 2 * node + 1, begin, middle);
    split(points, 2 * node + 2, middle, end);
  }

  std::vector<int> order_;
  std::vector<Node> nodes_; ///< the children of node i are 2i+1 and 2i+2
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_INVERSE_KD_TREE_H
