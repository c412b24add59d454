// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// By hand, since CGAL's Surface_mesh_topology finds the shortest cycle that is not contractible, which need not open a
// handle where there are two of them; and takes hundreds of times as long: 23 s on the kitten of 1,850 vertices, where
// this takes 0.06 s for the same loop.

#include "preparation/mend.h"
#include "preparation/points.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A closed surface with what a search asks again and again.
class Closed_surface {
public:
  explicit Closed_surface(Glued_surface& surface) : surface_(surface) { add_sides({}); }

  const Glued_surface* operator->() const { return &surface_; }
  const Glued_surface& operator*() const { return surface_; }
  double length(int side) const { return length_[place(side)]; }
  double length(const std::vector<int>& path) const
  {
    double sum = 0;
    for(const int side : path)
      sum += length(side);
    return sum;
  }

  /// Calls visit(side) for every side that begins at a vertex.
  template <class Visit>
  void for_each_side(int vertex, const Visit& visit) const
  {
    const int first = first_side_[place(vertex)];
    int side = first;
    do {
      visit(side);
      side = surface_.twin_of(Glued_surface::previous(side));
    } while(side != first);
  }

  /// Cuts the surface along a loop that meets no vertex twice, and fills both holes. Of the vertices of the loop there
  /// are two then: its own on its left, and copies on its right. Returns the loop on the right.
  std::vector<int> cut_and_fill(const std::vector<int>& loop)
  {
    std::vector<int> right;
    for(auto side = loop.rbegin(); side != loop.rend(); ++side)
      right.push_back(surface_.twin_of(*side));
    for(const int side : loop)
      surface_.unglue(side);
    for(const int end : right) {
      const int vertex = surface_.target(end);
      const int copy = surface_.add_vertex(Glued_surface::Point(surface_.point(vertex)));
      surface_.old_vertex.back() = surface_.old_vertex[place(vertex)];
      int side = Glued_surface::next(end); // and all others on the right that begin there
      surface_.faces[place(side / 3)][place(side % 3)] = copy;
      while(surface_.twin_of(side) != Glued_surface::none) {
        side = Glued_surface::next(surface_.twin_of(side));
        surface_.faces[place(side / 3)][place(side % 3)] = copy;
      }
    }
    fill_hole(surface_, loop);
    fill_hole(surface_, right);
    add_sides(loop);
    add_sides(right);
    return right;
  }

private:
  /// Those given, which may begin at other vertices now, and all that are new.
  void add_sides(const std::vector<int>& changed)
  {
    first_side_.resize(surface_.points.size(), Glued_surface::none);
    for(const int side : changed)
      first_side_[place(surface_.origin(side))] = side;
    for(int side = static_cast<int>(length_.size()); side < surface_.number_of_sides(); ++side) {
      length_.push_back(surface_.length(side));
      first_side_[place(surface_.origin(side))] = side;
    }
  }

  Glued_surface& surface_;
  std::vector<double> length_; ///< by side; the same bits for both sides of an edge
  std::vector<int> first_side_;
};

/// Shortest paths from a vertex, as far as asked. Its arrays are used again and again.
class Search {
public:
  explicit Search(const Closed_surface& surface) : surface_(surface) {}

  /// Calls visit(v, side) for every vertex in the order of its distance, with the side by which it is reached, as far
  /// as a radius, which what visit() returns makes smaller.
  template <class Visit>
  void run(int root, double radius, const Visit& visit)
  {
    for(const int v : reached_) {
      distance_[place(v)] = infinite;
      is_settled_[place(v)] = false;
    }
    const std::size_t vertices = surface_->points.size();
    distance_.resize(vertices, infinite);
    arrival_.resize(vertices, Glued_surface::none);
    is_settled_.resize(vertices, false);
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
      surface_.for_each_side(v, [&, from = d](int side) {
        ++sides_;
        const int w = surface_->target(side);
        const double through_v = from + surface_.length(side);
        if(through_v < distance_[place(w)]) {
          if(distance_[place(w)] == infinite)
            reached_.push_back(w);
          distance_[place(w)] = through_v;
          arrival_[place(w)] = side;
          queue_.emplace(through_v, w);
        }
      });
    }
  }

  /// That all searches together have looked at.
  std::size_t sides() const { return sides_; }
  bool is_settled(int v) const { return is_settled_[place(v)]; }
  double distance(int v) const { return distance_[place(v)]; }
  int arrival(int v) const { return arrival_[place(v)]; }

  bool is_in_tree(int side) const
  {
    return arrival(surface_->target(side)) == side || arrival(surface_->origin(side)) == surface_->twin_of(side);
  }

  /// The sides of the path to a vertex.
  std::vector<int> path(int v) const
  {
    std::vector<int> sides;
    for(int side = arrival(v); side != Glued_surface::none; side = arrival(surface_->origin(side)))
      sides.push_back(side);
    std::reverse(sides.begin(), sides.end());
    return sides;
  }

  /// To the beginning of a side, along it, and back, without what there and back have in common: a loop that meets no
  /// vertex twice.
  std::vector<int> loop(int side) const
  {
    const std::vector<int> there = path(surface_->origin(side)), back = path(surface_->target(side));
    const auto [first_there, last_back] = std::mismatch(there.begin(), there.end(), back.begin(), back.end());
    std::vector<int> result(first_there, there.end());
    result.push_back(side);
    for(auto step = back.end(); step != last_back;)
      result.push_back(surface_->twin_of(*--step));
    return result;
  }

private:
  using Entry = std::pair<double, int>;

  const Closed_surface& surface_;
  std::vector<double> distance_;
  std::vector<int> arrival_;
  std::vector<bool> is_settled_;
  std::vector<int> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue_;
  std::size_t sides_ = 0;
};

/// A spanning tree of the faces that crosses no edge of the tree of paths: for every face the side that leads to the
/// root. Edges that close long loops are crossed first, so that those that are left close short ones.
std::vector<int> dual_tree(const Closed_surface& surface, const Search& paths)
{
  std::vector<int> to_root(surface->faces.size(), Glued_surface::none);
  std::vector<bool> is_reached(surface->faces.size(), false);
  std::priority_queue<std::pair<double, int>> queue; // length of the loop, and the side
  const auto reach = [&](int face) {
    is_reached[place(face)] = true;
    for(int side = 3 * face; side < 3 * face + 3; ++side)
      if(!is_reached[place(surface->twin_of(side) / 3)] && !paths.is_in_tree(side))
        queue.emplace(
          paths.distance(surface->origin(side)) + surface.length(side) + paths.distance(surface->target(side)), side);
  };
  reach(0);
  while(!queue.empty()) {
    const int twin = surface->twin_of(queue.top().second);
    queue.pop();
    if(is_reached[place(twin / 3)])
      continue;
    to_root[place(twin / 3)] = twin;
    reach(twin / 3);
  }
  return to_root;
}

/// The edges in neither tree: two for each handle.
std::vector<int> remaining_edges(const Glued_surface& surface, const Search& paths, const std::vector<int>& to_root)
{
  std::vector<int> edges;
  for(int side = 0; side < surface.number_of_sides(); ++side) {
    const int twin = surface.twin_of(side);
    if(twin < side && !paths.is_in_tree(side) && to_root[place(side / 3)] != side && to_root[place(twin / 3)] != twin)
      edges.push_back(side);
  }
  return edges;
}

/// Which closed paths of the dual graph cross an edge, as bits. If they span its homology, a closed path of edges cuts
/// the surface in two if and only if it crosses all of them an even number of times.
class Crossings {
public:
  using Word = std::uint64_t;

  Crossings(int number_of_sides, std::size_t paths)
    : words_((paths + 63) / 64), bits_(place(number_of_sides) * words_, 0)
  {}

  std::size_t words() const { return words_; }
  std::size_t size() const { return bits_.size(); }
  const Word* of(int side) const { return bits_.data() + place(side) * words_; }

  void cross(const Glued_surface& surface, int side, std::size_t path)
  {
    for(const int s : {side, surface.twin_of(side)})
      bits_[place(s) * words_ + path / 64] ^= Word(1) << (path % 64);
  }

  /// Paths that cross the loop an odd number of times take one of them along: then all cross it evenly, and none ends
  /// at the holes when it is cut. \pre there is such a path
  void make_even(const std::vector<int>& loop)
  {
    std::vector<Word> odd(words_, 0);
    for(const int side : loop)
      add(odd.data(), of(side));
    std::size_t word = 0;
    while(odd[word] == 0)
      ++word;
    const Word one = odd[word] & (~odd[word] + 1);
    for(std::size_t i = 0; i < bits_.size(); i += words_)
      if((bits_[i + word] & one) != 0)
        add(&bits_[i], odd.data());
  }

  /// Leads the paths through the filling of a hole, of which `boundary` is what was the boundary. Any way is right that
  /// lets in what comes in.
  void fill(const Glued_surface& surface, const std::vector<int>& boundary, int first_side, int last_side)
  {
    std::unordered_map<int, std::vector<Word>> potential; // of an edge the difference; of new vertices 0
    std::vector<Word> sum(words_, 0);
    for(const int side : boundary) {
      potential[surface.origin(side)] = sum;
      add(sum.data(), of(side));
    }
    bits_.resize(std::max(bits_.size(), place(last_side) * words_), 0);
    for(int side = first_side; side < last_side; ++side)
      for(const int end : {surface.origin(side), surface.target(side)})
        if(const auto found = potential.find(end); found != potential.end())
          add(&bits_[place(side) * words_], found->second.data());
  }

private:
  void add(Word* sum, const Word* other) const
  {
    for(std::size_t w = 0; w < words_; ++w)
      sum[w] ^= other[w];
  }

  std::size_t words_;
  std::vector<Word> bits_;
};

/// Finds the loops, the shortest on what the cuts have left.
class Handle_cutter {
public:
  Handle_cutter(Glued_surface& surface, const std::function<void()>& go_on)
    : surface_(surface), search_(surface_), crossings_(surface.number_of_sides(), 0)
  {
    search_.run(0, infinite, [](int, int) { return infinite; });
    go_on();
    const std::vector<int> to_root = dual_tree(surface_, search_);
    const std::vector<int> edges = remaining_edges(surface, search_, to_root);
    crossings_ = Crossings(surface.number_of_sides(), edges.size());
    for(std::size_t i = 0; i < edges.size(); ++i) {
      go_on();
      const std::vector<int> loop = search_.loop(edges[i]);
      keep_if_shorter(loop);
      for(const int side : loop)
        set_bound(surface.origin(side), 0);
      crossings_.cross(surface, edges[i], i);
      for(const int side : {edges[i], surface.twin_of(edges[i])}) // what both ways to the root cross cancels
        for(int up = to_root[place(side / 3)]; up != Glued_surface::none; up = to_root[place(surface.twin_of(up) / 3)])
          crossings_.cross(surface, up, i);
    }
    constexpr double steps = 100;
    first_radius_ = !best_.empty() && shortest_ > 0 ? shortest_ / steps : 1;
  }

  /// None if it would take too long to find it. \pre there is a handle
  std::vector<int> shortest_loop(const std::function<void()>& go_on)
  {
    constexpr double growth = 2;
    for(;;) {
      if(is_exhausted())
        return {};
      const auto [bound, root] = roots_.top();
      if(bound != bound_[root]) { // another has taken its place
        roots_.pop();
        continue;
      }
      if(!best_.empty() && shortest_ <= bound)
        return best_;
      go_on();
      roots_.pop();
      set_bound(root, search_from(root, std::max(growth * bound, first_radius_)));
    }
  }

  void cut(const std::vector<int>& loop)
  {
    crossings_.make_even(loop);
    words_of_cuts_ += crossings_.size();
    const int before = surface_->number_of_sides();
    const std::vector<int> right = surface_.cut_and_fill(loop);
    for(const std::vector<int>* boundary : {&loop, &right}) {
      crossings_.fill(*surface_, *boundary, before, surface_->number_of_sides());
      for(const int side : *boundary)
        set_bound(surface_->origin(side), 0);
    }
    best_.clear();
    shortest_ = infinite;
  }

private:
  using Entry = std::pair<double, int>;

  /// Whether hundreds of handles have taken so many steps that the others are not worth them.
  bool is_exhausted() const
  {
    constexpr std::size_t most = 8'000'000'000, most_of_side = 10'000; // words; a side that is looked at counts as ten
    return search_.sides() * (10 + crossings_.words()) + words_of_cuts_ >
           most + most_of_side * place(surface_->number_of_sides());
  }

  /// Of loops through a vertex that are not of this length there is none that is shorter.
  void set_bound(int vertex, double length)
  {
    bound_[vertex] = length;
    roots_.emplace(length, vertex);
  }

  void keep_if_shorter(const std::vector<int>& loop)
  {
    if(const double length = surface_.length(loop); best_.empty() || length < shortest_) {
      shortest_ = length;
      best_ = loop;
    }
  }

  /// Looks for a loop through a vertex that is shorter than the best and than `most`; returns what no such loop is
  /// shorter than.
  double search_from(int root, double most)
  {
    // the bits of a vertex are those of the path to it; two paths and an edge close a loop
    using Word = Crossings::Word;
    const std::size_t words = crossings_.words();
    bits_.resize(surface_->points.size() * words, 0);
    const double rounded = shortest_ * (1 - 1e-12); // not for the sake of rounding
    int closing = Glued_surface::none;
    double closed = std::min(most, rounded);
    search_.run(root, closed / 2, [&](int v, int arrival) {
      Word* const own = &bits_[place(v) * words];
      for(std::size_t w = 0; w < words; ++w)
        own[w] = arrival == Glued_surface::none
                   ? 0
                   : bits_[place(surface_->origin(arrival)) * words + w] ^ crossings_.of(arrival)[w];
      surface_.for_each_side(v, [&](int side) {
        const int u = surface_->target(side);
        const double sum = search_.distance(v) + surface_.length(side) + search_.distance(u);
        if(!search_.is_settled(u) || sum >= closed)
          return;
        const Word *const other = &bits_[place(u) * words], *const crossed = crossings_.of(side);
        bool is_even = true;
        for(std::size_t w = 0; w < words && is_even; ++w)
          is_even = (own[w] ^ other[w] ^ crossed[w]) == 0;
        if(!is_even) {
          closed = sum;
          closing = side;
        }
      });
      return closed / 2;
    });
    if(closing != Glued_surface::none)
      keep_if_shorter(search_.loop(closing));
    return closed < rounded || closing != Glued_surface::none ? closed : shortest_;
  }

  Closed_surface surface_;
  Search search_;
  Crossings crossings_;
  double first_radius_ = 1;
  std::vector<int> best_; ///< the shortest loop that is known; none right after a cut
  double shortest_ = infinite;
  std::unordered_map<int, double> bound_; ///< of the vertices from which is searched
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> roots_;
  std::vector<Crossings::Word> bits_;
  std::size_t words_of_cuts_ = 0; ///< that all cuts together have looked at
};

} // namespace

int cut_handles(Glued_surface& surface, const std::function<void(const std::vector<int>& loop)>& before_cut,
                const std::function<void()>& go_on)
{
  const int handles = (2 - surface.number_of_vertices() + surface.number_of_faces() / 2) / 2; // Euler's formula
  if(handles == 0)
    return 0;
  constexpr std::size_t most_words = std::size_t(1) << 26; // of memory
  int cut = 0;
  if(place(handles) * place(surface.number_of_sides()) / 32 < most_words) {
    Handle_cutter cutter(surface, go_on);
    for(; cut < handles; ++cut) {
      const std::vector<int> loop = cutter.shortest_loop(go_on);
      if(loop.empty())
        break;
      before_cut(loop);
      cutter.cut(loop);
    }
    derive_vertices(surface);
  }
  if(cut < handles)
    cut_handles_at_once(surface, go_on);
  return handles - cut;
}

} // namespace CGAL::Spherical_parameterization::preparation
