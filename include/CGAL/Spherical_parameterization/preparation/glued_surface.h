// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_GLUED_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_GLUED_SURFACE_H

#include <boost/range/iterator_range_core.hpp>

#include <array>
#include <cstddef>
#include <vector>

/// Preparation of meshes. It is under the GPL, like the CGAL packages that it uses.
namespace CGAL::Spherical_parameterization::preparation {

/// \addtogroup PkgSphericalParameterizationPreparation
/// @{

/// References to arrays of points and triangles, which must outlive it.
struct Triangle_soup {
  typedef std::array<double, 3> Point; ///< coordinates
  typedef std::array<int, 3> Triangle; ///< indices of points

  boost::iterator_range<const Point*> points;       ///< all points
  boost::iterator_range<const Triangle*> triangles; ///< all triangles; indices must be in range

  /// \param p  a contiguous range of points
  /// \param t  a contiguous range of triangles
  template <class Points, class Triangles>
  Triangle_soup(const Points& p, const Triangles& t)
    : points(p.data(), p.data() + p.size()), triangles(t.data(), t.data() + t.size())
  {}
  /// \param soup  an object with the members `points` and `triangles`
  template <class Soup>
  Triangle_soup(const Soup& soup) : Triangle_soup(soup.points, soup.triangles)
  {}
  /// \cond SKIP_IN_MANUAL
  Triangle_soup(const Triangle_soup&) = default;
  /// \endcond
};

/// A surface of triangles that are glued along their sides, with or without boundary. Side `3 f + k` of face `f` runs
/// from its corner `k` to the next one. The vertices follow from the gluing: corners belong to one vertex if glued
/// sides connect them. So the surface is manifold, whatever the file was. To cut it, sides are unglued.
///
/// Glued sides run in opposite directions: the faces are oriented consistently.
struct Glued_surface {
  using Point = std::array<double, 3>; ///< coordinates

  std::vector<Point> points;             ///< by vertex
  std::vector<std::array<int, 3>> faces; ///< the vertices of the corners
  std::vector<int> twin;                 ///< by side; `none` at a boundary
  std::vector<int> old_vertex;           ///< by vertex: its index in the file, `none` if it is new
  std::vector<int> old_face;             ///< by face: its index in the file, `none` if it is new

  static constexpr int none = -1; ///< no vertex, side or face
  /// \cond SKIP_IN_MANUAL
  static int next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
  static int previous(int side) { return side % 3 == 0 ? side + 2 : side - 1; }
  int origin(int side) const { return faces[static_cast<std::size_t>(side / 3)][static_cast<std::size_t>(side % 3)]; }
  int target(int side) const { return origin(next(side)); }
  int twin_of(int side) const { return twin[static_cast<std::size_t>(side)]; }
  int number_of_faces() const { return static_cast<int>(faces.size()); }
  int number_of_sides() const { return static_cast<int>(twin.size()); }
  int number_of_vertices() const { return static_cast<int>(points.size()); }
  const Point& point(int vertex) const { return points[static_cast<std::size_t>(vertex)]; }
  double length(int side) const;
  double area(int face) const;

  void glue(int side, int other);
  void unglue(int side);
  int add_vertex(const Point& point);                                   ///< new, of no face yet
  int add_face(const std::array<int, 3>& corners, int old_face = none); ///< glued to nothing yet
  /// \endcond
};

/// \cond SKIP_IN_MANUAL
/// All as one: vertices and faces in the order of the file, copies and new ones after these.
Glued_surface joined(const std::vector<Glued_surface>& parts);

/// Gives every corner the vertex that the gluing says. A vertex that has come apart is copied, vertices that have been
/// glued together become the first of them, and those without faces are left out; the others keep their order.
void derive_vertices(Glued_surface& surface);

/// The sides at the boundary, in the direction of their faces, one cycle after the other.
std::vector<std::vector<int>> boundary_cycles(const Glued_surface& surface);
/// \endcond

/// A connected component.
struct Component {
  int faces = 0;                ///< number of faces
  int first_face = 0;           ///< the smallest index of its faces
  int holes = 0;                ///< number of boundary cycles
  int euler_characteristic = 0; ///< V - E + F
  double area = 0;              ///< area of the faces
  double volume = 0;            ///< signed; meaningless with holes

  /// \return the genus after all holes are closed
  int genus() const { return (2 - euler_characteristic - holes) / 2; }
};

/// \cond SKIP_IN_MANUAL
/// The connected components. `component_of[f]` is the number of that of face `f`.
std::vector<Component> components(const Glued_surface& surface, std::vector<int>& component_of);

/// Splits edges in the middle until no two have the same end vertices and none has but one: so that faces are sets of
/// three vertices, and edges sets of two, as files need it. Returns how many edges were split.
/// \pre the vertices are derived
std::size_t split_parallel_edges(Glued_surface& surface);
/// \endcond

/// @}

} // namespace CGAL::Spherical_parameterization::preparation

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_GLUED_SURFACE_H
