// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_RAY_TREE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_RAY_TREE_H

#include <CGAL/Spherical_parameterization/internal/algebra/Bounding_box.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

struct Ray {
  vec3 origin, direction;
};

/// A balanced tree of the triangles of a surface in boxes, which finds the first one that a ray meets. In doubles: a
/// ray through an edge may slip between two triangles, which does not matter to those who count many rays.
class Ray_tree {
public:
  /// \param points  finite; they and the faces are kept by reference
  Ray_tree(const Host_array<vec3>& points, const Host_array<std::array<int, 3>>& faces)
    : points_(points), faces_(faces), order_(faces.size())
  {
    std::iota(order_.begin(), order_.end(), 0);
    std::vector<vec3> centre;
    centre.reserve(faces.size());
    for(const auto& [a, b, c] : faces)
      centre.push_back(add(add(points[a], points[b]), points[c]));
    nodes_.reserve(2 * faces.size() / leaf_size + 1);
    if(!order_.empty())
      add_node(centre, 0, order_.size());
  }

  /// The first face that the ray meets beyond its origin, but for `own`; -1 if there is none.
  int first_hit(const Ray& ray, int own) const
  {
    const vec3 inverse = {1 / ray.direction.x, 1 / ray.direction.y, 1 / ray.direction.z};
    double nearest = std::numeric_limits<double>::infinity();
    int hit = -1;
    std::size_t i = 0;
    while(i < nodes_.size()) {
      const Node& node = nodes_[i];
      if(!node.is_met(ray.origin, inverse, nearest)) {
        i = node.next;
        continue;
      }
      if(node.next == ++i) // a leaf
        for(std::size_t k = node.begin; k < node.end; ++k) {
          const int f = order_[k];
          const double distance = f == own ? -1 : distance_to(f, ray);
          if(distance > 0 && (distance < nearest || (distance == nearest && f < hit))) {
            nearest = distance;
            hit = f;
          }
        }
    }
    return hit;
  }

private:
  static constexpr std::size_t leaf_size = 4;

  /// In the order in which a walk meets the nodes.
  struct Node {
    Bounding_box box;
    std::size_t begin, end; ///< its faces, in `order_`
    std::size_t next;       ///< the first node that is not below this one

    bool is_met(vec3 origin, vec3 inverse, double nearest) const
    {
      double from = 0, to = nearest;
      const auto clip = [&](double l, double h, double o, double i) {
        const double a = (l - o) * i, b = (h - o) * i;
        if(a <= b || b <= a) { // else one is not a number: the ray runs in the plane of a side
          from = (std::max)(from, (std::min)(a, b));
          to = (std::min)(to, (std::max)(a, b));
        }
      };
      clip(box.low.x, box.high.x, origin.x, inverse.x);
      clip(box.low.y, box.high.y, origin.y, inverse.y);
      clip(box.low.z, box.high.z, origin.z, inverse.z);
      return from <= to;
    }
  };

  void add_node(const std::vector<vec3>& centre, std::size_t begin, std::size_t end)
  {
    std::vector<vec3> corners;
    corners.reserve(3 * (end - begin));
    for(std::size_t i = begin; i < end; ++i)
      for(const int v : faces_[order_[i]])
        corners.push_back(points_[v]);
    const std::size_t node = nodes_.size();
    nodes_.push_back({Bounding_box(corners), begin, end, 0});
    if(end - begin > leaf_size) {
      const vec3 size = sub(nodes_[node].box.high, nodes_[node].box.low);
      const auto coordinate = [&](int f) {
        const vec3 c = centre[f];
        return size.x >= size.y && size.x >= size.z ? c.x : size.y >= size.z ? c.y : c.z;
      };
      const auto middle = order_.begin() + (begin + end) / 2;
      std::nth_element(order_.begin() + begin, middle, order_.begin() + end, [&](int f, int g) {
        return coordinate(f) != coordinate(g) ? coordinate(f) < coordinate(g) : f < g;
      });
      add_node(centre, begin, (begin + end) / 2);
      add_node(centre, (begin + end) / 2, end);
    }
    nodes_[node].next = nodes_.size();
  }

  /// To the triangle, in lengths of the direction; -1 where it is not met. T. Möller and B. Trumbore, "Fast, minimum
  /// storage ray/triangle intersection", 1997.
  double distance_to(int f, const Ray& ray) const
  {
    const auto [a, b, c] = faces_[f];
    const vec3 ab = sub(points_[b], points_[a]), ac = sub(points_[c], points_[a]);
    const vec3 p = outer(ray.direction, ac), to_origin = sub(ray.origin, points_[a]), q = outer(to_origin, ab);
    const double determinant = inner(ab, p);
    const double u = inner(to_origin, p) / determinant, v = inner(ray.direction, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 ? inner(ac, q) / determinant : -1; // no comparison holds for a NaN
  }

  const Host_array<vec3>& points_;
  const Host_array<std::array<int, 3>>& faces_;
  std::vector<int> order_;
  std::vector<Node> nodes_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_RAY_TREE_H
