// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/sampled_hausdorff.h"

#include "preparation/points.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using SP::internal::Host_loop;
using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Points = std::vector<Point_3>;
using Faces = std::vector<std::array<int, 3>>;

Points scaled(const std::vector<Point>& points, double unit)
{
  Points result;
  result.reserve(points.size());
  for(const Point& p : points)
    result.emplace_back(p[0] / unit, p[1] / unit, p[2] / unit);
  return result;
}

/// A binary tree of boxes: those of a few faces that follow each other, and the boxes of two boxes.
class Boxes {
public:
  Boxes(const Host_loop& loop, const Faces& faces, const Points& points) : faces_(faces), points_(points)
  {
    while(leaves_ * faces_of_leaf < static_cast<int>(faces.size()))
      leaves_ *= 2;
    box_.resize(place(2 * leaves_));
    SP::internal::for_each_index(loop, leaves_, [&](int i) {
      for_each_face(leaves_ + i, [&](const std::array<int, 3>& face) {
        for(const int v : face)
          for(int k = 0; k < 3; ++k)
            box_[place(leaves_ + i)].add(k, points[place(v)][k], points[place(v)][k]);
      });
    });
    for(int first = leaves_ / 2; first > 0; first /= 2)
      SP::internal::for_each_index(loop, first, [&](int i) {
        Box& box = box_[place(first + i)];
        for(const int child : {2 * (first + i), 2 * (first + i) + 1})
          for(int k = 0; k < 3; ++k)
            box.add(k, box_[place(child)].low[place(k)], box_[place(child)].high[place(k)]);
      });
  }

  /// The square of the distance from the faces if that is above `enough`, else something that is not.
  /// \param bound  of the result
  double squared_distance(const Point_3& p, double bound, double enough) const
  {
    std::array<std::pair<double, int>, 64> stack; // the tree has at most 31 levels
    std::size_t size = 0;
    stack[size++] = {box_[1].squared_distance(p), 1};
    while(size > 0 && bound > enough) {
      const auto [square, node] = stack[--size];
      if(!(square < bound))
        continue;
      if(node >= leaves_) {
        for_each_face(node, [&](const std::array<int, 3>& face) {
          const Kernel::Triangle_3 triangle(points_[place(face[0])], points_[place(face[1])], points_[place(face[2])]);
          bound = (std::min)(bound, CGAL::to_double(CGAL::squared_distance(p, triangle)));
        });
        continue;
      }
      const auto entry = [&](int child) { return std::make_pair(box_[place(child)].squared_distance(p), child); };
      auto nearer = entry(2 * node), farther = entry(2 * node + 1);
      if(farther < nearer)
        std::swap(nearer, farther);
      stack[size++] = farther;
      stack[size++] = nearer;
    }
    return bound;
  }

private:
  static constexpr int faces_of_leaf = 4;

  struct Box {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    std::array<double, 3> low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};

    void add(int k, double from, double to)
    {
      low[place(k)] = (std::min)(low[place(k)], from);
      high[place(k)] = (std::max)(high[place(k)], to);
    }
    double squared_distance(const Point_3& p) const
    {
      double sum = 0;
      for(int k = 0; k < 3; ++k) {
        const double side = (std::max)({low[place(k)] - p[k], 0., p[k] - high[place(k)]});
        sum += side * side;
      }
      return sum;
    }
  };

  template <class F>
  void for_each_face(int leaf, F f) const
  {
    const auto begin = place(leaf - leaves_) * faces_of_leaf;
    for(std::size_t i = begin; i < (std::min)(begin + faces_of_leaf, faces_.size()); ++i)
      f(faces_[i]);
  }

  const Faces& faces_;
  const Points& points_;
  int leaves_ = 1;
  std::vector<Box> box_; ///< from 1 on, the root; the children of k are 2k and 2k + 1
};

} // namespace

Sampled_hausdorff::Sampled_hausdorff(const Mesh& mesh, const std::vector<Point>& points, bool on_all_cores)
  : loop_(on_all_cores), points_(points)
{
  const Points corner = scaled(points, 1);
  Points centre;
  centre.reserve(mesh.number_of_faces());
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto [a, b, c] = mesh.triangle(f);
    centre.push_back(CGAL::centroid(corner[place(a)], corner[place(b)], corner[place(c)]));
  }
  std::vector<std::size_t> order(centre.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto map = CGAL::make_property_map(centre);
  CGAL::hilbert_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(map)>(map));
  faces_.reserve(order.size());
  for(const std::size_t f : order)
    faces_.push_back(mesh.triangle(f));
}

double Sampled_hausdorff::distance(const std::vector<Point>& others) const
{
  const double unit = unit_of((std::max)(largest_coordinate(points_), largest_coordinate(others)));
  const Points a = scaled(points_, unit), b = scaled(others, unit);
  const int n = static_cast<int>(a.size());
  std::vector<std::pair<double, int>> bounds(a.size());
  SP::internal::for_each_index(loop_, n, [&](int v) {
    bounds[place(v)] = {CGAL::squared_distance(a[place(v)], b[place(v)]), v};
  });
  std::sort(bounds.begin(), bounds.end(), std::greater<>());

  double square = 0;
  for(const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const Boxes boxes(loop_, faces_, *to);
    int size = 256; // together: their results are known to the next ones
    for(int begin = 0; begin < n && bounds[place(begin)].first > square;
        begin += size, size = (std::min)(2 * size, n)) {
      const auto farthest =
        SP::internal::results_of_parts<64>(loop_, (std::min)(size, n - begin), [&, from = from](int first, int last) {
          double result = square;
          for(int i = begin + first; i < begin + last; ++i) {
            const auto& [bound, v] = bounds[place(i)];
            result = (std::max)(result, boxes.squared_distance((*from)[place(v)], bound, result));
          }
          return result;
        });
      square = *std::max_element(farthest.begin(), farthest.end());
    }
  }
  return unit * std::sqrt(square);
}

} // namespace tool
