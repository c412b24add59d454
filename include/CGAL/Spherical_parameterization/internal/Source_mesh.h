// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SOURCE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SOURCE_MESH_H

#include <CGAL/Spherical_parameterization/internal/Failure.h>
#include <CGAL/Spherical_parameterization/internal/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/point_coordinates.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// A face graph as arrays, checked to be a closed, connected triangle mesh of genus 0 with finite points.
///
/// Vertices are renumbered in breadth-first order: neighbours then lie close together in memory, which more than halves
/// the time of every sweep on large meshes, whatever the order of the input.
template <class TriangleMesh>
class Source_mesh {
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

public:
  std::vector<vertex_descriptor> vertex; ///< descriptor of vertex i, in breadth-first order
  std::vector<int> position;             ///< position of vertex i in vertices(mesh), for messages
  std::vector<vec3> point;
  std::vector<std::array<int, 3>> face; ///< in the order of faces(mesh)
  std::vector<double> area;             ///< every vertex's third of the areas of its faces
  std::array<int, 3> largest_face;      ///< by area
  std::shared_ptr<Weighted_graph> graph =
    std::make_shared<Weighted_graph>(); ///< neighbours in ascending order; weights are left to set_weights()

  /// Throws Failure.
  template <class VertexPointMap>
  Source_mesh(const TriangleMesh& mesh, VertexPointMap points)
  {
    const Vertex_numbering<TriangleMesh> numbering(mesh);
    check_connectivity(mesh, numbering);
    const std::vector<int> index = number_breadth_first(mesh, numbering);
    read_points(points);
    face.reserve(num_faces(mesh));
    for(auto f : faces(mesh)) {
      const halfedge_descriptor h = halfedge(f, mesh);
      face.push_back({index[numbering(source(h, mesh))], index[numbering(target(h, mesh))],
                      index[numbering(target(next(h, mesh), mesh))]});
    }
    measure_areas();
    // Rows of ascending neighbours.
    const int n = static_cast<int>(vertex.size());
    graph->offset.assign(1, 0);
    graph->offset.reserve(n + 1);
    graph->target.reserve(3 * face.size());
    for(int i = 0; i < n; ++i) {
      for(halfedge_descriptor h : halfedges_around_target(halfedge(vertex[i], mesh), mesh))
        graph->target.push_back(index[numbering(source(h, mesh))]);
      std::sort(graph->target.begin() + graph->offset[i], graph->target.end());
      graph->offset.push_back(static_cast<int>(graph->target.size()));
    }
  }

  /// Reads the weight of every edge once, and writes it into both rows. Throws Failure if it is not positive and
  /// finite.
  template <class EdgeWeightMap>
  void set_weights(const TriangleMesh& mesh, EdgeWeightMap weights)
  {
    const int n = static_cast<int>(vertex.size());
    graph->weight.resize(graph->target.size());
    // Row j meets its larger neighbours i in ascending order: a cursor per row finds the mirror image of (i, j).
    std::vector<int> cursor(n);
    for(int i = 0; i < n; ++i)
      cursor[i] = static_cast<int>(
        std::upper_bound(graph->target.begin() + graph->offset[i], graph->target.begin() + graph->offset[i + 1], i) -
        graph->target.begin());
    const Vertex_numbering<TriangleMesh> numbering(mesh);
    std::vector<int> index(n);
    for(int i = 0; i < n; ++i)
      index[position[i]] = i;
    std::vector<std::pair<int, double>> row;
    for(int i = 0; i < n; ++i) {
      row.clear();
      for(halfedge_descriptor h : halfedges_around_target(halfedge(vertex[i], mesh), mesh)) {
        const int j = index[numbering(source(h, mesh))];
        if(j < i) {
          const double w = CGAL::to_double(get(weights, edge(h, mesh)));
          check_weight(mesh, h, w, i, j);
          row.emplace_back(j, w);
        }
      }
      std::sort(row.begin(), row.end());
      for(std::size_t k = 0; k < row.size(); ++k) {
        graph->weight[graph->offset[i] + k] = row[k].second;
        graph->weight[cursor[row[k].first]++] = row[k].second;
      }
    }
  }

private:
  void check_connectivity(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering) const
  {
    std::size_t face_count = 0;
    for(auto f : faces(mesh)) {
      if(!is_triangle(halfedge(f, mesh), mesh))
        throw Failure{Error_code::NOT_TRIANGULAR, "face " + std::to_string(face_count) + " has " +
                                                    std::to_string(degree(f, mesh)) +
                                                    " corners; triangulate the mesh first"};
      ++face_count;
    }
    if(face_count == 0)
      throw Failure{Error_code::EMPTY_MESH, "there is nothing to map"};
    constexpr std::size_t limit = static_cast<std::size_t>((std::numeric_limits<int>::max)());
    if(3 * face_count > limit)
      throw Failure{Error_code::TOO_LARGE, std::to_string(face_count) + " faces; at most 715,827,882 are supported"};

    // Incident faces of each vertex as the faces tell it, to be compared with the walk round the vertex.
    std::vector<int> incident(numbering.size(), 0);
    std::size_t border = 0;
    for(halfedge_descriptor h : halfedges(mesh)) {
      if(is_border(h, mesh))
        ++border;
      ++incident[numbering(target(h, mesh))];
    }
    std::size_t isolated = 0, first_isolated = 0;
    for(std::size_t i = 0; i < incident.size(); ++i)
      if(incident[i] == 0 && isolated++ == 0)
        first_isolated = i;
    if(isolated > 0)
      throw Failure{Error_code::ISOLATED_VERTEX, counted(isolated, "isolated vertex", "isolated vertices") +
                                                   ", the first one is vertex " + std::to_string(first_isolated) +
                                                   "; remove them"};
    if(border > 0)
      throw Failure{Error_code::BOUNDARY,
                    counted(border, "boundary edge", "boundary edges") + "; fill the holes first"};
    for(vertex_descriptor v : vertices(mesh)) {
      int walked = 0;
      for(halfedge_descriptor h : halfedges_around_target(halfedge(v, mesh), mesh)) {
        (void)h;
        ++walked;
      }
      if(walked != incident[numbering(v)])
        throw Failure{Error_code::NON_MANIFOLD, "the faces round vertex " + std::to_string(numbering(v)) +
                                                  " form several fans; duplicate the vertex"};
    }
  }

  /// Fills `vertex` and `position`; returns the new index by old position. Counts components and handles on the way.
  std::vector<int> number_breadth_first(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering)
  {
    const std::size_t n = numbering.size();
    std::vector<int> index(n, -1);
    vertex.reserve(n);
    position.reserve(n);
    const auto visit = [&](vertex_descriptor v) {
      const int p = numbering(v);
      if(index[p] < 0) {
        index[p] = static_cast<int>(vertex.size());
        vertex.push_back(v);
        position.push_back(p);
      }
    };
    std::size_t components = 0;
    for(vertex_descriptor seed : vertices(mesh)) {
      if(index[numbering(seed)] >= 0)
        continue;
      ++components;
      std::size_t head = vertex.size();
      visit(seed);
      for(; head < vertex.size(); ++head) {
        const vertex_descriptor v = vertex[head];
        for(halfedge_descriptor h : halfedges_around_target(halfedge(v, mesh), mesh))
          visit(source(h, mesh));
      }
    }
    if(components > 1)
      throw Failure{Error_code::SEVERAL_COMPONENTS,
                    counted(components, "component", "components") + "; map them one by one"};
    std::size_t face_count = 0;
    for(auto f : faces(mesh)) {
      (void)f;
      ++face_count;
    }
    // V - E + F = 2 - 2g, and 2E = 3F since all faces are triangles.
    const long long characteristic = static_cast<long long>(n) - static_cast<long long>(face_count / 2);
    if(characteristic != 2)
      throw Failure{Error_code::WRONG_GENUS, "genus " + std::to_string((2 - characteristic) / 2) +
                                               "; only surfaces without handles map to the sphere"};
    return index;
  }

  template <class VertexPointMap>
  void read_points(VertexPointMap points)
  {
    point.reserve(vertex.size());
    for(std::size_t i = 0; i < vertex.size(); ++i) {
      const vec3 p = coordinates(get(points, vertex[i]));
      if(!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
        throw Failure{Error_code::NON_FINITE_COORDINATE, "vertex " + std::to_string(position[i])};
      point.push_back(p);
    }
    // Lengths and areas are only ever compared with each other. Moving the bounding box to the origin and scaling it to
    // 1 keeps their squares and products far from overflow and underflow.
    vec3 low = point[0], high = point[0];
    for(const vec3& p : point) {
      low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
      high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
    }
    // Halves first: the extent of finite coordinates may overflow.
    const double half = (std::max)({high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2});
    const double divisor = half > 0 ? half : 1;
    for(vec3& p : point)
      p = {(p.x / 2 - low.x / 2) / divisor, (p.y / 2 - low.y / 2) / divisor, (p.z / 2 - low.z / 2) / divisor};
  }

  void measure_areas()
  {
    area.assign(vertex.size(), 0);
    double largest = -1;
    for(const std::array<int, 3>& f : face) {
      const vec3 n = outer(sub(point[f[1]], point[f[0]]), sub(point[f[2]], point[f[0]]));
      const double twice_area = std::sqrt(inner(n, n));
      for(int i : f)
        area[i] += twice_area / 6;
      if(twice_area > largest) {
        largest = twice_area;
        largest_face = f;
      }
    }
  }

  void check_weight(const TriangleMesh& mesh, halfedge_descriptor h, double w, int i, int j) const
  {
    if(w > 0 && std::isfinite(w))
      return;
    const std::string edge_name =
      "edge " + std::to_string(position[j]) + "-" + std::to_string(position[i]) + " has weight " + std::to_string(w);
    for(halfedge_descriptor side : {h, opposite(h, mesh)})
      if(is_degenerate(mesh, side, i, j))
        throw Failure{Error_code::DEGENERATE_FACE, edge_name + " because a face at it has no area; use barycentric or "
                                                               "conformal weights, or repair the mesh"};
    throw Failure{Error_code::BAD_WEIGHT, edge_name + "; weights must be positive and finite"};
  }

  /// Whether the face on the left of `side`, an edge between i and j, has no area.
  bool is_degenerate(const TriangleMesh& mesh, halfedge_descriptor side, int i, int j) const
  {
    const vertex_descriptor apex = target(next(side, mesh), mesh);
    const auto k = std::find(vertex.begin(), vertex.end(), apex) - vertex.begin();
    const vec3 n = outer(sub(point[j], point[i]), sub(point[k], point[i]));
    return inner(n, n) == 0;
  }
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SOURCE_MESH_H
