// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_PROGRESSIVE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_PROGRESSIVE_MESH_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Corner_table.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The connectivity of a closed triangle mesh that can be coarsened by half-edge collapses, and refined again by
/// undoing them in reverse order (H. Hoppe, "Progressive meshes", SIGGRAPH 1996).
///
/// A corner table: corner 3f + k is corner k of face f. The two faces that vanish in a collapse keep their labels and
/// links ("dancing links"), so that one corner is all that needs to be remembered of it.
class Progressive_mesh {
public:
  /// \pre closed, oriented, without double edges
  template <class Loop>
  Progressive_mesh(const Loop& loop, const Host_array<std::array<int, 3>>& faces, int number_of_vertices)
    : vertex_(3 * faces.size()), opposite_(3 * faces.size()), corner_(number_of_vertices), degree_(number_of_vertices),
      number_of_vertices_(number_of_vertices)
  {
    for(std::size_t f = 0; f < faces.size(); ++f)
      for(int k = 0; k < 3; ++k) {
        const int c = static_cast<int>(3 * f) + k;
        vertex_[c] = faces[f][k];
        corner_[vertex_[c]] = c;
        ++degree_[vertex_[c]];
      }
    Host_array<int> twin;
    match_halfedges(loop, faces, number_of_vertices, twin);
    for(int h = 0; h < static_cast<int>(twin.size()); ++h)
      opposite_[previous(h)] = previous(twin[h]);
  }

  static int next(int c) { return Corner_table::next(c); }
  static int previous(int c) { return Corner_table::previous(c); }

  int vertex(int corner) const { return vertex_[corner]; }
  int degree(int v) const { return degree_[v]; }
  bool is_removed(int v) const { return corner_[v] < 0; }
  int number_of_vertices() const { return number_of_vertices_; } ///< that are not removed
  int capacity() const { return static_cast<int>(corner_.size()); }

  /// Some corner at v, which is not removed.
  int corner(int v) const { return corner_[v]; }
  /// The corner at the same vertex in the next face, counterclockwise.
  int rotated(int c) const { return next(opposite_[next(c)]); }

  /// f(c) for all corners c at v, counterclockwise. The neighbours are vertex(next(c)).
  template <class F>
  void for_each_corner(int v, F f) const
  {
    const int first = corner_[v];
    int c = first;
    do {
      f(c);
      c = rotated(c);
    } while(c != first);
  }

  bool are_adjacent(int v, int w) const
  {
    if(degree_[v] > degree_[w])
      std::swap(v, w);
    const int first = corner_[v];
    int c = first;
    do {
      if(vertex_[next(c)] == w)
        return true;
      c = rotated(c);
    } while(c != first);
    return false;
  }

  /// The link condition: whether collapsing the edge leaves a triangulated sphere. Its ends must have exactly two
  /// common neighbours, the apexes of its faces, and there must be more than four vertices.
  bool is_collapsible(int half_edge) const
  {
    const int u = vertex_[half_edge], v = vertex_[next(half_edge)];
    if(number_of_vertices_ <= 4)
      return false;
    boost::container::small_vector<int, 24> ring;
    for_each_corner(u, [&](int c) { ring.push_back(vertex_[next(c)]); });
    int common = 0;
    if(degree_[v] <= 2 * degree_[u])
      for_each_corner(v, [&](int c) { common += std::find(ring.begin(), ring.end(), vertex_[next(c)]) != ring.end(); });
    else // v may have very many neighbours
      for(int w : ring)
        common += w != v && are_adjacent(w, v);
    return common == 2;
  }

  /// Moves the vertex at corner `half_edge` into that at the next corner.
  /// \pre is_collapsible(half_edge)
  void collapse(int half_edge)
  {
    collapse_uncounted(half_edge);
    count_collapses(1);
  }

  /// The same for several threads at once, which touch no common vertex; to be followed by count_collapses().
  void collapse_uncounted(int half_edge)
  {
    const Diamond d = diamond(half_edge);
    for(int c = next(d.left_of_u); c != d.u_right; c = rotated(c)) // while the links are still there
      vertex_[c] = d.v;
    opposite_[d.left_of_u] = d.left_of_v;
    opposite_[d.left_of_v] = d.left_of_u;
    opposite_[d.right_of_u] = d.right_of_v;
    opposite_[d.right_of_v] = d.right_of_u;
    corner_[d.u] = -1;
    corner_[d.v] = next(d.left_of_u);
    corner_[d.left] = previous(d.left_of_u);
    corner_[d.right] = next(d.right_of_u);
    --degree_[d.left];
    --degree_[d.right];
    degree_[d.v] += degree_[d.u] - 4;
  }
  void count_collapses(int count) { number_of_vertices_ -= count; }

  /// Undoes collapses. \pre they do not touch each other's faces, and later ones that touch them are undone
  template <class Loop>
  void undo_collapses(const Loop& loop, const std::vector<int>& half_edges)
  {
    constexpr int steps_of_a_task = 256;
    for_each_part<steps_of_a_task>(loop, static_cast<int>(half_edges.size()), [&](int begin, int end) {
      for(int i = begin; i < end; ++i)
        restore_links(half_edges[i]);
    });
    for(int h : half_edges) { // other vertices of their diamonds may be common
      ++degree_[vertex_[previous(h)]];
      ++degree_[vertex_[opposite_[previous(h)]]];
      degree_[vertex_[next(h)]] -= degree_[vertex_[h]] - 4;
    }
    number_of_vertices_ += static_cast<int>(half_edges.size());
  }

private:
  /// The two faces (u, v, left) and (v, u, right) of an edge, and the corners opposite to their other edges.
  struct Diamond {
    int u, v, left, right;
    int u_right;                                      ///< corner at u in the right face
    int left_of_u, left_of_v, right_of_u, right_of_v; ///< opposite to the edges u-left, v-left, u-right, v-right
  };

  Diamond diamond(int c) const
  {
    const int right = opposite_[previous(c)];
    const int u_right = previous(right), v_right = next(right);
    return {vertex_[c],         vertex_[next(c)], vertex_[previous(c)], vertex_[right],    u_right,
            opposite_[next(c)], opposite_[c],     opposite_[v_right],   opposite_[u_right]};
  }

  void restore_links(int half_edge)
  {
    const Diamond d = diamond(half_edge);
    opposite_[d.left_of_v] = half_edge;
    opposite_[d.left_of_u] = next(half_edge);
    opposite_[d.right_of_v] = d.u_right;
    opposite_[d.right_of_u] = previous(d.u_right);
    for(int c = next(d.left_of_u); c != d.u_right; c = rotated(c))
      vertex_[c] = d.u;
    corner_[d.u] = half_edge;
    corner_[d.v] = next(half_edge);
  }

  Host_array<int> vertex_, opposite_;
  std::vector<int> corner_; ///< -1: removed
  std::vector<int> degree_;
  int number_of_vertices_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_PROGRESSIVE_MESH_H
