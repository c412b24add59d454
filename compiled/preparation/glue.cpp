// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// By hand, since CGAL's repair_polygon_soup(), orient_polygon_soup() and stitch_borders() open more than need be. Of a
// dragon with edges of three faces they leave 5 components with 4 holes, this one with 1; in a Moebius band they copy
// 110 vertices, this 5.

#include "preparation/mend.h"
#include "preparation/points.h"

#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

using Point = Vector;
using Points = boost::iterator_range<const Point*>;
using Triangle = std::array<int, 3>;

bool has_repeated_corner(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Faces that are left, with their numbers in the file.
struct Faces {
  std::vector<Triangle> triangles;
  std::vector<int> number;

  /// Leaves out a face if defect_of(its place here) is one, and notes it there.
  template <class Defect_of>
  void remove(const Defect_of& defect_of)
  {
    std::size_t count = 0;
    for(std::size_t f = 0; f < triangles.size(); ++f)
      if(Defect* const defect = defect_of(f))
        defect->add(number[f]);
      else {
        triangles[count] = Triangle(triangles[f]);
        number[count++] = number[f];
      }
    triangles.resize(count);
    number.resize(count);
  }
};

/// The triangles but the first of those with equal corners are marked.
std::vector<bool> repeated(const std::vector<Triangle>& triangles)
{
  std::vector<std::pair<Triangle, std::size_t>> keys; // sorted corners, and the triangle
  keys.reserve(triangles.size());
  for(Triangle corners : triangles) {
    std::sort(corners.begin(), corners.end());
    keys.emplace_back(corners, keys.size());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<bool> result(triangles.size(), false);
  for(std::size_t i = 1; i < keys.size(); ++i)
    result[keys[i].second] = keys[i].first == keys[i - 1].first;
  return result;
}

/// For every vertex the one that stands for its place: itself, or for those marked, the first of them at a place.
std::vector<int> places(const Points& points, const std::vector<bool>& is_marked, double distance)
{
  double largest = 0;
  for(std::size_t v = 0; v < points.size(); ++v)
    if(is_marked[v])
      largest = std::max(largest, largest_coordinate(std::array<Point, 1>{points[v]}));
  if(!std::isfinite(largest / distance)) // cells have no numbers then
    distance = 0;
  std::unordered_map<Point, std::vector<int>, boost::hash<Point>> cells; // by their numbers
  const auto near = [&](int v) {
    const Point& p = points[place(v)];
    const Point cell = {std::floor(p[0] / distance), std::floor(p[1] / distance), std::floor(p[2] / distance)};
    for(int i = 0; i < 27; ++i) {
      const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
      const auto found = cells.find({cell[0] + x, cell[1] + y, cell[2] + z});
      if(found == cells.end())
        continue;
      for(const int other : found->second)
        if(norm(minus(p, points[place(other)])) <= distance)
          return other;
    }
    cells[cell].push_back(v);
    return v;
  };
  std::unordered_map<Point, int, boost::hash<Point>> at_place; // one for all at the same place, whatever is near it
  const auto find_or_add = [&](int v) {
    const Point& p = points[place(v)];
    const auto [found, is_new] = at_place.emplace(Point{p[0] + 0., p[1] + 0., p[2] + 0.}, v); // -0 is 0
    if(is_new && distance > 0)
      found->second = near(v);
    return found->second;
  };
  std::vector<int> result(points.size());
  std::iota(result.begin(), result.end(), 0);
  for(int& v : result)
    if(is_marked[place(v)])
      v = find_or_add(v);
  return result;
}

/// The gluing while it is made: sides may still run in the same direction.
class Gluing {
public:
  Gluing(const Points& points, Faces faces)
    : points_(&points), faces_(std::move(faces)), twin_(3 * faces_.triangles.size(), Glued_surface::none),
      key_(points.size())
  {
    std::iota(key_.begin(), key_.end(), 0);
  }

  /// Vertices of the same key are the same from now on.
  void identify(std::vector<int> key) { key_ = std::move(key); }

  const Faces& faces() const { return faces_; }
  std::vector<int>& twin() { return twin_; }
  const std::vector<int>& twin() const { return twin_; }

  std::vector<int> open_sides() const
  {
    std::vector<int> sides;
    for(std::size_t s = 0; s < twin_.size(); ++s)
      if(twin_[s] == Glued_surface::none)
        sides.push_back(static_cast<int>(s));
    return sides;
  }

  void glue(int side, int other)
  {
    twin_[place(side)] = other;
    twin_[place(other)] = side;
  }

  int corner(int side, int step = 0) const { return faces_.triangles[place(side / 3)][place((side + step) % 3)]; }
  int key(int side, int step = 0) const { return key_[place(corner(side, step))]; }

  /// Groups of open sides with the same ends.
  template <class Visit>
  void for_each_open_edge(const Visit& visit) const
  {
    std::vector<std::pair<std::pair<int, int>, int>> edges; // ends, and a side
    for(const int side : open_sides())
      edges.emplace_back(std::minmax(key(side), key(side, 1)), side);
    std::sort(edges.begin(), edges.end());
    std::vector<int> group;
    for(std::size_t i = 0; i < edges.size(); ++i) {
      group.push_back(edges[i].second);
      if(i + 1 == edges.size() || edges[i].first != edges[i + 1].first) {
        visit(group);
        group.clear();
      }
    }
  }

  /// Glues sides where two, and no more, have an edge in common.
  void glue_pairs()
  {
    for_each_open_edge([&](const std::vector<int>& sides) {
      if(sides.size() == 2)
        glue(sides[0], sides[1]);
    });
  }

  /// The number of its first side.
  int add_face(const Triangle& corners)
  {
    const int side = static_cast<int>(twin_.size());
    faces_.triangles.push_back(corners);
    faces_.number.push_back(Glued_surface::none);
    twin_.resize(twin_.size() + 3, Glued_surface::none);
    return side;
  }

  /// So many sides at an edge are no shape: each is compared with so many that follow in the file.
  static constexpr std::size_t most_compared = 200;

  /// Glues sides that meet at an edge in pairs, the flattest first.
  void glue_flattest(const std::vector<int>& sides)
  {
    const int a = std::min(key(sides[0]), key(sides[0], 1)), b = std::max(key(sides[0]), key(sides[0], 1));
    const Point edge = minus((*points_)[place(b)], (*points_)[place(a)]);
    const double squared_length = dot(edge, edge);
    const auto from_edge = [&](int side) { // to the third corner, at a right angle
      Point w = minus((*points_)[place(corner(side, 2))], (*points_)[place(a)]);
      const double t = squared_length > 0 ? dot(w, edge) / squared_length : 0;
      for(std::size_t k = 0; k < 3; ++k)
        w[k] -= t * edge[k];
      return w;
    };
    const auto runs_forward = [&](int side) { return key(side) == a; };
    std::vector<Point> arms;
    for(const int side : sides)
      arms.push_back(from_edge(side));
    std::vector<std::tuple<double, int, int>> pairs; // cost, and the sides
    for(std::size_t i = 0; i < sides.size(); ++i)
      for(std::size_t j = i + 1; j < std::min(sides.size(), i + most_compared); ++j) {
        const Point &u = arms[i], &w = arms[j];
        const double angle = std::atan2(norm(cross(u, w)), dot(u, w));
        const Point normal = runs_forward(sides[i]) ? cross(edge, u) : cross(u, edge);
        const bool is_opposite = runs_forward(sides[i]) != runs_forward(sides[j]), is_convex = dot(w, normal) < 0;
        pairs.emplace_back((is_opposite ? 0. : 10.) - angle - (is_convex ? 1e-3 : 0.), sides[i], sides[j]);
      }
    std::sort(pairs.begin(), pairs.end());
    for(const auto& [cost, side, other] : pairs)
      if(twin_[place(side)] == Glued_surface::none && twin_[place(other)] == Glued_surface::none)
        glue(side, other);
  }

private:
  const Points* points_;
  Faces faces_;
  std::vector<int> twin_;
  std::vector<int> key_; ///< by vertex: that which stands for its place
};

/// Whether each face has to be turned round. Gluings that contradict each other are undone.
std::vector<bool> orient(Gluing& gluing, Gluing_defects& defects)
{
  const std::size_t n = gluing.faces().triangles.size();
  std::vector<int>& twin = gluing.twin();
  std::vector<bool> is_reversed(n, false), is_reached(n, false);
  std::vector<int> component;
  for(std::size_t first = 0; first < n; ++first) {
    if(is_reached[first])
      continue;
    is_reached[first] = true;
    component.assign(1, static_cast<int>(first));
    std::size_t reversed = 0;
    for(std::size_t i = 0; i < component.size(); ++i) {
      const int f = component[i];
      reversed += is_reversed[place(f)];
      for(int side = 3 * f; side < 3 * f + 3; ++side) {
        const int other = twin[place(side)];
        if(other == Glued_surface::none)
          continue;
        const bool same_direction = gluing.key(side) == gluing.key(other);
        const std::size_t g = place(other / 3);
        if(!is_reached[g]) {
          is_reached[g] = true;
          is_reversed[g] = is_reversed[place(f)] != same_direction;
          component.push_back(other / 3);
        } else if(is_reversed[g] != (is_reversed[place(f)] != same_direction)) {
          twin[place(side)] = twin[place(other)] = Glued_surface::none;
          defects.cut_edges.add(gluing.corner(side));
        }
      }
    }
    if(2 * reversed > component.size())
      for(const int f : component)
        is_reversed[place(f)] = !is_reversed[place(f)];
  }
  for(std::size_t f = 0; f < n; ++f)
    if(is_reversed[f] && gluing.faces().number[f] != Glued_surface::none)
      defects.reversed_faces.add(gluing.faces().number[f]);
  return is_reversed;
}

Faces usable_faces(const Triangle_soup& soup, Gluing_defects& defects)
{
  Faces faces;
  faces.triangles.assign(soup.triangles.begin(), soup.triangles.end());
  faces.number.resize(soup.triangles.size());
  std::iota(faces.number.begin(), faces.number.end(), 0);

  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(!is_finite(soup.points[v]))
      defects.non_finite_vertices.add(static_cast<int>(v));

  Defect of_their_vertices; // noted already
  faces.remove([&](std::size_t f) -> Defect* {
    const Triangle& t = faces.triangles[f];
    if(!has_finite_corners(soup, t))
      return &of_their_vertices;
    return has_repeated_corner(t) ? &defects.repeated_corners : nullptr;
  });
  const std::vector<bool> is_repeated = repeated(faces.triangles);
  faces.remove([&](std::size_t f) { return is_repeated[f] ? &defects.repeated_faces : nullptr; });
  return faces;
}

/// Closes slits between an open side and others that run along it, from vertex to vertex on it, from its one end to the
/// other: with triangles on that line.
class Slits {
public:
  Slits(const Points& points, double distance, Gluing& gluing) : points_(points), distance_(distance), gluing_(gluing)
  {
    for(const int side : gluing.open_sides()) {
      steps_[gluing.key(side)].push_back({side, 0});
      steps_[gluing.key(side, 1)].push_back({side, 1});
      looks_left_ += 200; // at steps; where these are used up, hardly any way arrives
    }
  }

  void close(Defect& defect)
  {
    for(const int side : gluing_.open_sides()) {
      if(!is_open(side))
        continue;
      const std::vector<Step> steps = along(side);
      if(steps.size() < 2)
        continue;
      defect.add(origin(steps[1]));
      const int end = gluing_.corner(side, 1);
      int last = side;
      for(std::size_t i = 0; i + 1 < steps.size(); ++i) {
        const int added = gluing_.add_face({origin(steps[i]), origin(steps[i + 1]), end});
        gluing_.glue(added + 2, last);
        gluing_.glue(added, steps[i].side);
        last = added + 1;
      }
      gluing_.glue(last, steps.back().side);
    }
  }

private:
  /// Along a side, from its corner `from` to the other one.
  struct Step {
    int side, from;
  };

  bool is_open(int side) const { return gluing_.twin()[place(side)] == Glued_surface::none; }
  int origin(const Step& step) const { return gluing_.corner(step.side, step.from); }

  /// The way from the origin of `side` to its target; empty if there is none. The side alone is none.
  std::vector<Step> along(int side)
  {
    constexpr std::size_t most = 200;                       // at a vertex; so many are no shape
    constexpr double rounding = 2.4e-7;                     // a few units of the last place of a float
    constexpr double least = 1e-6, most_of_rounding = 1e-3; // shares of the side: a hole is no slit, wherever it is
    const int end = gluing_.key(side, 1);
    int at = gluing_.key(side);
    const Point &a = points_[place(at)], edge = minus(points_[place(end)], a);
    const double squared_length = dot(edge, edge);
    const double length = std::sqrt(squared_length),
                 rounded = rounding * largest_coordinate(std::array<Point, 2>{a, points_[place(end)]});
    const double tolerance = std::max({distance_, std::min(rounded, most_of_rounding * length), least * length});
    double t = 0;
    std::vector<Step> steps;
    while(at != end) {
      if(looks_left_ == 0)
        return {};
      const auto found = steps_.find(at);
      double nearest = 2;
      Step best = {Glued_surface::none, 0};
      for(std::size_t i = 0; found != steps_.end() && i < std::min(found->second.size(), most); ++i) {
        looks_left_ -= looks_left_ > 0 ? 1 : 0;
        const Step& step = found->second[i];
        if(!is_open(step.side) || step.side / 3 == side / 3)
          continue;
        const int other = gluing_.key(step.side, 1 - step.from);
        const Point from_a = minus(points_[place(other)], a);
        const double u = other == end ? 1 : dot(from_a, edge) / squared_length;
        const Point off = {from_a[0] - u * edge[0], from_a[1] - u * edge[1], from_a[2] - u * edge[2]};
        if(u > t && u < nearest && (u < 1 || other == end) && norm(off) <= tolerance) {
          nearest = u;
          best = step;
        }
      }
      if(best.side == Glued_surface::none)
        return {};
      steps.push_back(best);
      t = nearest;
      at = gluing_.key(best.side, 1 - best.from);
    }
    return steps;
  }

  const Points& points_;
  double distance_;
  Gluing& gluing_;
  std::unordered_map<int, std::vector<Step>> steps_; ///< by the vertex where they begin
  std::size_t looks_left_ = 10'000;
};

} // namespace

void turn_round(Glued_surface& surface, const std::vector<bool>& is_turned)
{
  // side k of a face that is turned round becomes side 2 - k
  const auto turned = [&is_turned](int side) {
    return side == Glued_surface::none || !is_turned[place(side / 3)] ? side : side - side % 3 + 2 - side % 3;
  };
  const std::vector<int> before = surface.twin;
  for(int side = 0; side < surface.number_of_sides(); ++side)
    surface.twin[place(turned(side))] = turned(before[place(side)]);
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(is_turned[f])
      std::swap(surface.faces[f][1], surface.faces[f][2]);
}

Glued_surface glue(const Triangle_soup& soup, std::optional<double> merge_distance, Gluing_defects& defects,
                   const std::function<void()>& go_on)
{
  Gluing gluing(soup.points, usable_faces(soup, defects));
  go_on();
  gluing.glue_pairs();
  go_on();

  // what is open may be continued by other vertices at the same place
  std::vector<bool> is_open(soup.points.size(), false);
  if(merge_distance)
    for(const int side : gluing.open_sides())
      is_open[place(gluing.corner(side))] = is_open[place(gluing.corner(side, 1))] = true;
  std::vector<int> key = places(soup.points, is_open, merge_distance.value_or(0));
  go_on();
  bool is_merged = false;
  for(int v = 0; v < static_cast<int>(key.size()); ++v)
    is_merged = is_merged || key[place(v)] != v;
  if(is_merged) {
    Faces faces = gluing.faces();
    std::vector<Triangle> keys;
    for(const auto& [a, b, c] : faces.triangles)
      keys.push_back({key[place(a)], key[place(b)], key[place(c)]});
    const std::vector<bool> is_repeated = repeated(keys);
    faces.remove([&](std::size_t f) -> Defect* {
      const auto& [a, b, c] = faces.triangles[f];
      if(has_repeated_corner(keys[f]))
        return &defects.repeated_corners;
      // two sheets that meet at their rims only are no repeated faces
      const auto first_side = gluing.twin().begin() + static_cast<std::ptrdiff_t>(3 * f);
      const bool has_open_side = std::find(first_side, first_side + 3, Glued_surface::none) != first_side + 3;
      return is_repeated[f] && has_open_side && is_open[place(a)] && is_open[place(b)] && is_open[place(c)]
               ? &defects.repeated_faces
               : nullptr;
    });
    go_on();
    gluing = Gluing(soup.points, std::move(faces));
    gluing.glue_pairs();
    go_on();
  }
  gluing.identify(std::move(key));
  gluing.for_each_open_edge([&](const std::vector<int>& sides) {
    if(sides.size() == 2)
      gluing.glue(sides[0], sides[1]);
    else if(sides.size() > 2) {
      defects.non_manifold_edges.add(gluing.corner(sides[0]));
      if(sides.size() > Gluing::most_compared)
        defects.crowded_edges.add(gluing.corner(sides[0]));
      go_on();
      gluing.glue_flattest(sides);
    }
  });
  go_on();
  if(merge_distance)
    Slits(soup.points, *merge_distance, gluing).close(defects.slits);
  go_on();
  const std::vector<bool> is_reversed = orient(gluing, defects);
  go_on();

  Glued_surface surface;
  surface.points.assign(soup.points.begin(), soup.points.end());
  surface.old_vertex.resize(soup.points.size());
  std::iota(surface.old_vertex.begin(), surface.old_vertex.end(), 0);
  surface.faces = gluing.faces().triangles;
  surface.old_face = gluing.faces().number;
  surface.twin = gluing.twin();
  turn_round(surface, is_reversed);
  const std::vector<Triangle> before = surface.faces;
  derive_vertices(surface);
  go_on();

  // those at the same place, but at no common edge, stay what they are
  std::vector<bool> has_face(soup.points.size(), false), has_joined(soup.points.size(), false);
  for(std::size_t f = 0; f < before.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k) {
      const std::size_t v = place(before[f][k]);
      has_face[v] = true;
      has_joined[v] = has_joined[v] || surface.old_vertex[place(surface.faces[f][k])] != before[f][k];
    }
  for(int v = 0; v < static_cast<int>(has_joined.size()); ++v)
    if(has_joined[place(v)])
      defects.merged_vertices.add(v);
    else if(!has_face[place(v)] && is_finite(soup.points[place(v)]))
      defects.isolated_vertices.add(v);

  std::vector<bool> is_there(soup.points.size(), false);
  for(const int old : surface.old_vertex) {
    if(is_there[place(old)])
      defects.non_manifold_vertices.add(old);
    is_there[place(old)] = true;
  }
  return surface;
}

} // namespace CGAL::Spherical_parameterization::preparation
