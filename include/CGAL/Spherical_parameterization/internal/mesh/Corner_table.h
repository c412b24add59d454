// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CORNER_TABLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CORNER_TABLE_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/base/vec3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The connectivity of a closed oriented triangle mesh. Number 3 f + k stands for corner k of face f, and for the
/// halfedge from there to the next corner of the face.
struct Corner_table {
  Host_array<std::array<int, 3>> face; ///< the vertices, counterclockwise
  Host_array<int> twin;                ///< by halfedge: the opposite one

  int number_of_halfedges() const { return static_cast<int>(3 * face.size()); }
  int origin(int h) const { return face[h / 3][h % 3]; }
  int target(int h) const { return origin(next(h)); }
  int apex(int h) const { return origin(previous(h)); } ///< the corner opposite to h
  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }
};

/// Normal of a face, as long as twice its area.
inline vec3 normal(const Host_array<vec3>& points, const std::array<int, 3>& f)
{
  return outer(sub(points[f[1]], points[f[0]]), sub(points[f[2]], points[f[0]]));
}

/// Edges that have not two faces of the same orientation.
struct Edge_trouble {
  std::size_t count = 0;
  std::pair<int, int> first; ///< the ends of the first one

  void add(const Edge_trouble& others)
  {
    if(count == 0)
      first = others.first;
    count += others.count;
  }
};

/// What matching halfedges has found.
struct Edge_troubles {
  Edge_trouble crowded;  ///< edges with more than two faces
  Edge_trouble opposed;  ///< edges whose two faces have opposite orientations
  Edge_trouble boundary; ///< edges with one face

  bool none() const { return crowded.count == 0 && opposed.count == 0 && boundary.count == 0; }
};

/// Matches the halfedges of faces, whose corners are numbers below n: twin[h] is the halfedge from the target of h to
/// its origin, or -1 where there is not exactly one.
///
/// Halfedges are grouped by their smaller end (counting sort), and sorted within the groups: O(n) for bounded degrees.
inline Edge_troubles match_halfedges(const Host_loop& loop, const Host_array<std::array<int, 3>>& face, int n,
                                     Host_array<int>& twin)
{
  const int m = static_cast<int>(3 * face.size());
  const auto origin = [&](int h) { return face[h / 3][h % 3]; };
  const auto target = [&](int h) { return face[h / 3][(h + 1) % 3]; };
  const auto smaller = [&](int h) { return (std::min)(origin(h), target(h)); };
  const auto larger = [&](int h) { return (std::max)(origin(h), target(h)); };
  Host_array<int> offset(n + 1, 0), order(m);
  for(int h = 0; h < m; ++h)
    ++offset[smaller(h) + 1];
  for(int v = 0; v < n; ++v)
    offset[v + 1] += offset[v];
  Host_array<int> place(offset.begin(), offset.end() - 1);
  for(int h = 0; h < m; ++h)
    order[place[smaller(h)]++] = h;
  twin.resize(m);

  const std::vector<Edge_troubles> parts = results_of_parts(loop, n, [&](int begin, int end) {
    Edge_troubles troubles;
    for(int v = begin; v < end; ++v) {
      const auto last = order.begin() + offset[v + 1];
      std::sort(order.begin() + offset[v], last,
                [&](int g, int h) { return std::make_pair(larger(g), g) < std::make_pair(larger(h), h); });
      for(auto it = order.begin() + offset[v]; it != last;) {
        const auto group = it;
        const int w = larger(*group);
        while(it != last && larger(*it) == w)
          twin[*it++] = -1;
        if(it - group > 2)
          troubles.crowded.add({1, {v, w}});
        else if(it - group == 1)
          troubles.boundary.add({1, {v, w}});
        else if(origin(group[0]) == origin(group[1]))
          troubles.opposed.add({1, {v, w}});
        else {
          twin[group[0]] = group[1];
          twin[group[1]] = group[0];
        }
      }
    }
    return troubles;
  });

  Edge_troubles all;
  for(const Edge_troubles& part : parts) {
    all.crowded.add(part.crowded);
    all.opposed.add(part.opposed);
    all.boundary.add(part.boundary);
  }
  return all;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_CORNER_TABLE_H
