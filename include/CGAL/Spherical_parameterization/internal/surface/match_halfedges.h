// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MATCH_HALFEDGES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MATCH_HALFEDGES_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/surface/breadth_first.h>
#include <CGAL/Spherical_parameterization/internal/surface/fans.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Places of one kind where faces do not fit together: how many there are, and the first one.
template <class Place>
struct Trouble {
  std::size_t count = 0;
  Place first = {};

  void add(const Trouble& others)
  {
    if(count == 0)
      first = others.first;
    count += others.count;
  }
};
typedef Trouble<std::pair<int, int>> Edge_trouble; ///< edges by their ends, the smaller one first
typedef Trouble<int> Vertex_trouble;

/// What matching halfedges has found.
struct Matching_troubles {
  Edge_trouble crowded;    ///< edges with more than two faces
  Edge_trouble opposed;    ///< edges whose two faces have opposite orientations
  Edge_trouble boundary;   ///< edges with one face
  Vertex_trouble isolated; ///< vertices without faces
  Vertex_trouble pinched;  ///< vertices whose faces form no cycle; also where that is for one of these edges

  bool has_bad_edge() const { return crowded.count > 0 || opposed.count > 0 || boundary.count > 0; }
  bool none() const { return isolated.count == 0 && pinched.count == 0; }

  void add(const Matching_troubles& others)
  {
    crowded.add(others.crowded);
    opposed.add(others.opposed);
    boundary.add(others.boundary);
    isolated.add(others.isolated);
    pinched.add(others.pinched);
  }
};

/// The corners at a vertex, each with the vertices before and after it in its face: all that is needed to walk over the
/// faces round the vertex, and to match halfedges there.
class Fan_walk {
public:
  Fan_walk(const Fan& fan, const Host_array<std::array<int, 3>>& face) : fan_(fan)
  {
    const int degree = fan.size();
    if(degree > small) {
      many_.resize(degree);
      sorted_.reserve(degree);
    }
    side_ = degree > small ? many_.data() : few_.data();
    for(int i = 0; i < degree; ++i) {
      const std::array<int, 3>& f = face[fan[i] / 3];
      const int k = fan[i] % 3;
      side_[i] = {f[(k + 2) % 3], f[(k + 1) % 3]};
      if(degree > small)
        sorted_.emplace_back(side_[i].before, i);
    }
    std::sort(sorted_.begin(), sorted_.end());
  }
  Fan_walk(const Fan_walk&) = delete;
  Fan_walk& operator=(const Fan_walk&) = delete;

  /// Walks counterclockwise from the last corner on, matches the halfedges from the vertex, and calls visit(v) for its
  /// neighbours. Returns whether that has met all faces, once each, and ended where it began.
  template <class Visit>
  bool go_round(Host_array<int>& twin, Visit visit) const
  {
    const int last = fan_.size() - 1;
    int i = last, steps = 0;
    do {
      visit(side_[i].before);
      const int next = corner_after(side_[i].after);
      if(next < 0)
        return false;
      twin[fan_[i]] = Corner_table::previous(fan_[next]);
      i = next;
      ++steps;
    } while(i != last && steps <= last);
    return i == last && steps == last + 1;
  }

  /// Where that has failed: matches those halfedges from the vertex that have one opposite one, and notes the troubles
  /// of the edges to larger vertices.
  void match_by_ends(Host_array<int>& twin, Matching_troubles& troubles) const
  {
    struct Halfedge {
      int other_end, number;
      bool comes_in;
    };
    std::vector<Halfedge> halfedges;
    for(int i = 0; i < fan_.size(); ++i) {
      halfedges.push_back({side_[i].after, fan_[i], false});
      halfedges.push_back({side_[i].before, Corner_table::previous(fan_[i]), true});
    }
    std::sort(halfedges.begin(), halfedges.end(), [](const Halfedge& g, const Halfedge& h) {
      return std::make_pair(g.other_end, g.comes_in) < std::make_pair(h.other_end, h.comes_in);
    });
    for(auto it = halfedges.begin(); it != halfedges.end();) {
      const auto edge = it;
      for(; it != halfedges.end() && it->other_end == edge->other_end; ++it)
        if(!it->comes_in)
          twin[it->number] = -1;
      const auto faces = it - edge;
      if(faces == 2 && !edge[0].comes_in && edge[1].comes_in)
        twin[edge[0].number] = edge[1].number;
      else if(edge->other_end > fan_.vertex)
        (faces > 2    ? troubles.crowded
         : faces == 1 ? troubles.boundary
                      : troubles.opposed)
          .add({1, {fan_.vertex, edge->other_end}});
    }
  }

private:
  static constexpr int small = 24; ///< so many corners are looked through to find one

  struct Sides {
    int before, after;
  };

  /// The corner that comes after vertex v in its face; -1 if there is not exactly one.
  int corner_after(int v) const
  {
    int found = -1;
    if(fan_.size() > small) {
      const auto it = std::lower_bound(sorted_.begin(), sorted_.end(), std::make_pair(v, 0));
      const bool is_there = it != sorted_.end() && it->first == v;
      return is_there && (it + 1 == sorted_.end() || it[1].first != v) ? it->second : -1;
    }
    for(int i = 0; i < fan_.size(); ++i)
      if(side_[i].before == v) {
        if(found >= 0)
          return -1;
        found = i;
      }
    return found;
  }

  const Fan& fan_;
  std::array<Sides, small> few_;
  std::vector<Sides> many_;
  std::vector<std::pair<int, int>> sorted_; ///< of many: the vertex before the corner, and its place in the fan
  Sides* side_;
};

/// How the walks round all vertices went.
struct Vertex_walks {
  Host_array<int> last_corner; ///< at every vertex, where the walk begins; -1 if there is none
  Neighbours neighbours;       ///< the vertices that it meets: all of them, if there are no troubles
};

/// Matches the halfedges of faces, which have three different corners below n: twin[h] becomes the halfedge from the
/// target of h to its origin, or -1 where there is not exactly one.
///
/// O(n) for bounded degrees, and d log d for a vertex of degree d.
/// \param walks  filled if it is not null
template <class Loop>
Matching_troubles match_halfedges(const Loop& loop, const Host_array<std::array<int, 3>>& face, int n,
                                  Host_array<int>& twin, Vertex_walks* walks = nullptr)
{
  twin.resize(3 * face.size());
  if(walks) {
    walks->last_corner.resize(n);
    walks->neighbours.offset.resize(n + 1);
    walks->neighbours.offset[n] = static_cast<int>(twin.size());
    walks->neighbours.target.resize(twin.size());
  }
  const auto match = [&](Matching_troubles& troubles, const Fan& fan) {
    int place = fan.first;
    if(walks) {
      walks->last_corner[fan.vertex] = fan.empty() ? -1 : fan[fan.size() - 1];
      walks->neighbours.offset[fan.vertex] = place;
    }
    if(fan.empty())
      return troubles.isolated.add({1, fan.vertex});
    const Fan_walk walk(fan, face);
    const bool is_cycle = walk.go_round(twin, [&](int v) {
      if(walks)
        walks->neighbours.target[place++] = v;
    });
    if(!is_cycle) {
      troubles.pinched.add({1, fan.vertex});
      walk.match_by_ends(twin, troubles);
    }
  };
  Matching_troubles all;
  for(const Matching_troubles& part : parts_of_fans<Matching_troubles>(loop, face, n, match))
    all.add(part);
  return all;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MATCH_HALFEDGES_H
