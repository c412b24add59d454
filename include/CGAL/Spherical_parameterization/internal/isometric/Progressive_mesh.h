// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_PROGRESSIVE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_PROGRESSIVE_MESH_H

#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/match_halfedges.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The connectivity of a closed triangle mesh that can be coarsened by half-edge collapses, and refined again by
/// undoing them in reverse order (H. Hoppe, "Progressive meshes", SIGGRAPH 1996).
///
/// Halfedges are numbered as in a Corner_table; number h stands for the corner at the vertex that halfedge h leaves,
/// too. The two faces that vanish in a collapse keep their vertices and twins ("dancing links"), so that one halfedge
/// is all that needs to be remembered of it.
class Progressive_mesh {
public:
  /// \pre closed, oriented, without double edges
  Progressive_mesh(const Watched_loop<Host_loop>& loop, const Host_array<std::array<int, 3>>& faces,
                   int number_of_vertices)
    : corner_(number_of_vertices), degree_(number_of_vertices, 0), number_of_vertices_(number_of_vertices)
  {
    vertex_.reserve(3 * faces.size());
    for(const std::array<int, 3>& face : faces)
      for(int v : face) {
        corner_[v] = static_cast<int>(vertex_.size());
        vertex_.push_back(v);
        ++degree_[v];
      }
    match_halfedges(loop, faces, number_of_vertices, twin_);
  }

  static int next(int h) { return Corner_table::next(h); }
  static int previous(int h) { return Corner_table::previous(h); }

  int vertex(int corner) const { return vertex_[corner]; }
  int target(int h) const { return vertex_[next(h)]; }
  int apex(int h) const { return vertex_[previous(h)]; } ///< the corner opposite to h
  int degree(int v) const { return degree_[v]; }
  bool is_removed(int v) const { return corner_[v] < 0; }
  int number_of_vertices() const { return number_of_vertices_; } ///< that are not removed
  int capacity() const { return static_cast<int>(corner_.size()); }

  /// Whether f(c) holds for a corner c at v, tried counterclockwise.
  template <class F>
  bool any_corner(int v, F f) const
  {
    const int first = corner_[v];
    int c = first;
    do {
      if(f(c))
        return true;
      c = rotated(c);
    } while(c != first);
    return false;
  }

  /// Whether f(w) holds for a neighbour w of v.
  template <class F>
  bool any_neighbour(int v, F f) const
  {
    return any_corner(v, [&](int c) { return f(target(c)); });
  }

  /// f(c) for all corners c at v, counterclockwise. The neighbours are target(c).
  template <class F>
  void for_each_corner(int v, F f) const
  {
    any_corner(v, [&](int c) {
      f(c);
      return false;
    });
  }

  bool are_adjacent(int v, int w) const
  {
    if(degree_[v] > degree_[w])
      std::swap(v, w);
    return any_neighbour(v, [w](int u) { return u == w; });
  }

  /// The link condition: whether collapsing the edge leaves a triangulated sphere. Its ends must have exactly two
  /// common neighbours, the apexes of its faces, and there must be more than four vertices.
  bool is_collapsible(int half_edge) const
  {
    const int u = vertex(half_edge), v = target(half_edge);
    if(number_of_vertices_ <= 4)
      return false;
    boost::container::small_vector<int, 24> ring;
    for_each_corner(u, [&](int c) { ring.push_back(target(c)); });
    int common = 0;
    if(degree_[v] <= 2 * degree_[u])
      for_each_corner(v, [&](int c) { common += std::find(ring.begin(), ring.end(), target(c)) != ring.end(); });
    else // v may have very many neighbours
      for(int w : ring)
        common += w != v && are_adjacent(w, v);
    return common == 2;
  }

  /// Moves the vertex that the half-edge leaves into its target; to be followed by count_collapses(). Several threads
  /// may do so at once, if they touch no common vertex.
  /// \pre is_collapsible(half_edge)
  void collapse(int half_edge)
  {
    const int u = vertex(half_edge), v = target(half_edge), opposite = twin_[half_edge];
    const int left = twin_[previous(half_edge)], right = twin_[next(opposite)]; // outside of the two faces
    for(int c = left; c != next(opposite); c = rotated(c))                      // while the links are still there
      vertex_[c] = v;
    for(int vanishing : {half_edge, opposite}) {
      const int a = twin_[next(vanishing)], b = twin_[previous(vanishing)];
      twin_[a] = b;
      twin_[b] = a;
      --degree_[apex(vanishing)];
    }
    corner_[u] = -1;
    corner_[v] = left;
    corner_[apex(half_edge)] = next(left);
    corner_[apex(opposite)] = right;
    degree_[v] += degree_[u] - 4;
  }
  void count_collapses(int count) { number_of_vertices_ -= count; }

  /// Undoes collapses. \pre they do not touch each other's faces, and later ones that touch them are undone
  void undo_collapses(const Watched_loop<Host_loop>& loop, const std::vector<int>& half_edges)
  {
    constexpr int steps_of_a_task = 256;
    for_each_index<steps_of_a_task>(loop, static_cast<int>(half_edges.size()),
                                    [&](int i) { restore_links(half_edges[i]); });
    for(int h : half_edges) { // other vertices of their diamonds may be common
      ++degree_[apex(h)];
      ++degree_[apex(twin_[h])];
      degree_[target(h)] -= degree_[vertex(h)] - 4;
    }
    number_of_vertices_ += static_cast<int>(half_edges.size());
  }

private:
  /// The corner at the same vertex in the next face, counterclockwise.
  int rotated(int c) const { return twin_[previous(c)]; }

  void restore_links(int half_edge)
  {
    const int opposite = twin_[half_edge];
    for(int vanished : {half_edge, opposite})
      for(int side : {next(vanished), previous(vanished)})
        twin_[twin_[side]] = side;
    for(int c = twin_[previous(half_edge)]; c != next(opposite); c = rotated(c))
      vertex_[c] = vertex(half_edge);
    corner_[vertex(half_edge)] = half_edge;
    corner_[target(half_edge)] = next(half_edge);
  }

  Host_array<int> vertex_; ///< that a halfedge leaves
  Host_array<int> twin_;   ///< of a halfedge
  Host_array<int> corner_; ///< some corner at a vertex; -1: removed
  Host_array<int> degree_; ///< of a vertex
  int number_of_vertices_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_PROGRESSIVE_MESH_H
