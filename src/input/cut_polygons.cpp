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
    : points_(points), corners_(corners), before_(corners.size()), after_(corners.size())
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(std::abs(normal[k]) > std::abs(normal[axis_]))
        axis_ = k;
    is_seen_from_behind_ = normal[axis_] < 0;
    std::iota(before_.begin() + 1, before_.end(), 0);
    std::iota(after_.begin(), after_.end() - 1, 1);
    before_.front() = static_cast<int>(corners.size()) - 1;
    after_.back() = 0;
  }

  /// Of n corners, `use(triangle)` is called for n - 2 triangles.
  template <class Use>
  void clip(Use use)
  {
    int corner = 1, refused = 0;
    for(int left = static_cast<int>(corners_.size()); left > 2;) {
      if(left > 3 && refused < left && !is_ear(corner)) {
        ++refused;
        corner = after_[corner];
        continue;
      }
      const int before = before_[corner], after = after_[corner];
      use({corners_[before], corners_[corner], corners_[after]});
      after_[before] = after;
      before_[after] = before;
      corner = after_[after]; // not the next one: ears in turn make triangles less thin
      refused = 0;
      --left;
    }
  }

private:
  const Vector& point(int corner) const { return points_[static_cast<std::size_t>(corners_[corner])]; }

  /// Twice the area of a triangle in the projection.
  double area(int a, int b, int c) const
  {
    const double area = normal(point(a), point(b), point(c))[axis_];
    return is_seen_from_behind_ ? -area : area;
  }

  bool is_ear(int b) const
  {
    const int a = before_[b], c = after_[b];
    if(!(area(a, b, c) > 0))
      return false;
    for(int d = after_[c]; d != a; d = after_[d])
      if(area(a, b, d) >= 0 && area(b, c, d) >= 0 && area(c, a, d) >= 0 && point(d) != point(a) &&
         point(d) != point(b) && point(d) != point(c)) // which are the same in a polygon cut open to its holes
        return false;
    return true;
  }

  const std::vector<Vector>& points_;
  const std::vector<int>& corners_;
  std::vector<int> before_, after_; ///< of the corners that are left
  std::size_t axis_ = 0;
  bool is_seen_from_behind_ = false;
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
      Ear_clipping(soup.points, corners, sum).clip([&](const std::array<int, 3>& ear) { *triangle++ = ear; });
    }
    fan = end;
    face = polygon.face + 1;
  }
}

} // namespace tool
