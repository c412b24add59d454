// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/handles.h"

#include "preparation/points.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>

namespace tool {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Sides by the vertex at which they begin.
class Star {
public:
  explicit Star(const Glued_surface& surface) : offset_(place(surface.number_of_vertices() + 1), 0)
  {
    for(int side = 0; side < surface.number_of_sides(); ++side)
      ++offset_[place(surface.origin(side) + 1)];
    for(std::size_t v = 1; v < offset_.size(); ++v)
      offset_[v] += offset_[v - 1];
    side_.resize(surface.twin.size());
    std::vector<int> end(offset_);
    for(int side = 0; side < surface.number_of_sides(); ++side)
      side_[place(end[place(surface.origin(side))]++)] = side;
  }

  const int* begin(int v) const { return side_.data() + offset_[place(v)]; }
  const int* end(int v) const { return side_.data() + offset_[place(v + 1)]; }

private:
  std::vector<int> offset_, side_;
};

/// Which of the 2 g closed paths of the dual graph that span its homology cross an edge, as bits. A closed path of
/// edges cuts the surface in two if and only if it crosses all of them an even number of times.
class Crossings {
public:
  Crossings(int number_of_sides, std::size_t paths)
    : words_((paths + 63) / 64), bits_(place(number_of_sides) * words_, 0)
  {}

  std::size_t words() const { return words_; }
  const std::uint64_t* of(int side) const { return bits_.data() + place(side) * words_; }
  void cross(const Glued_surface& surface, int side, std::size_t path)
  {
    for(const int s : {side, surface.twin_of(side)})
      bits_[place(s) * words_ + path / 64] ^= std::uint64_t(1) << (path % 64);
  }

private:
  std::size_t words_;
  std::vector<std::uint64_t> bits_;
};

/// Shortest paths from a vertex, as far as asked. Its arrays are used again and again.
class Search {
public:
  Search(const Glued_surface& surface, const Star& star, const std::vector<double>& length)
    : surface_(surface), star_(star), length_(length), distance_(surface.points.size(), infinite),
      arrival_(surface.points.size(), Glued_surface::none), is_settled_(surface.points.size(), false)
  {}

  /// Calls visit(v, side) for every vertex in the order of its distance, with the side by which it is reached.
  template <class Visit>
  void run(int root, double radius, const Visit& visit)
  {
    for(const int v : reached_) {
      distance_[place(v)] = infinite;
      is_settled_[place(v)] = false;
    }
    reached_.assign(1, root);
    distance_[place(root)] = 0;
    arrival_[place(root)] = Glued_surface::none;
    queue_ = {};
    queue_.emplace(0, root);
    while(!queue_.empty()) {
      const auto [d, v] = queue_.top();
      queue_.pop();
      if(is_settled_[place(v)])
        continue;
      if(d > radius)
        return;
      is_settled_[place(v)] = true;
      radius = std::min(radius, visit(v, arrival_[place(v)]));
      for(const int* side = star_.begin(v); side != star_.end(v); ++side) {
        const int w = surface_.target(*side);
        const double through_v = d + length_[place(*side)];
        if(through_v < distance_[place(w)]) {
          if(distance_[place(w)] == infinite)
            reached_.push_back(w);
          distance_[place(w)] = through_v;
          arrival_[place(w)] = *side;
          queue_.emplace(through_v, w);
        }
      }
    }
  }

  bool is_settled(int v) const { return is_settled_[place(v)]; }
  double distance(int v) const { return distance_[place(v)]; }
  int arrival(int v) const { return arrival_[place(v)]; }

  /// The sides of the path to a vertex.
  std::vector<int> path(int v) const
  {
    std::vector<int> sides;
    for(int side = arrival(v); side != Glued_surface::none; side = arrival(surface_.origin(side)))
      sides.push_back(side);
    std::reverse(sides.begin(), sides.end());
    return sides;
  }

  /// To the beginning of a side, along it, and back, without what there and back have in common.
  std::vector<int> loop(int side) const
  {
    const std::vector<int> there = path(surface_.origin(side)), back = path(surface_.target(side));
    std::size_t common = 0;
    while(common < there.size() && common < back.size() && there[common] == back[common])
      ++common;
    std::vector<int> result(there.begin() + static_cast<std::ptrdiff_t>(common), there.end());
    result.push_back(side);
    for(std::size_t i = back.size(); i > common; --i)
      result.push_back(surface_.twin_of(back[i - 1]));
    return result;
  }

private:
  using Entry = std::pair<double, int>;

  const Glued_surface& surface_;
  const Star& star_;
  const std::vector<double>& length_;
  std::vector<double> distance_;
  std::vector<int> arrival_;
  std::vector<bool> is_settled_;
  std::vector<int> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
};

/// A spanning tree of the faces that crosses no edge of the tree of paths: for every face the side that leads to the
/// root.
std::vector<int> dual_tree(const Glued_surface& surface, const Search& paths)
{
  const auto is_in_tree = [&](int side) {
    return paths.arrival(surface.target(side)) == side || paths.arrival(surface.origin(side)) == surface.twin_of(side);
  };
  std::vector<int> to_root(surface.faces.size(), Glued_surface::none), order = {0};
  std::vector<bool> is_reached(surface.faces.size(), false);
  is_reached[0] = true;
  for(std::size_t i = 0; i < order.size(); ++i)
    for(int side = 3 * order[i]; side < 3 * order[i] + 3; ++side) {
      const int twin = surface.twin_of(side), g = twin / 3;
      if(is_reached[place(g)] || is_in_tree(side))
        continue;
      is_reached[place(g)] = true;
      to_root[place(g)] = twin;
      order.push_back(g);
    }
  return to_root;
}

/// The edges in neither tree: two for each handle.
std::vector<int> remaining_edges(const Glued_surface& surface, const Search& paths, const std::vector<int>& to_root)
{
  std::vector<int> edges;
  for(int side = 0; side < surface.number_of_sides(); ++side) {
    const int twin = surface.twin_of(side);
    if(twin > side || paths.arrival(surface.target(side)) == side || paths.arrival(surface.target(twin)) == twin ||
       to_root[place(side / 3)] == side || to_root[place(twin / 3)] == twin)
      continue;
    edges.push_back(side);
  }
  return edges;
}

} // namespace

std::vector<int> shortest_handle_loop(const Glued_surface& surface, const std::function<void()>& go_on)
{
  const Star star(surface);
  std::vector<double> length(surface.twin.size());
  for(int side = 0; side < surface.number_of_sides(); ++side) // the same bits for both sides
    length[place(side)] = surface.length(std::min(side, surface.twin_of(side)));

  Search search(surface, star, length);
  search.run(0, infinite, [](int, int) { return infinite; });
  const std::vector<int> to_root = dual_tree(surface, search);
  const std::vector<int> edges = remaining_edges(surface, search, to_root);

  Crossings crossings(surface.number_of_sides(), edges.size());
  std::vector<int> best;
  double shortest = infinite;
  std::vector<bool> is_in_cut_graph(surface.points.size(), false);
  const auto keep_if_shorter = [&](const std::vector<int>& loop) {
    double sum = 0;
    for(const int side : loop)
      sum += length[place(side)];
    if(best.empty() || sum < shortest) {
      shortest = sum;
      best = loop;
    }
  };
  for(std::size_t i = 0; i < edges.size(); ++i) {
    const std::vector<int> loop = search.loop(edges[i]);
    keep_if_shorter(loop);
    for(const int side : loop)
      is_in_cut_graph[place(surface.origin(side))] = true;
    crossings.cross(surface, edges[i], i);
    for(const int side : {edges[i], surface.twin_of(edges[i])}) // what both ways to the root cross cancels
      for(int up = to_root[place(side / 3)]; up != Glued_surface::none; up = to_root[place(surface.twin_of(up) / 3)])
        crossings.cross(surface, up, i);
  }

  // the bits of a vertex are those of the path to it; two paths and an edge close a loop
  const std::size_t words = crossings.words();
  std::vector<std::uint64_t> bits(surface.points.size() * words, 0);
  for(int root = 0; root < surface.number_of_vertices(); ++root) {
    if(!is_in_cut_graph[place(root)])
      continue;
    go_on();
    int closing = Glued_surface::none;
    double closed = shortest * (1 - 1e-12); // not for the sake of rounding
    search.run(root, closed / 2, [&](int v, int arrival) {
      std::uint64_t* const own = &bits[place(v) * words];
      for(std::size_t w = 0; w < words; ++w)
        own[w] = arrival == Glued_surface::none
                   ? 0
                   : bits[place(surface.origin(arrival)) * words + w] ^ crossings.of(arrival)[w];
      for(const int* side = star.begin(v); side != star.end(v); ++side) {
        const int u = surface.target(*side);
        const double sum = search.distance(v) + length[place(*side)] + search.distance(u);
        if(!search.is_settled(u) || sum >= closed)
          continue;
        const std::uint64_t *const other = &bits[place(u) * words], *const crossed = crossings.of(*side);
        bool is_even = true;
        for(std::size_t w = 0; w < words && is_even; ++w)
          is_even = (own[w] ^ other[w] ^ crossed[w]) == 0;
        if(!is_even) {
          closed = sum;
          closing = *side;
        }
      }
      return closed / 2;
    });
    if(closing != Glued_surface::none)
      keep_if_shorter(search.loop(closing));
  }
  return best;
}

void cut_along(Glued_surface& surface, const std::vector<int>& loop)
{
  for(const int side : loop)
    surface.unglue(side);
  derive_vertices(surface);
}

} // namespace tool
