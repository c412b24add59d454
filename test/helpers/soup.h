// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh as a file holds it, and how to make a FaceGraph of it. Everything that checks the package works on soups,
// so that it shares no code with what it checks.

#ifndef TEST_HELPERS_SOUP_H
#define TEST_HELPERS_SOUP_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <map>
#include <stdexcept>
#include <vector>

namespace test {

/// Of doubles and nothing else: a third of the size of the kernels with exact predicates, for the compiler. Where a
/// test needs an exact sign it asks for exact_orientation().
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
};

/// One position per vertex, in the order of the vertices of the mesh (or of the points of the soup).
using Sphere = std::vector<Point>;

/// The sign of the determinant of (b - a, c - a, d - a), of the doubles as they are: exact.
CGAL::Orientation exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d);
/// The same in the plane.
CGAL::Orientation exact_orientation(const Kernel::Point_2& a, const Kernel::Point_2& b, const Kernel::Point_2& c);

/// A FaceGraph with the points and faces of the soup, in their order. Unused points become isolated vertices.
template <class Graph>
Graph make_graph(const Soup& soup)
{
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using Graph_point =
    typename boost::property_traits<typename boost::property_map<Graph, CGAL::vertex_point_t>::type>::value_type;
  Graph graph;
  auto points = get(CGAL::vertex_point, graph);
  std::vector<vertex_descriptor> vertices;
  for(const Point& p : soup.points) {
    vertices.push_back(add_vertex(graph));
    put(points, vertices.back(), Graph_point(p.x(), p.y(), p.z()));
  }
  for(const auto& face : soup.faces) {
    std::vector<vertex_descriptor> corners;
    for(std::size_t i : face)
      corners.push_back(vertices[i]);
    if(CGAL::Euler::add_face(corners, graph) == boost::graph_traits<Graph>::null_face())
      throw std::logic_error("a face of the soup does not fit the graph");
  }
  return graph;
}

inline Mesh make_mesh(const Soup& soup) { return make_graph<Mesh>(soup); }

/// The soup of a FaceGraph, its vertices numbered as `vertices(graph)` lists them.
template <class Graph>
Soup make_soup(const Graph& graph)
{
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  Soup soup;
  std::map<vertex_descriptor, std::size_t> index;
  auto points = get(CGAL::vertex_point, graph);
  for(vertex_descriptor v : vertices(graph)) {
    const auto& p = get(points, v);
    index[v] = soup.points.size();
    soup.points.emplace_back(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
  }
  for(auto f : faces(graph)) {
    soup.faces.emplace_back();
    for(vertex_descriptor v : CGAL::vertices_around_face(halfedge(f, graph), graph))
      soup.faces.back().push_back(index[v]);
  }
  return soup;
}

} // namespace test

#endif // TEST_HELPERS_SOUP_H
