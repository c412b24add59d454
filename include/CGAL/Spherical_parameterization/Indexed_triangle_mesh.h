// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INDEXED_TRIANGLE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INDEXED_TRIANGLE_MESH_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/surface/check_soup.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/iterator/iterator_adaptor.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMap
/// @{

/// A closed, oriented, connected triangle mesh of genus 0, made of arrays of points and index triples, as CGAL's
/// functions for polygon soups take them. It is a model of `FaceListGraph`, `HalfedgeListGraph` and `EdgeListGraph`, so
/// all functions of this package take it. It cannot be changed. The indices of vertices and faces are those of the
/// arrays: `v.idx()`, `f.idx()`.
///
/// Maps are the same bit for bit as those of a `CGAL::Surface_mesh` to which the same faces are added one by one.
/// Memory: 80 bytes per vertex.
class Indexed_triangle_mesh {
public:
  /// \cond SKIP_IN_MANUAL
  template <int Kind>
  class Index {
  public:
    Index() = default;
    explicit Index(int i) : i_(i) {}
    int idx() const { return i_; }
    friend bool operator==(Index a, Index b) { return a.i_ == b.i_; }
    friend bool operator!=(Index a, Index b) { return a.i_ != b.i_; }
    friend bool operator<(Index a, Index b) { return a.i_ < b.i_; }
    friend std::size_t hash_value(Index a) { return static_cast<std::size_t>(a.i_); }

  private:
    int i_ = -1;
  };
  typedef Index<0> Vertex_index;
  typedef Index<1> Halfedge_index;
  typedef Index<2> Edge_index; ///< by the smaller of its halfedges
  typedef Index<3> Face_index;

  template <class I>
  class Iterator
    : public boost::iterator_adaptor<Iterator<I>, int, I, std::random_access_iterator_tag, I, std::ptrdiff_t> {
  public:
    explicit Iterator(int i = 0) : Iterator::iterator_adaptor_(i) {}

  private:
    friend class boost::iterator_core_access;
    I dereference() const { return I(this->base()); }
  };
  template <class I>
  static CGAL::Iterator_range<Iterator<I>> range(std::size_t size)
  {
    return {Iterator<I>(0), Iterator<I>(static_cast<int>(size))};
  }
  /// Of all halfedges those that name an edge.
  struct Names_edge {
    const Indexed_triangle_mesh* mesh = nullptr;
    bool operator()(Edge_index e) const { return e.idx() < mesh->table_.twin[e.idx()]; }
  };
  typedef boost::filter_iterator<Names_edge, Iterator<Edge_index>> Edge_iterator;
  /// \endcond

  /// The type of `get(CGAL::vertex_point, mesh)`.
  typedef std::array<double, 3> Point;

  /// Checks a soup and makes the mesh.
  /// \param points     a range of points, with x(), y(), z() or operator[]
  /// \param triangles  a range of ranges of three indices of points, counterclockwise as seen from outside
  /// \throws Error if the triangles do not form a closed, oriented, connected surface of genus 0. The error says what
  ///         is wrong, where, and what to do
  ///
  /// Complexity: O(n).
  template <class PointRange, class TriangleRange>
  Indexed_triangle_mesh(const PointRange& points, const TriangleRange& triangles)
    : Indexed_triangle_mesh(CGAL::Sequential_tag(), points, triangles)
  {}

  /// The same on the threads of a policy.
  /// \param policy     `CGAL::Sequential_tag` or `CGAL::Parallel_tag`
  /// \param points     as above
  /// \param triangles  as above
  template <class ExecutionPolicy, class PointRange, class TriangleRange>
  Indexed_triangle_mesh(const ExecutionPolicy& policy, const PointRange& points, const TriangleRange& triangles)
  {
    read(points, triangles);
    check(internal::host_loop(policy));
  }

  /// \cond SKIP_IN_MANUAL
  /// The same of arrays that are not copied.
  template <class ExecutionPolicy>
  Indexed_triangle_mesh(const ExecutionPolicy& policy, std::vector<Point>&& points,
                        internal::Host_array<std::array<int, 3>>&& triangles)
    : point_(std::move(points))
  {
    const internal::Host_loop loop = internal::host_loop(policy);
    table_.face = std::move(triangles);
    check_sizes(point_.size(), table_.face.size());
    const int n = static_cast<int>(point_.size()), m = static_cast<int>(table_.face.size());
    const int bad_point =
      internal::first_index(loop, n, [&](int i) { return !internal::is_finite(internal::coordinates(point_[i])); });
    if(bad_point < n)
      refuse_point(static_cast<std::size_t>(bad_point));
    const auto is_bad = [&](int i) { return i < 0 || i >= n; };
    const int bad_triangle = internal::first_index(
      loop, m, [&](int f) { return std::any_of(table_.face[f].begin(), table_.face[f].end(), is_bad); });
    if(bad_triangle < m) {
      const std::array<int, 3>& face = table_.face[bad_triangle];
      refuse_index(static_cast<std::size_t>(bad_triangle), *std::find_if(face.begin(), face.end(), is_bad));
    }
    check(loop);
  }

  /// Any triangles, checked for nothing but the range of their indices: to be written to a file, or looked at face by
  /// face. There are no opposite halfedges, and no halfedges of vertices.
  struct Unchecked {};
  template <class TriangleRange>
  Indexed_triangle_mesh(Unchecked, std::vector<Point> points, const TriangleRange& triangles)
    : point_(std::move(points))
  {
    read_triangles(triangles);
  }

  /// Gives back the memory of all but points and triangles. The mesh is then as if it had not been checked.
  void forget_neighbours()
  {
    for(internal::Host_array<int>* array : {&table_.twin, &last_corner_, &breadth_first_})
      internal::Host_array<int>().swap(*array); // which clear() and {} do not do
  }
  /// \endcond

  /// \return the number of vertices
  std::size_t number_of_vertices() const { return point_.size(); }
  /// \return the number of faces
  std::size_t number_of_faces() const { return table_.face.size(); }
  /// \return the points, in the order of the vertices
  const std::vector<Point>& points() const { return point_; }
  /// \param f  the index of a face
  /// \return the indices of its vertices, in the given order
  const std::array<int, 3>& triangle(std::size_t f) const { return table_.face[f]; }

  /// \cond SKIP_IN_MANUAL
  const internal::Corner_table& corner_table() const { return table_; }
  /// The numbers of the vertices in breadth-first order, as readers of surfaces want them.
  const internal::Host_array<int>& breadth_first_order() const { return breadth_first_; }

  typedef Indexed_triangle_mesh Self;
  friend auto vertices(const Self& m) { return range<Vertex_index>(m.point_.size()); }
  friend auto faces(const Self& m) { return range<Face_index>(m.table_.face.size()); }
  friend auto halfedges(const Self& m) { return range<Halfedge_index>(m.table_.twin.size()); }
  friend CGAL::Iterator_range<Edge_iterator> edges(const Self& m)
  {
    const auto all = range<Edge_index>(m.table_.twin.size());
    return {Edge_iterator({&m}, all.begin(), all.end()), Edge_iterator({&m}, all.end(), all.end())};
  }
  friend std::size_t num_vertices(const Self& m) { return m.point_.size(); }
  friend std::size_t num_faces(const Self& m) { return m.table_.face.size(); }
  friend std::size_t num_halfedges(const Self& m) { return m.table_.twin.size(); }
  friend std::size_t num_edges(const Self& m) { return m.table_.twin.size() / 2; }

  friend Vertex_index source(Halfedge_index h, const Self& m) { return Vertex_index(m.table_.origin(h.idx())); }
  friend Vertex_index target(Halfedge_index h, const Self& m) { return Vertex_index(m.table_.target(h.idx())); }
  friend Vertex_index source(Edge_index e, const Self& m) { return Vertex_index(m.table_.origin(e.idx())); }
  friend Vertex_index target(Edge_index e, const Self& m) { return Vertex_index(m.table_.target(e.idx())); }
  friend Halfedge_index next(Halfedge_index h, const Self& m) { return Halfedge_index(m.table_.next(h.idx())); }
  friend Halfedge_index prev(Halfedge_index h, const Self& m) { return Halfedge_index(m.table_.previous(h.idx())); }
  friend Halfedge_index opposite(Halfedge_index h, const Self& m) { return Halfedge_index(m.table_.twin[h.idx()]); }
  friend Face_index face(Halfedge_index h, const Self&) { return Face_index(h.idx() / 3); }
  friend Edge_index edge(Halfedge_index h, const Self& m)
  {
    return Edge_index((std::min)(h.idx(), m.table_.twin[h.idx()]));
  }
  friend Halfedge_index halfedge(Edge_index e, const Self&) { return Halfedge_index(e.idx()); }
  /// The halfedges that CGAL::Euler::add_face() leaves at vertices and faces: the one to the vertex in its last face,
  /// and the one to the first corner of the face.
  friend Halfedge_index halfedge(Vertex_index v, const Self& m)
  {
    return Halfedge_index(m.table_.previous(m.last_corner_[v.idx()]));
  }
  friend Halfedge_index halfedge(Face_index f, const Self&) { return Halfedge_index(3 * f.idx() + 2); }
  friend std::pair<Halfedge_index, bool> halfedge(Vertex_index u, Vertex_index v, const Self& m)
  {
    const Halfedge_index first = halfedge(v, m);
    Halfedge_index h = first;
    do {
      if(source(h, m) == u)
        return {h, true};
      h = opposite(next(h, m), m);
    } while(h != first);
    return {Halfedge_index(), false};
  }
  friend std::size_t degree(Face_index, const Self&) { return 3; }

  struct Point_map {
    typedef Vertex_index key_type;
    typedef Point value_type;
    typedef const Point& reference;
    typedef boost::readable_property_map_tag category;

    const Self* mesh;
    friend reference get(const Point_map& map, Vertex_index v) { return map.mesh->points()[v.idx()]; }
  };
  friend Point_map get(CGAL::vertex_point_t, const Self& m) { return {&m}; }
  friend const Point& get(CGAL::vertex_point_t, const Self& m, Vertex_index v) { return m.point_[v.idx()]; }
  /// \endcond

private:
  static void check_sizes(std::size_t number_of_points, std::size_t number_of_triangles)
  {
    constexpr std::size_t most = (std::numeric_limits<int>::max)() / 3;
    if(number_of_points > most || number_of_triangles > most)
      throw internal::Input_error(Error_code::TOO_LARGE, std::to_string(number_of_points) + " points and " +
                                                           std::to_string(number_of_triangles) +
                                                           " triangles; at most 715,827,882 of each are supported");
  }

  [[noreturn]] static void refuse_point(std::size_t point)
  {
    throw internal::Input_error(Error_code::NON_FINITE_COORDINATE, "vertex " + std::to_string(point));
  }

  template <class Number>
  [[noreturn]] void refuse_index(std::size_t triangle, Number index) const
  {
    throw internal::Input_error(Error_code::BAD_INDEX,
                                "triangle " + std::to_string(triangle) + " names point " + std::to_string(index) +
                                  " of " + std::to_string(point_.size()) + "; points are numbered from 0 on");
  }

  CGAL_SP_INLINE void check(const internal::Host_loop& loop)
  {
    internal::Checked_soup soup =
      internal::check_soup(loop, table_, static_cast<int>(point_.size()), [&] { return number_of_different_points(); });
    const internal::Soup_trouble& trouble = soup.trouble;
    if(trouble.code != Error_code::OK)
      throw internal::Input_error(trouble.code, trouble.wrong, trouble.remedy);
    last_corner_ = std::move(soup.last_corner);
    breadth_first_ = std::move(soup.breadth_first);
  }

  template <class PointRange, class TriangleRange>
  void read(const PointRange& points, const TriangleRange& triangles)
  {
    const auto size = [](const auto& range) {
      return static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
    };
    const std::size_t number_of_points = size(points), number_of_triangles = size(triangles);
    check_sizes(number_of_points, number_of_triangles);
    point_.reserve(number_of_points);
    for(const auto& p : points) {
      const internal::vec3 c = internal::coordinates(p);
      if(!internal::is_finite(c))
        refuse_point(point_.size());
      point_.push_back({c.x, c.y, c.z});
    }
    table_.face.reserve(number_of_triangles);
    read_triangles(triangles);
  }

  template <class TriangleRange>
  void read_triangles(const TriangleRange& triangles)
  {
    using internal::Input_error;
    const std::size_t number_of_points = point_.size();
    for(const auto& t : triangles) {
      std::array<int, 3> face = {0, 0, 0};
      std::size_t corner = 0;
      for(const auto& i : t) {
        const auto index = static_cast<std::size_t>(i);
        if(index >= number_of_points)
          refuse_index(table_.face.size(), i);
        if(corner < 3)
          face[corner] = static_cast<int>(index);
        ++corner;
      }
      if(corner != 3)
        throw Input_error(Error_code::NOT_TRIANGULAR, "face " + std::to_string(table_.face.size()) + " has " +
                                                        std::to_string(corner) +
                                                        " corners; triangulate the mesh first");
      table_.face.push_back(face);
    }
  }

  std::size_t number_of_different_points() const
  {
    std::vector<Point> sorted = point_;
    std::sort(sorted.begin(), sorted.end());
    return static_cast<std::size_t>(std::unique(sorted.begin(), sorted.end()) - sorted.begin());
  }

  std::vector<Point> point_;
  internal::Corner_table table_;
  internal::Host_array<int> last_corner_;   ///< by vertex
  internal::Host_array<int> breadth_first_; ///< the vertices in this order
};

/// @}

} // namespace CGAL::Spherical_parameterization

/// \cond SKIP_IN_MANUAL
namespace boost {

template <>
struct graph_traits<CGAL::Spherical_parameterization::Indexed_triangle_mesh> {
private:
  typedef CGAL::Spherical_parameterization::Indexed_triangle_mesh Mesh;
  struct Traversal : virtual public boost::vertex_list_graph_tag, virtual public boost::edge_list_graph_tag {};

public:
  typedef Mesh::Vertex_index vertex_descriptor;
  typedef Mesh::Halfedge_index halfedge_descriptor;
  typedef Mesh::Edge_index edge_descriptor;
  typedef Mesh::Face_index face_descriptor;
  typedef Mesh::Iterator<vertex_descriptor> vertex_iterator;
  typedef Mesh::Iterator<halfedge_descriptor> halfedge_iterator;
  typedef Mesh::Edge_iterator edge_iterator;
  typedef Mesh::Iterator<face_descriptor> face_iterator;
  typedef boost::undirected_tag directed_category;
  typedef boost::disallow_parallel_edge_tag edge_parallel_category;
  typedef Traversal traversal_category;
  typedef std::size_t vertices_size_type;
  typedef std::size_t edges_size_type;
  typedef std::size_t halfedges_size_type;
  typedef std::size_t faces_size_type;
  typedef std::size_t degree_size_type;

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

template <>
struct graph_traits<const CGAL::Spherical_parameterization::Indexed_triangle_mesh>
  : graph_traits<CGAL::Spherical_parameterization::Indexed_triangle_mesh> {};

template <>
struct property_map<CGAL::Spherical_parameterization::Indexed_triangle_mesh, CGAL::vertex_point_t> {
  typedef CGAL::Spherical_parameterization::Indexed_triangle_mesh::Point_map type;
  typedef type const_type;
};

} // namespace boost

template <>
struct CGAL::graph_has_property<CGAL::Spherical_parameterization::Indexed_triangle_mesh, CGAL::vertex_point_t>
  : CGAL::Tag_true {};

template <int Kind>
struct std::hash<CGAL::Spherical_parameterization::Indexed_triangle_mesh::Index<Kind>>
  : boost::hash<CGAL::Spherical_parameterization::Indexed_triangle_mesh::Index<Kind>> {};
/// \endcond

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INDEXED_TRIANGLE_MESH_H
