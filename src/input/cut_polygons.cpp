// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/mesh_readers.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <numeric>

namespace tool {
namespace {

using Vector = std::array<double, 3>;
using Point_2 = std::array<double, 2>;

/// Twice the vector area of a triangle.
Vector normal(const Vector& a, const Vector& b, const Vector& c)
{
  const Vector u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

double product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Of triangles whose height is less than this part of their longest side, one cannot say where they turn: three
/// corners on a straight line, rounded to floats.
constexpr double flat = 1e-5;

template <std::size_t N>
double longest_squared_side(const std::array<double, N>& a, const std::array<double, N>& b,
                            const std::array<double, N>& c)
{
  double ab = 0, bc = 0, ca = 0;
  for(std::size_t k = 0; k < N; ++k) {
    ab += (a[k] - b[k]) * (a[k] - b[k]);
    bc += (b[k] - c[k]) * (b[k] - c[k]);
    ca += (c[k] - a[k]) * (c[k] - a[k]);
  }
  return std::max({ab, bc, ca});
}

/// Ear clipping, of Meisters (1975): "Polygons have ears". A corner is cut off if its triangle is not folded back and
/// has no other corner in it, as seen along the axis that is nearest to the polygon's normal, and first those that are
/// not flat. Where there is no such corner left, since the polygon is not simple, the rest becomes a fan; so it does
/// where too many looks at other corners were taken. Libraries that do it leave out corners on straight lines, which
/// neighbours have.
class Ear_clipping {
public:
  /// \param looks  at other corners that may be taken, which are counted down
  Ear_clipping(const std::vector<Vector>& points, const Vector& normal, std::int64_t& looks)
    : looks_(looks), point_(points.size()), before_(points.size()), after_(points.size()), order_(points.size()),
      is_left_(points.size(), 1)
  {
    std::size_t axis = 0;
    for(std::size_t k = 0; k < 3; ++k)
      if(std::abs(normal[k]) > std::abs(normal[axis]))
        axis = k;
    const double side = normal[axis] < 0 ? -1 : 1; // from which the polygon is seen
    const auto project = [&](const Vector& p) { return Point_2{p[(axis + 1) % 3], side * p[(axis + 2) % 3]}; };
    std::transform(points.begin(), points.end(), point_.begin(), project);
    const auto [left, right] = std::minmax_element(point_.begin(), point_.end());
    const auto [low, high] =
      std::minmax_element(point_.begin(), point_.end(), [](const Point_2& a, const Point_2& b) { return a[1] < b[1]; });
    if((*high)[1] - (*low)[1] > (*right)[0] - (*left)[0]) // order_ is along the longer side
      for(Point_2& p : point_)
        p = {p[1], -p[0]};

    std::iota(before_.begin() + 1, before_.end(), 0);
    std::iota(after_.begin(), after_.end() - 1, 1);
    before_.front() = points.size() - 1;
    after_.back() = 0;
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](std::size_t i, std::size_t j) { return point_[i][0] < point_[j][0]; });
  }

  /// Of n corners, `use(i, j, k)` is called for n - 2 triangles.
  template <class Use>
  void clip(Use use)
  {
    std::size_t left = point_.size(), corner = 0;
    const auto cut = [&](std::size_t i) {
      use(before_[i], i, after_[i]);
      is_left_[i] = 0;
      after_[before_[i]] = after_[i];
      before_[after_[i]] = before_[i];
      corner = after_[i];
      --left;
    };
    std::deque<std::size_t> candidates; // first in, first out: ears in turn make triangles less thin
    bool is_flat_allowed = false;
    for(bool is_cut = true; left > 2 && (is_cut || !is_flat_allowed);) {
      is_flat_allowed = !std::exchange(is_cut, false); // what is flat is cut off where nothing else can be
      order_.erase(std::remove_if(order_.begin(), order_.end(), [&](std::size_t i) { return !is_left_[i]; }),
                   order_.end());
      for(std::size_t i = 0; i < left; ++i, corner = after_[corner])
        candidates.push_back(corner);
      for(; !candidates.empty() && left > 2; candidates.pop_front()) {
        const std::size_t i = candidates.front();
        if(!is_left_[i] || !is_ear(i, is_flat_allowed))
          continue;
        cut(i);
        is_cut = true;
        candidates.push_back(before_[i]); // which have new neighbours
        candidates.push_back(after_[i]);
      }
    }
    while(left > 2)
      cut(corner);
  }

private:
  /// Twice the area of a triangle.
  static double area(const Point_2& a, const Point_2& b, const Point_2& c)
  {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  }

  bool is_ear(std::size_t corner, bool is_flat_allowed)
  {
    const Point_2 &a = point_[before_[corner]], &b = point_[corner], &c = point_[after_[corner]];
    const double height = flat * longest_squared_side(a, b, c);
    if(!(area(a, b, c) > (is_flat_allowed ? 0 : height)))
      return false;
    const auto [least, largest] = std::minmax({a[0], b[0], c[0]});
    auto i =
      std::lower_bound(order_.begin(), order_.end(), least, [&](std::size_t j, double x) { return point_[j][0] < x; });
    for(; i != order_.end() && point_[*i][0] <= largest; ++i) {
      if(--looks_ < 0)
        return false;
      const Point_2& p = point_[*i];
      const bool is_corner = p == a || p == b || p == c; // or at its place, where a polygon is cut open to its holes
      if(is_left_[*i] && !is_corner && area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= -height)
        return false;
    }
    return true;
  }

  std::int64_t& looks_;
  std::vector<Point_2> point_;              ///< in the projection, counterclockwise
  std::vector<std::size_t> before_, after_; ///< of the corners that are left
  std::vector<std::size_t> order_;          ///< from left to right
  std::vector<char> is_left_;
};

} // namespace

void cut_polygons(Soup& soup)
{
  // a second of work or two, which polygons of 10,000 corners do not need, and something for each corner
  std::int64_t looks = 200'000'000 + 300 * static_cast<std::int64_t>(soup.triangles.size());
  std::vector<int> corners;
  std::vector<Vector> points, normals;
  auto fan = soup.triangles.begin();
  std::size_t face = 0;
  for(const Soup::Polygon& polygon : soup.polygons) {
    fan += static_cast<std::ptrdiff_t>(polygon.face - face);
    face = polygon.face + 1;
    const auto end = fan + static_cast<std::ptrdiff_t>(polygon.corners - 2);
    corners = {(*fan)[0], (*fan)[1]};
    for(auto triangle = fan; triangle != end; ++triangle)
      corners.push_back((*triangle)[2]);
    points.clear(); // from the first corner on, in a box of size 1
    const Vector& first = soup.points[static_cast<std::size_t>(corners[0])];
    double size = 0;
    for(const int corner : corners) {
      const Vector& p = soup.points[static_cast<std::size_t>(corner)];
      points.push_back({p[0] - first[0], p[1] - first[1], p[2] - first[2]});
      for(const double x : points.back())
        size = std::max(size, std::abs(x));
    }
    for(Vector& p : points)
      p = {p[0] / size, p[1] / size, p[2] / size};
    normals.clear(); // of the fan
    Vector sum = {};
    for(std::size_t i = 2; i < points.size(); ++i) {
      const Vector n = normals.emplace_back(normal(points[0], points[i - 1], points[i]));
      sum = {sum[0] + n[0], sum[1] + n[1], sum[2] + n[2]};
    }
    const double length = std::sqrt(product(sum, sum));
    bool is_right = true;
    for(std::size_t i = 2; i < points.size(); ++i) // all comparisons are false if a coordinate is not finite
      if(product(normals[i - 2], sum) <= flat * longest_squared_side(points[0], points[i - 1], points[i]) * length)
        is_right = false;
    if(!is_right) {
      auto triangle = fan;
      Ear_clipping(points, sum, looks).clip([&](std::size_t i, std::size_t j, std::size_t k) {
        *triangle++ = {corners[i], corners[j], corners[k]};
      });
    }
    fan = end;
  }
}

} // namespace tool
