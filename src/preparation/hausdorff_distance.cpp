// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/hausdorff_distance.h"

#include "preparation/points.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>

namespace tool {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Triangle_3 = Kernel::Triangle_3;
using Triangles = std::vector<Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Triangle_3 triangle(const std::vector<std::array<double, 3>>& points, const std::array<int, 3>& corners)
{
  const auto point = [&](std::size_t k) {
    const auto& p = points[place(corners[k])];
    return Point_3(p[0], p[1], p[2]);
  };
  return Triangle_3(point(0), point(1), point(2));
}

/// CGAL finds no nearest point in triangles without area.
bool has_area(const Triangle_3& t) { return CGAL::cross_product(t[1] - t[0], t[2] - t[0]) != CGAL::NULL_VECTOR; }

bool has_finite_corners(const Soup& soup, const std::array<int, 3>& corners)
{
  return std::all_of(corners.begin(), corners.end(), [&soup](int v) { return is_finite(soup.points[place(v)]); });
}

bool is_same(const Triangle_3& s, const Triangle_3& t)
{
  for(int k = 0; k < 3; ++k)
    if(s[k] != t[0] && s[k] != t[1] && s[k] != t[2])
      return false;
  return true;
}

/// A piece of a triangle, and an upper bound of the distance of its points.
struct Candidate {
  double bound;
  Triangle_3 triangle;
  friend bool operator<(const Candidate& a, const Candidate& b) { return a.bound < b.bound; }
};

/// The largest distance of points of the triangles from those of the tree.
Bounds farthest(const Triangles& triangles, const Tree& tree, double tolerance, const std::function<void()>& go_on)
{
  constexpr double relative_tolerance = 0.05;
  Bounds result;
  std::priority_queue<Candidate> queue;
  const auto is_close = [&](double bound) {
    return bound <= result.low + std::max(tolerance, relative_tolerance * result.low);
  };
  const auto look_at = [&](const Triangle_3& t) {
    const Point_3 centre = CGAL::centroid(t);
    const auto [nearest, face] = tree.closest_point_and_primitive(centre);
    const double distance = std::sqrt(CGAL::squared_distance(centre, nearest));
    double radius = 0, from_face = 0;
    for(int k = 0; k < 3; ++k) {
      radius = std::max(radius, CGAL::squared_distance(centre, t[k]));
      from_face = std::max(from_face, CGAL::squared_distance(t[k], *face));
    }
    result.low = std::max(result.low, distance);
    // no point is farther than by the radius; nor, since a face is convex, farther from that face than the corners are
    if(const double bound = std::min(distance + std::sqrt(radius), std::sqrt(from_face)); !is_close(bound))
      queue.push({bound, t});
    else
      result.high = std::max(result.high, bound);
  };
  std::size_t looks = 0;
  for(const Triangle_3& t : triangles) {
    if(looks++ % 1024 == 0)
      go_on();
    for(int k = 0; k < 3; ++k)
      result.low = std::max(result.low, std::sqrt(tree.squared_distance(t[k])));
    look_at(t);
  }
  while(!queue.empty()) {
    const Candidate top = queue.top();
    if(is_close(top.bound)) {
      result.high = std::max(result.high, top.bound);
      break;
    }
    if(looks++ % 1024 == 0)
      go_on();
    queue.pop();
    int longest = 0;
    for(int k = 1; k < 3; ++k)
      if(CGAL::squared_distance(top.triangle[k], top.triangle[k + 1]) >
         CGAL::squared_distance(top.triangle[longest], top.triangle[longest + 1]))
        longest = k;
    const Point_3 &a = top.triangle[longest], &b = top.triangle[longest + 1], &c = top.triangle[longest + 2];
    const Point_3 middle = CGAL::midpoint(a, b);
    look_at({a, middle, c});
    look_at({middle, b, c});
  }
  result.high = std::max(result.high, result.low);
  return result;
}

} // namespace

Hausdorff_distance hausdorff_distance(const Soup& old, const std::vector<Glued_surface>& parts, double tolerance,
                                      const std::function<void()>& go_on)
{
  std::vector<bool> is_there(old.triangles.size(), false);
  Triangles all_new, only_new, all_old, only_old;
  for(const Glued_surface& part : parts)
    for(std::size_t f = 0; f < part.faces.size(); ++f) {
      all_new.push_back(triangle(part.points, part.faces[f]));
      const int number = part.old_face[f];
      if(number != Glued_surface::none && is_same(all_new.back(), triangle(old.points, old.triangles[place(number)])))
        is_there[place(number)] = true;
      else
        only_new.push_back(all_new.back());
    }
  for(std::size_t f = 0; f < old.triangles.size(); ++f)
    if(const auto& [a, b, c] = old.triangles[f];
       a != b && b != c && c != a && has_finite_corners(old, old.triangles[f])) { // the others are no faces
      all_old.push_back(triangle(old.points, old.triangles[f]));
      if(!is_there[f])
        only_old.push_back(all_old.back());
    }
  const auto without_area = [](const Triangle_3& t) { return !has_area(t); };
  all_new.erase(std::remove_if(all_new.begin(), all_new.end(), without_area), all_new.end());
  all_old.erase(std::remove_if(all_old.begin(), all_old.end(), without_area), all_old.end());
  Hausdorff_distance result;
  if(!only_new.empty() && !all_old.empty()) {
    const Tree tree(all_old.begin(), all_old.end());
    result.from_new = farthest(only_new, tree, tolerance, go_on);
  }
  if(!only_old.empty() && !all_new.empty()) {
    const Tree tree(all_new.begin(), all_new.end());
    result.from_old = farthest(only_old, tree, tolerance, go_on);
  }
  return result;
}

std::vector<int> nearest_faces(const Soup& old, const Glued_surface& surface)
{
  std::vector<int> result(old.triangles.size(), Glued_surface::none);
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(const int number = surface.old_face[f];
       number != Glued_surface::none && result[place(number)] == Glued_surface::none)
      result[place(number)] = static_cast<int>(f);
  if(std::find(result.begin(), result.end(), Glued_surface::none) == result.end())
    return result;

  Triangles triangles;
  std::vector<int> number;
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(const Triangle_3 t = triangle(surface.points, surface.faces[f]); has_area(t)) {
      triangles.push_back(t);
      number.push_back(static_cast<int>(f));
    }
  const Tree tree(triangles.begin(), triangles.end());
  for(std::size_t f = 0; f < result.size(); ++f) {
    if(result[f] != Glued_surface::none)
      continue;
    result[f] = 0;
    if(has_finite_corners(old, old.triangles[f]) && !triangles.empty()) {
      const Point_3 centre = CGAL::centroid(triangle(old.points, old.triangles[f]));
      const auto nearest = tree.closest_point_and_primitive(centre).second;
      result[f] = number[static_cast<std::size_t>(nearest - triangles.cbegin())];
    }
  }
  return result;
}

} // namespace tool
