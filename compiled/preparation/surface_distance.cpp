// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include <CGAL/Spherical_parameterization/preparation/surface_distance.h>

#include "preparation/points.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point_3 = Kernel::Point_3;
using Triangle_3 = Kernel::Triangle_3;
using Triangle_list = std::vector<Triangle_3>;

Point_3 point_of(const Point& p, double unit) { return {p[0] / unit, p[1] / unit, p[2] / unit}; }

template <class Points>
Triangle_3 triangle(const Points& points, const std::array<int, 3>& corners, double unit)
{
  const auto corner = [&](std::size_t k) { return point_of(points[place(corners[k])], unit); };
  return Triangle_3(corner(0), corner(1), corner(2));
}

/// The faces of `mesh` over `points`.
Triangle_list triangles_of(const Mesh& mesh, const std::vector<Point>& points, double unit)
{
  Triangle_list result;
  result.reserve(mesh.number_of_faces());
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    result.push_back(triangle(points, mesh.triangle(f), unit));
  return result;
}

/// The vertex at which the longest edge begins.
int longest_edge(const Triangle_3& t)
{
  int longest = 0;
  for(int k = 1; k < 3; ++k)
    if(CGAL::squared_distance(t[k], t[k + 1]) > CGAL::squared_distance(t[longest], t[longest + 1]))
      longest = k;
  return longest;
}

double square_of_longest_edge(const Triangle_3& t)
{
  const int k = longest_edge(t);
  return CGAL::squared_distance(t[k], t[k + 1]);
}

std::array<Triangle_3, 2> halves(const Triangle_3& t)
{
  const int k = longest_edge(t);
  const Point_3 middle = CGAL::midpoint(t[k], t[k + 1]);
  return {Triangle_3(t[k], middle, t[k + 2]), Triangle_3(middle, t[k + 1], t[k + 2])};
}

/// Triangle_list of which the nearest is asked. They have to stay where they are.
class Triangle_tree {
public:
  static constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();

  explicit Triangle_tree(const Triangle_list& triangles)
    : triangles_(triangles), pieces_(triangles), number_(pieces_.size())
  {
    std::iota(number_.begin(), number_.end(), std::size_t(0));
    halve_long_ones();
    tree_.rebuild(pieces_.cbegin(), pieces_.cend());
    tree_.build(); // now: questions may come from several threads
  }
  Triangle_tree(const Triangle_tree&) = delete;
  Triangle_tree& operator=(const Triangle_tree&) = delete;

  bool is_empty() const { return pieces_.empty(); }

  struct Nearest {
    double distance;
    const Triangle_3* triangle;
    std::size_t number; ///< of the triangle
    bool is_certain;    ///< there is no nearer one; if the distance is above `enough`
    std::size_t looks;  ///< at triangles
  };
  /// The nearest triangle, or any that is as near as `enough`, or the nearest of `most` that were looked at: where many
  /// triangles overlap, any of them may be the nearest. \pre there are triangles
  Nearest nearest(const Point_3& p, double enough = 0, std::size_t most = unlimited) const
  {
    Search search(enough * enough, most);
    tree_.traversal_with_priority(p, search);
    const auto piece = static_cast<std::size_t>(search.best() - pieces_.cbegin());
    return {std::sqrt(search.square()), &triangles_[number_[piece]], number_[piece], search.is_certain(),
            search.looks()};
  }

private:
  using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangle_list::const_iterator>;
  using Traits = CGAL::AABB_traits<Kernel, Primitive>;

  /// A visitor of the tree, which goes to the nearer of two boxes first. CGAL's own starts at one of the corners, which
  /// it finds in a tree that overflows the stack when thousands of them are at the same place, and never stops early.
  class Search {
  public:
    using Node = CGAL::AABB_node<Traits>;
    using Priority = double;

    Search(double enough, std::size_t most) : enough_(enough), most_(most) {}

    bool go_further() const { return square_ > enough_ && looks_ < most_; }
    void intersection(const Point_3& p, const Primitive& primitive)
    {
      ++looks_;
      if(const double square = CGAL::squared_distance(p, primitive.datum()); square < square_ || looks_ == 1) {
        square_ = square;
        best_ = primitive.id();
      }
    }
    bool do_intersect(const Point_3& p, const Node& node) const { return squared_distance(p, node.bbox()) < square_; }
    std::pair<bool, Priority> do_intersect_with_priority(const Point_3& p, const Node& node) const
    {
      const double square = squared_distance(p, node.bbox());
      return {square < square_, -square};
    }

    double square() const { return square_; }
    Primitive::Id best() const { return best_; }
    std::size_t looks() const { return looks_; }
    bool is_certain() const { return looks_ < most_; }

  private:
    static double squared_distance(const Point_3& p, const CGAL::Bbox_3& box)
    {
      double sum = 0;
      for(int k = 0; k < 3; ++k) {
        const double side = std::max({(box.min)(k)-p[k], 0., p[k] - (box.max)(k)});
        sum += side * side;
      }
      return sum;
    }

    double enough_; ///< squared
    std::size_t most_, looks_ = 0;
    double square_ = std::numeric_limits<double>::infinity();
    Primitive::Id best_;
  };

  /// A point is in the boxes of all long triangles that run across the shape, and each has to be looked at. So they are
  /// cut down (M. Ernst and G. Greiner, "Early split clipping for bounding volume hierarchies", 2007).
  void halve_long_ones()
  {
    constexpr double long_ones = 4;                    // times the median
    constexpr std::size_t most = 8, most_new = 300000; // pieces, times the triangles; and those added
    if(pieces_.empty())
      return;
    std::vector<double> squares;
    for(const Triangle_3& t : pieces_)
      squares.push_back(square_of_longest_edge(t));
    const auto median = squares.begin() + static_cast<std::ptrdiff_t>(squares.size() / 2);
    std::nth_element(squares.begin(), median, squares.end());
    const double limit = long_ones * long_ones * *median;
    const std::size_t most_pieces = std::min(most * pieces_.size(), pieces_.size() + most_new);
    std::priority_queue<std::pair<double, std::size_t>> queue; // square of the longest edge, and the piece
    const auto add_if_long = [&](std::size_t i) {
      if(const double square = square_of_longest_edge(pieces_[i]); square > limit)
        queue.emplace(square, i);
    };
    for(std::size_t i = 0; i < pieces_.size(); ++i)
      add_if_long(i);
    while(!queue.empty() && pieces_.size() < most_pieces) {
      const std::size_t i = queue.top().second;
      queue.pop();
      const auto [first, second] = halves(pieces_[i]);
      pieces_[i] = first;
      pieces_.push_back(second);
      number_.push_back(std::size_t(number_[i]));
      add_if_long(i);
      add_if_long(pieces_.size() - 1);
    }
  }

  const Triangle_list& triangles_;
  Triangle_list pieces_;
  std::vector<std::size_t> number_; ///< by piece: of the triangle
  CGAL::AABB_tree<Traits> tree_;
};

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
  int blind; ///< so often it may be halved before the nearest face is asked for again
  friend bool operator<(const Candidate& a, const Candidate& b) { return a.bound < b.bound; }
};

/// The largest distance of points of the triangles from those of the tree.
Bounds farthest(const Triangle_list& triangles, const Triangle_tree& tree, double tolerance,
                const std::function<void()>& go_on)
{
  constexpr double relative_tolerance = 0.05;
  const std::size_t most_pieces = 20'000 + 20 * triangles.size();
  // at triangles: for one answer, for all, and for one when those have been used up
  constexpr std::size_t most_looks = 2'000, few_looks = 50;
  const std::size_t all_looks = 50'000'000 + 500 * triangles.size();
  std::size_t pieces = 0, looks = 0;
  Bounds result;
  std::priority_queue<Candidate> queue;
  const auto is_close = [&](double bound) {
    return bound <= result.low + std::max(tolerance, relative_tolerance * result.low);
  };
  const auto ask = [&](const Point_3& p, double enough) {
    const auto nearest = tree.nearest(p, enough, looks < all_looks ? most_looks : few_looks);
    looks += nearest.looks;
    if(nearest.is_certain)
      result.low = std::max(result.low, nearest.distance);
    return nearest;
  };
  const auto look_at = [&](const Triangle_3& t, double bound_of_whole, int blind) {
    const Point_3 centre = CGAL::centroid(t);
    double square = 0;
    for(int k = 0; k < 3; ++k)
      square = std::max(square, CGAL::squared_distance(centre, t[k]));
    const double radius = std::sqrt(square);
    if(radius >= result.low && blind > 0) {
      queue.push({bound_of_whole, t, blind - 1});
      return;
    }
    const double enough = std::max(0., result.low - radius); // no point is farther than one that is known
    const Triangle_tree::Nearest nearest = ask(centre, enough);
    if(nearest.distance <= enough)
      return;
    double from_face = 0;
    for(int k = 0; k < 3; ++k)
      from_face = std::max(from_face, CGAL::squared_distance(t[k], *nearest.triangle));
    // no point is farther than by the radius; nor, since a face is convex, farther from that face than the corners are
    const double by_radius = nearest.distance + radius, by_face = std::sqrt(from_face);
    constexpr int across = 2; // it does not run along the face, and will not until it is small
    if(const double bound = std::min(by_radius, by_face); !is_close(bound))
      queue.push({bound, t, by_radius < by_face ? across : 0});
    else
      result.high = std::max(result.high, bound);
  };
  for(const Triangle_3& t : triangles) {
    if(pieces++ % 1024 == 0)
      go_on();
    for(int k = 0; k < 3; ++k)
      ask(t[k], result.low);
    look_at(t, 0, 0);
  }
  while(!queue.empty()) {
    const Candidate top = queue.top();
    if(is_close(top.bound) || pieces > most_pieces || looks > all_looks) {
      result.high = std::max(result.high, top.bound);
      break;
    }
    if(pieces++ % 1024 == 0)
      go_on();
    queue.pop();
    for(const Triangle_3& half : halves(top.triangle))
      look_at(half, top.bound, top.blind);
  }
  result.high = std::max(result.high, result.low);
  return result;
}

constexpr std::size_t most_looks_at_overlaps = 10'000; // where so many faces overlap, any of them is the nearest

} // namespace

Hausdorff_distance hausdorff_distance(const Triangle_soup& old, const std::vector<Glued_surface>& parts,
                                      double tolerance, const std::function<void()>& go_on)
{
  double largest = largest_coordinate(old);
  for(const Glued_surface& part : parts)
    largest = std::max(largest, largest_coordinate(part.points));
  const double unit = unit_of(largest);

  std::vector<bool> is_there(old.triangles.size(), false);
  Triangle_list all_new, only_new, all_old, only_old;
  for(const Glued_surface& part : parts)
    for(std::size_t f = 0; f < part.faces.size(); ++f) {
      all_new.push_back(triangle(part.points, part.faces[f], unit));
      const int number = part.old_face[f];
      if(number != Glued_surface::none &&
         is_same(all_new.back(), triangle(old.points, old.triangles[place(number)], unit)))
        is_there[place(number)] = true;
      else
        only_new.push_back(all_new.back());
    }
  for(std::size_t f = 0; f < old.triangles.size(); ++f)
    if(is_face(old, old.triangles[f])) {
      all_old.push_back(triangle(old.points, old.triangles[f], unit));
      if(!is_there[f])
        only_old.push_back(all_old.back());
    }

  const auto between = [&](const Triangle_list& only_here, const Triangle_list& there) {
    Bounds bounds;
    if(only_here.empty())
      return bounds;
    const Triangle_tree tree(there);
    if(!tree.is_empty())
      bounds = farthest(only_here, tree, tolerance / unit, go_on);
    return Bounds{unit * bounds.low, unit * bounds.high};
  };
  return {between(only_new, all_old), between(only_old, all_new)};
}

std::vector<int> nearest_old_faces(const std::vector<Point>& points, const Glued_surface& surface)
{
  if(points.empty())
    return {};
  const double unit = unit_of(std::max(largest_coordinate(points), largest_coordinate(surface.points)));
  Triangle_list triangles;
  std::vector<int> number;
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(surface.old_face[f] != Glued_surface::none) {
      triangles.push_back(triangle(surface.points, surface.faces[f], unit));
      number.push_back(static_cast<int>(f));
    }
  const Triangle_tree tree(triangles);
  std::vector<int> result;
  for(const Point& p : points)
    result.push_back(number[tree.nearest(point_of(p, unit), 0, most_looks_at_overlaps).number]);
  return result;
}

std::vector<int> nearest_faces(const Triangle_soup& old, const Glued_surface& surface)
{
  std::vector<int> result(old.triangles.size(), Glued_surface::none);
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(const int number = surface.old_face[f];
       number != Glued_surface::none && result[place(number)] == Glued_surface::none)
      result[place(number)] = static_cast<int>(f);
  if(std::find(result.begin(), result.end(), Glued_surface::none) == result.end())
    return result;

  const double unit = unit_of(std::max(largest_coordinate(old), largest_coordinate(surface.points)));
  Triangle_list triangles;
  for(const auto& corners : surface.faces)
    triangles.push_back(triangle(surface.points, corners, unit));
  const Triangle_tree tree(triangles);
  for(std::size_t f = 0; f < result.size(); ++f) {
    if(result[f] != Glued_surface::none)
      continue;
    result[f] = 0;
    if(has_finite_corners(old, old.triangles[f]) && !tree.is_empty())
      result[f] = static_cast<int>(
        tree.nearest(CGAL::centroid(triangle(old.points, old.triangles[f], unit)), 0, most_looks_at_overlaps).number);
  }
  return result;
}

double hausdorff_distance_at_vertices(const Mesh& mesh, const std::vector<Point>& points,
                                      const std::vector<Point>& others)
{
  const double unit = unit_of(std::max(largest_coordinate(points), largest_coordinate(others)));
  // A vertex is not farther from the other surface than from itself there: beyond what is known, none is looked at.
  std::vector<std::pair<double, std::size_t>> bounds;
  for(std::size_t v = 0; v < points.size(); ++v)
    bounds.emplace_back(std::sqrt(CGAL::squared_distance(point_of(points[v], unit), point_of(others[v], unit))), v);
  std::sort(bounds.begin(), bounds.end(), std::greater<>());
  double farthest = 0;
  for(const auto& [from, to] : {std::pair(&points, &others), std::pair(&others, &points)}) {
    const Triangle_list triangles = triangles_of(mesh, *to, unit);
    const Triangle_tree tree(triangles);
    for(auto vertex = bounds.begin(); vertex != bounds.end() && vertex->first > farthest; ++vertex)
      farthest = std::max(farthest, tree.nearest(point_of((*from)[vertex->second], unit), farthest).distance);
  }
  return unit * farthest;
}

Sampling_loss sampling_loss(const Mesh& mesh, const Mesh& sampled, const std::vector<Point>& points)
{
  constexpr std::size_t most_queries = 100000;
  constexpr double share = 0.99;
  const double unit = unit_of(largest_coordinate(mesh.points()));
  const Triangle_list shape = triangles_of(mesh, mesh.points(), unit), samples = triangles_of(sampled, points, unit);

  Sampling_loss loss;
  const CGAL::Bbox_3 before = CGAL::bbox_3(shape.begin(), shape.end()),
                     after = CGAL::bbox_3(samples.begin(), samples.end());
  double diagonal = 0;
  for(int k = 0; k < 3; ++k) {
    const double side = before.max(k) - before.min(k);
    if(side > 0)
      loss.bounding_box = std::max(loss.bounding_box, 1 - (after.max(k) - after.min(k)) / side);
    diagonal = std::hypot(diagonal, side);
  }

  // The distances of the centres of faces, which count as much as their areas.
  const Triangle_tree tree(samples);
  if(tree.is_empty())
    return loss;
  std::vector<std::pair<double, double>> distances;
  double whole = 0;
  for(std::size_t f = 0; f < shape.size(); f += 1 + shape.size() / most_queries) {
    const double area = std::sqrt(shape[f].squared_area());
    distances.emplace_back(tree.nearest(CGAL::centroid(shape[f])).distance, area);
    whole += area;
  }
  std::sort(distances.begin(), distances.end());
  double area = 0;
  for(const auto& [distance, of_face] : distances) {
    loss.distance = diagonal > 0 ? distance / diagonal : 0;
    area += of_face;
    if(area >= share * whole)
      break;
  }
  return loss;
}

} // namespace CGAL::Spherical_parameterization::preparation
