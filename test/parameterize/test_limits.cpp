// SPDX-License-Identifier: GPL-3.0-or-later
// Indices are numbers of 32 bits: what has more is refused before anything overflows, or takes memory.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/spherical_parameterization.h>

#include <boost/iterator/iterator_facade.hpp>

#include <catch2/catch.hpp>

#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace {

typedef CGAL::Simple_cartesian<double>::Point_3 Point_3;

[[noreturn]] void walk() { throw std::logic_error("looked at an element"); }

/// A mesh of which nothing can be known but how large it is.
struct Vast_mesh {
  std::size_t vertices, faces;
};

/// A vertex, halfedge, edge or face, told apart by `Kind`.
template <int Kind>
struct Descriptor {
  std::size_t i = 0;

  bool operator==(Descriptor other) const { return i == other.i; }
  bool operator!=(Descriptor other) const { return i != other.i; }
  bool operator<(Descriptor other) const { return i < other.i; }
  friend std::size_t hash_value(Descriptor d) { return d.i; }
};
typedef Descriptor<0> Vertex;
typedef Descriptor<1> Halfedge;
typedef Descriptor<2> Edge;
typedef Descriptor<3> Face;

/// The numbers from 0 on as descriptors; the end is known without going there.
template <class D>
class Iterator : public boost::iterator_facade<Iterator<D>, D, std::random_access_iterator_tag, D> {
public:
  explicit Iterator(std::size_t i = 0) : i_(i) {}

private:
  friend class boost::iterator_core_access;
  D dereference() const { return {i_}; }
  bool equal(Iterator other) const { return i_ == other.i_; }
  void increment() { ++i_; }
  void decrement() { --i_; }
  void advance(std::ptrdiff_t n) { i_ += static_cast<std::size_t>(n); }
  std::ptrdiff_t distance_to(Iterator other) const { return static_cast<std::ptrdiff_t>(other.i_ - i_); }

  std::size_t i_;
};

template <class D>
CGAL::Iterator_range<Iterator<D>> range(std::size_t n)
{
  return {Iterator<D>(0), Iterator<D>(n)};
}

CGAL::Iterator_range<Iterator<Vertex>> vertices(const Vast_mesh& m) { return range<Vertex>(m.vertices); }
CGAL::Iterator_range<Iterator<Halfedge>> halfedges(const Vast_mesh& m) { return range<Halfedge>(3 * m.faces); }
CGAL::Iterator_range<Iterator<Face>> faces(const Vast_mesh& m) { return range<Face>(m.faces); }
Halfedge halfedge(Vertex, const Vast_mesh&) { walk(); }
Halfedge halfedge(Face, const Vast_mesh&) { walk(); }
Halfedge next(Halfedge, const Vast_mesh&) { walk(); }
Halfedge opposite(Halfedge, const Vast_mesh&) { walk(); }
Vertex source(Halfedge, const Vast_mesh&) { walk(); }
Vertex target(Halfedge, const Vast_mesh&) { walk(); }
Face face(Halfedge, const Vast_mesh&) { walk(); }
std::size_t degree(Face, const Vast_mesh&) { walk(); }

struct No_points {
  typedef Vertex key_type;
  typedef Point_3 value_type;
  typedef Point_3 reference;
  typedef boost::read_write_property_map_tag category;

  friend Point_3 get(No_points, Vertex) { walk(); }
  friend void put(No_points, Vertex, const Point_3&) { walk(); }
};

No_points get(boost::vertex_point_t, const Vast_mesh&) { return {}; }

} // namespace

namespace boost {

template <>
struct property_map<Vast_mesh, vertex_point_t> {
  typedef No_points type;
  typedef No_points const_type;
};

template <>
struct graph_traits<Vast_mesh> {
  typedef Vertex vertex_descriptor;
  typedef Halfedge halfedge_descriptor;
  typedef Edge edge_descriptor;
  typedef Face face_descriptor;
  typedef Iterator<Vertex> vertex_iterator;
  typedef Iterator<Halfedge> halfedge_iterator;
  typedef Iterator<Face> face_iterator;
  typedef std::size_t vertices_size_type;
  typedef std::size_t halfedges_size_type;
  typedef std::size_t edges_size_type;
  typedef std::size_t faces_size_type;
  typedef std::size_t degree_size_type;
  typedef undirected_tag directed_category;
  typedef disallow_parallel_edge_tag edge_parallel_category;
  struct traversal_category : bidirectional_graph_tag, vertex_list_graph_tag, edge_list_graph_tag {};

  static vertex_descriptor null_vertex() { return {std::numeric_limits<std::size_t>::max()}; }
  static halfedge_descriptor null_halfedge() { return {std::numeric_limits<std::size_t>::max()}; }
  static face_descriptor null_face() { return {std::numeric_limits<std::size_t>::max()}; }
};

} // namespace boost

namespace CGAL {

template <>
struct graph_has_property<Vast_mesh, boost::vertex_point_t> : CGAL::Tag_true {};

} // namespace CGAL

namespace SP = CGAL::Spherical_parameterization;

TEMPLATE_TEST_CASE("limits: meshes that 32-bit indices cannot number are refused at once", "[limits]", SP::Balanced,
                   SP::Saddle_point, SP::Isometric, SP::Automatic)
{
  constexpr std::size_t limit = std::numeric_limits<int>::max();
  const Vast_mesh mesh = GENERATE(Vast_mesh{4, limit / 3 + 1}, Vast_mesh{limit / 6, limit / 3 + 1},
                                  Vast_mesh{limit + 1, 4}, Vast_mesh{std::size_t(1) << 40, std::size_t(1) << 41});
  const SP::Result result = SP::parameterize(CGAL::Sequential_tag(), mesh, TestType(), No_points());
  CAPTURE(result);
  CHECK(result.error == SP::Error_code::TOO_LARGE);
  CHECK(result.detail.find("715,827,882") != std::string::npos);
}
