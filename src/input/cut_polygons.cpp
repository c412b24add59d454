// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/mesh_readers.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tool {
namespace {

using Vector = std::array<double, 3>;

/// Twice the vector area of a triangle.
Vector normal(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// Ear clipping, of Meisters (1975): "Polygons have ears". A corner is cut off if its triangle is not folded back and
/// has no other corner in it, as seen along the axis that is nearest to the polygon's normal. A polygon that is not
/// simple may have no such corner left, and loses any one. Libraries that do it leave out corners on straight lines,
/// which neighbours have.
class Ear_clipping {
public:
  Ear_clipping(const std::vector<Vector>& points, const std::vector<int>& corners, const Vector& normal)
    : point_(corners.size()), before_(corners.size()), after_(corners.size()), order_(corners.size()),
      is_left_(corners.size(), 1)
  {
    std::size_t axis = 0;
    for(std::size_t k = 0; k < 3; ++k)
      if(std::abs(normal[k]) > std::abs(normal[axis]))
        axis = k;
    const double side = normal[axis] < 0 ? -1 : 1; // from which the polygon is seen
    for(std::size_t i = 0; i < corners.size(); ++i) {
      const Vector& p = points[static_cast<std::size_t>(corners[i])];
      point_[i] = {p[(axis + 1) % 3], side * p[(axis + 2) % 3]};
    }
    std::iota(before_.begin() + 1, before_.end(), 0);
    std::iota(after_.begin(), after_.end() - 1, 1);
    before_.front() = corners.size() - 1;
    after_.back() = 0;
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](std::size_t i, std::size_t j) { return point_[i][0] < point_[j][0]; });
  }

  /// Of n corners, `use(i, j, k)` is called for n - 2 triangles.
  template <class Use>
  void clip(Use use)
  {
    std::size_t corner = 1, refused = 0;
    for(std::size_t left = point_.size(); left > 2;) {
      if(left > 3 && refused < left && !is_ear(corner)) {
        ++refused;
        corner = after_[corner];
        continue;
      }
      const std::size_t before = before_[corner], after = after_[corner];
      use(before, corner, after);
      is_left_[corner] = 0;
      after_[before] = after;
      before_[after] = before;
      corner = after_[after]; // not the next one: ears in turn make triangles less thin
      refused = 0;
      --left;
    }
  }

private:
  using Point = std::array<double, 2>;

  /// Twice the area of a triangle.
  static double area(const Point& a, const Point& b, const Point& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  bool is_ear(std::size_t corner) const
  {
    const Point &a = point_[before_[corner]], &b = point_[corner], &c = point_[after_[corner]];
    if(!(area(a, b, c) > 0))
      return false;
    const auto [least, largest] = std::minmax({a[0], b[0], c[0]});
    auto i =
      std::lower_bound(order_.begin(), order_.end(), least, [&](std::size_t j, double x) { return point_[j][0] < x; });
    for(; i != order_.end() && point_[*i][0] <= largest; ++i) {
      const Point& p = point_[*i];
      const bool is_corner = p == a || p == b || p == c; // or at its place, where a polygon is cut open to its holes
      if(is_left_[*i] && !is_corner && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0)
        return false;
    }
    return true;
  }

  std::vector<Point> point_;                ///< in the projection, counterclockwise
  std::vector<std::size_t> before_, after_; ///< of the corners that are left
  std::vector<std::size_t> order_;          ///< from left to right
  std::vector<char> is_left_;
};

} // namespace

void cut_polygons(Soup& soup)
{
  std::vector<int> corners;
  auto fan = soup.triangles.begin();
  std::size_t face = 0;
  for(const Soup::Polygon& polygon : soup.polygons) {
    fan += static_cast<std::ptrdiff_t>(polygon.face - face);
    const auto end = fan + static_cast<std::ptrdiff_t>(polygon.corners - 2);
    Vector sum = {};
    const auto normal_of = [&](const std::array<int, 3>& triangle) {
      return normal(soup.points[static_cast<std::size_t>(triangle[0])],
                    soup.points[static_cast<std::size_t>(triangle[1])],
                    soup.points[static_cast<std::size_t>(triangle[2])]);
    };
    for(auto triangle = fan; triangle != end; ++triangle) {
      const Vector n = normal_of(*triangle);
      sum = {sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]};
    }
    const bool is_right = std::none_of(fan, end, [&](const std::array<int, 3>& triangle) {
      const Vector n = normal_of(triangle);
      return n[0] * sum[0] + n[1] * sum[1] + n[2] * sum[2] < 0;
    });
    if(!is_right) {
      corners = {(*fan)[0], (*fan)[1]};
      for(auto triangle = fan; triangle != end; ++triangle)
        corners.push_back((*triangle)[2]);
      auto triangle = fan;
      Ear_clipping(soup.points, corners, sum).clip([&](std::size_t i, std::size_t j, std::size_t k) {
        *triangle++ = {corners[i], corners[j], corners[k]};
      });
    }
    fan = end;
    face = polygon.face + 1;
  }
}

} // namespace tool
