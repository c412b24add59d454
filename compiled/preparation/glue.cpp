// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// By hand, since CGAL's repair_polygon_soup(), orient_polygon_soup() and stitch_borders() open more than need be. Of a
// dragon with edges of three faces they leave 5 components with 4 holes, this one with 1; in a Moebius band they copy
// 110 vertices, this 5.

#include "preparation/glue.h"

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

Triangle sorted(Triangle t)
{
  std::sort(t.begin(), t.end());
  return t;
}

/// Faces that are left, with their numbers in the file.
struct Faces {
  std::vector<Triangle> triangles;
  std::vector<int> number;

  template <class Is_kept>
  void keep(const Is_kept& is_kept)
  {
    std::size_t count = 0;
    for(std::size_t f = 0; f < triangles.size(); ++f)
      if(is_kept(f)) {
        triangles[count] = Triangle(triangles[f]);
        number[count++] = number[f];
      }
    triangles.resize(count);
    number.resize(count);
  }
};

/// The faces but the first of those with equal `keys` are marked.
std::vector<bool> repeated(const std::vector<Triangle>& keys)
{
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::vector<Triangle> key(keys.size());
  std::transform(keys.begin(), keys.end(), key.begin(), sorted);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
  std::vector<bool> result(keys.size(), false);
  for(std::size_t i = 1; i < order.size(); ++i)
    result[order[i]] = key[order[i]] == key[order[i - 1]];
  return result;
}

/// Groups of sides with the same ends. `key` tells which vertices are the same.
template <class Key, class Visit>
void for_each_edge(const std::vector<Triangle>& triangles, const std::vector<int>& sides, const Key& key,
                   const Visit& visit)
{
  std::vector<std::tuple<int, int, int>> edges;
  edges.reserve(sides.size());
  for(const int side : sides) {
    const int a = key(triangles[place(side / 3)][place(side % 3)]);
    const int b = key(triangles[place(side / 3)][place((side + 1) % 3)]);
    edges.emplace_back(std::min(a, b), std::max(a, b), side);
  }
  std::sort(edges.begin(), edges.end());
  std::vector<int> group;
  for(std::size_t i = 0; i < edges.size(); ++i) {
    group.push_back(std::get<2>(edges[i]));
    const bool is_last = i + 1 == edges.size() || std::get<0>(edges[i]) != std::get<0>(edges[i + 1]) ||
                         std::get<1>(edges[i]) != std::get<1>(edges[i + 1]);
    if(is_last) {
      visit(group);
      group.clear();
    }
  }
}

/// For every vertex the one that stands for its place: itself, or for those marked, the first of them at a place.
class Places {
public:
  Places(const Points& points, const std::vector<bool>& is_marked, double distance)
    : points_(points), distance_(distance), representative_(points.size())
  {
    std::iota(representative_.begin(), representative_.end(), 0);
    for(std::size_t v = 0; v < points.size(); ++v)
      if(is_marked[v])
        representative_[v] = find_or_add(static_cast<int>(v));
  }

  int operator()(int v) const { return representative_[place(v)]; }

private:
  using Cell = std::array<double, 3>; ///< the point itself, or the number of its cell

  int find_or_add(int v)
  {
    const Point& p = points_[place(v)];
    if(!(distance_ > 0)) {
      const Point key = {p[0] + 0., p[1] + 0., p[2] + 0.}; // -0 is 0
      return cells_.emplace(key, std::vector<int>{v}).first->second.front();
    }
    const Cell cell = {std::floor(p[0] / distance_), std::floor(p[1] / distance_), std::floor(p[2] / distance_)};
    for(int i = 0; i < 27; ++i) {
      const int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
      const auto found = cells_.find({cell[0] + x, cell[1] + y, cell[2] + z});
      if(found == cells_.end())
        continue;
      for(const int other : found->second)
        if(norm(minus(p, points_[place(other)])) <= distance_)
          return other;
    }
    cells_[cell].push_back(v);
    return v;
  }

  const Points& points_;
  double distance_;
  std::vector<int> representative_;
  std::unordered_map<Cell, std::vector<int>, boost::hash<Cell>> cells_;
};

/// The gluing while it is made: sides may still run in the same direction.
class Gluing {
public:
  Gluing(const Points& points, Faces faces) : points_(&points), faces_(std::move(faces))
  {
    twin_.assign(3 * faces_.triangles.size(), Glued_surface::none);
  }

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
  template <class Key>
  void glue_flattest(std::vector<int> sides, const Key& key)
  {
    struct Pair {
      double cost;
      int side, other;
    };
    const int a = std::min(key(corner(sides[0])), key(corner(sides[0], 1)));
    const int b = std::max(key(corner(sides[0])), key(corner(sides[0], 1)));
    const Point edge = minus((*points_)[place(b)], (*points_)[place(a)]);
    const double squared_length = dot(edge, edge);
    const auto from_edge = [&](int side) { // to the third corner, at a right angle
      Point w = minus((*points_)[place(corner(side, 2))], (*points_)[place(a)]);
      const double t = squared_length > 0 ? dot(w, edge) / squared_length : 0;
      for(std::size_t k = 0; k < 3; ++k)
        w[k] -= t * edge[k];
      return w;
    };
    const auto runs_forward = [&](int side) { return key(corner(side)) == a; };
    std::vector<Pair> pairs;
    for(std::size_t i = 0; i < sides.size(); ++i)
      for(std::size_t j = i + 1; j < std::min(sides.size(), i + most_compared); ++j) {
        const Point u = from_edge(sides[i]), w = from_edge(sides[j]);
        const double angle = std::atan2(norm(cross(u, w)), dot(u, w));
        const Point normal = runs_forward(sides[i]) ? cross(edge, u) : cross(u, edge);
        const bool is_opposite = runs_forward(sides[i]) != runs_forward(sides[j]), is_convex = dot(w, normal) < 0;
        pairs.push_back({(is_opposite ? 0. : 10.) - angle - (is_convex ? 1e-3 : 0.), sides[i], sides[j]});
      }
    std::sort(pairs.begin(), pairs.end(), [](const Pair& x, const Pair& y) {
      return std::tie(x.cost, x.side, x.other) < std::tie(y.cost, y.side, y.other);
    });
    for(const Pair& pair : pairs)
      if(twin_[place(pair.side)] == Glued_surface::none && twin_[place(pair.other)] == Glued_surface::none)
        glue(pair.side, pair.other);
  }

private:
  const Points* points_;
  Faces faces_;
  std::vector<int> twin_;
};

/// Whether each face has to be turned round. Gluings that contradict each other are undone.
template <class Key>
std::vector<bool> orient(Gluing& gluing, const Key& key, Gluing_defects& defects)
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
        const bool same_direction = key(gluing.corner(side)) == key(gluing.corner(other));
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

  std::vector<bool> is_used(soup.points.size(), false);
  for(const Triangle& t : faces.triangles)
    for(const int v : t)
      is_used[place(v)] = true;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(!is_used[v])
      defects.isolated_vertices.add(static_cast<int>(v));
    else if(!is_finite(soup.points[v]))
      defects.non_finite_vertices.add(static_cast<int>(v));
  if(defects.non_finite_vertices.count > 0)
    faces.keep([&](std::size_t f) {
      return std::all_of(faces.triangles[f].begin(), faces.triangles[f].end(),
                         [&](int v) { return is_finite(soup.points[place(v)]); });
    });

  for(std::size_t f = 0; f < faces.triangles.size(); ++f)
    if(has_repeated_corner(faces.triangles[f]))
      defects.repeated_corners.add(faces.number[f]);
  faces.keep([&](std::size_t f) { return !has_repeated_corner(faces.triangles[f]); });

  const std::vector<bool> is_repeated = repeated(faces.triangles);
  for(std::size_t f = 0; f < faces.triangles.size(); ++f)
    if(is_repeated[f])
      defects.repeated_faces.add(faces.number[f]);
  faces.keep([&](std::size_t f) { return !is_repeated[f]; });
  return faces;
}

/// Glues sides where two, and no more, have an edge in common.
void glue_pairs(Gluing& gluing)
{
  const auto itself = [](int v) { return v; };
  for_each_edge(gluing.faces().triangles, gluing.open_sides(), itself, [&](const std::vector<int>& sides) {
    if(sides.size() == 2)
      gluing.glue(sides[0], sides[1]);
  });
}

/// Closes slits between an open side and others that run along it, from vertex to vertex on it, from its one end to the
/// other: with triangles on that line.
template <class Key>
class Slits {
public:
  Slits(const Points& points, const Key& key, double distance, Gluing& gluing)
    : points_(points), key_(key), distance_(distance), gluing_(gluing)
  {
    for(const int side : gluing.open_sides()) {
      steps_[key(gluing.corner(side))].push_back({side, 0});
      steps_[key(gluing.corner(side, 1))].push_back({side, 1});
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
    constexpr std::size_t most = 200;   // at a vertex; so many are no shape
    constexpr double rounding = 2.4e-7; // a few units of the last place of a float
    const int end = key_(gluing_.corner(side, 1));
    int at = key_(gluing_.corner(side));
    const Point &a = points_[place(at)], edge = minus(points_[place(end)], a);
    const double squared_length = dot(edge, edge);
    const double tolerance =
      std::max({distance_, rounding * largest_coordinate(std::array<Point, 2>{a, points_[place(end)]}),
                1e-6 * std::sqrt(squared_length)});
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
        const int other = key_(gluing_.corner(step.side, 1 - step.from));
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
      at = key_(gluing_.corner(best.side, 1 - best.from));
    }
    return steps;
  }

  const Points& points_;
  const Key& key_;
  double distance_;
  Gluing& gluing_;
  std::unordered_map<int, std::vector<Step>> steps_; ///< by the vertex where they begin
  std::size_t looks_left_ = 10'000;
};

std::vector<bool> vertices_of_open_sides(const Gluing& gluing, std::size_t number_of_vertices)
{
  std::vector<bool> is_open(number_of_vertices, false);
  for(const int side : gluing.open_sides())
    is_open[place(gluing.corner(side))] = is_open[place(gluing.corner(side, 1))] = true;
  return is_open;
}

} // namespace

Glued_surface glue(const Triangle_soup& soup, std::optional<double> merge_distance, Gluing_defects& defects)
{
  Gluing gluing(soup.points, usable_faces(soup, defects));
  glue_pairs(gluing);

  // what is open may be continued by other vertices at the same place
  const std::vector<bool> is_open =
    merge_distance ? vertices_of_open_sides(gluing, soup.points.size()) : std::vector<bool>(soup.points.size(), false);
  const Places key(soup.points, is_open, merge_distance.value_or(0));
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(is_open[v] && key(static_cast<int>(v)) != static_cast<int>(v))
      defects.merged_vertices.add(static_cast<int>(v));
  if(defects.merged_vertices.count > 0) {
    Faces faces = gluing.faces();
    std::vector<Triangle> keys;
    for(const Triangle& t : faces.triangles)
      keys.push_back({key(t[0]), key(t[1]), key(t[2])});
    const std::vector<bool> is_repeated = repeated(keys);
    // two sheets that meet at their rims only are no repeated faces
    const auto is_left_out = [&](std::size_t f) {
      const Triangle& t = faces.triangles[f];
      return has_repeated_corner(keys[f]) ||
             (is_repeated[f] &&
              (gluing.twin()[3 * f] == Glued_surface::none || gluing.twin()[3 * f + 1] == Glued_surface::none ||
               gluing.twin()[3 * f + 2] == Glued_surface::none) &&
              is_open[place(t[0])] && is_open[place(t[1])] && is_open[place(t[2])]);
    };
    std::vector<bool> kept(faces.triangles.size(), true);
    for(std::size_t f = 0; f < faces.triangles.size(); ++f)
      if(is_left_out(f)) {
        (has_repeated_corner(keys[f]) ? defects.repeated_corners : defects.repeated_faces).add(faces.number[f]);
        kept[f] = false;
      }
    faces.keep([&kept](std::size_t f) { return kept[f]; });
    gluing = Gluing(soup.points, std::move(faces));
    glue_pairs(gluing);
  }
  for_each_edge(gluing.faces().triangles, gluing.open_sides(), key, [&](const std::vector<int>& sides) {
    if(sides.size() == 2)
      gluing.glue(sides[0], sides[1]);
    else if(sides.size() > 2) {
      defects.non_manifold_edges.add(gluing.corner(sides[0]));
      if(sides.size() > Gluing::most_compared)
        defects.crowded_edges.add(gluing.corner(sides[0]));
      gluing.glue_flattest(sides, key);
    }
  });
  if(merge_distance)
    Slits<Places>(soup.points, key, *merge_distance, gluing).close(defects.slits);
  const std::vector<bool> is_reversed = orient(gluing, key, defects);

  // side k of a face that is turned round becomes side 2 - k
  const auto turned = [&is_reversed](int side) {
    return side == Glued_surface::none || !is_reversed[place(side / 3)] ? side : side - side % 3 + 2 - side % 3;
  };
  Glued_surface surface;
  surface.points.assign(soup.points.begin(), soup.points.end());
  surface.old_vertex.resize(soup.points.size());
  std::iota(surface.old_vertex.begin(), surface.old_vertex.end(), 0);
  surface.faces = gluing.faces().triangles;
  surface.old_face = gluing.faces().number;
  surface.twin.resize(gluing.twin().size());
  for(int side = 0; side < surface.number_of_sides(); ++side)
    surface.twin[place(turned(side))] = turned(gluing.twin()[place(side)]);
  for(std::size_t f = 0; f < surface.faces.size(); ++f)
    if(is_reversed[f])
      std::swap(surface.faces[f][1], surface.faces[f][2]);
  derive_vertices(surface);

  std::vector<bool> is_there(soup.points.size(), false);
  for(const int old : surface.old_vertex) {
    if(is_there[place(old)])
      defects.non_manifold_vertices.add(old);
    is_there[place(old)] = true;
  }
  return surface;
}

} // namespace CGAL::Spherical_parameterization::preparation
