// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_MESH_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/base/text.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/mesh/point_coordinates.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
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
  typedef typename Graph_traits::face_descriptor face_descriptor;

public:
  std::vector<vertex_descriptor> vertex; ///< descriptor of vertex i, in breadth-first order
  Host_array<int> position;              ///< position of vertex i in vertices(mesh), for messages
  Host_array<vec3> point;
  Host_array<std::array<int, 3>> face; ///< in the order of faces(mesh)
  Host_array<double> area;             ///< every vertex's third of the areas of its faces
  std::shared_ptr<Weighted_graph> graph =
    std::make_shared<Weighted_graph>(); ///< neighbours in ascending order; weights are left to set_weights()
  double weight_unit = 1;               ///< what a weight of 1 in the graph is to the caller

  /// Throws Error.
  template <class VertexPointMap, class Loop = Sequential_loop>
  Source_mesh(const TriangleMesh& mesh, VertexPointMap points, const Loop& loop = Loop())
  {
    check_size(mesh);
    const Vertex_numbering<TriangleMesh> numbering(mesh);
    const std::vector<face_descriptor> face_descriptors(faces(mesh).begin(), faces(mesh).end());
    const std::vector<vertex_descriptor> vertex_descriptors(vertices(mesh).begin(), vertices(mesh).end());
    Neighbours neighbours;
    if(!are_triangles(mesh, face_descriptors, loop) ||
       !read_neighbours(mesh, numbering, vertex_descriptors, face_descriptors.size(), loop, neighbours))
      explain_what_is_wrong(mesh, numbering);
    const Host_array<int> index = number_breadth_first(neighbours);
    check_topology(face_descriptors.size());
    vertex.reserve(position.size());
    for(int p : position)
      vertex.push_back(vertex_descriptors[p]);
    read_points(points, loop);
    face.resize(face_descriptors.size());
    for_each_part(loop, static_cast<int>(face.size()), [&](int begin, int end) {
      for(int f = begin; f < end; ++f) {
        const halfedge_descriptor h = halfedge(face_descriptors[f], mesh);
        face[f] = {index[numbering(source(h, mesh))], index[numbering(target(h, mesh))],
                   index[numbering(target(next(h, mesh), mesh))]};
      }
    });
    measure_areas(loop);
    renumber(neighbours, index, loop);
  }

  /// Reads the weight of every edge once, and writes it into both rows. Throws Error if it is not positive and
  /// finite.
  template <class EdgeWeightMap, class Loop = Sequential_loop>
  void set_weights(const TriangleMesh& mesh, EdgeWeightMap weights, const Loop& loop = Loop())
  {
    const int n = static_cast<int>(vertex.size());
    graph->weight.resize(graph->target.size());
    const Vertex_numbering<TriangleMesh> numbering(mesh);
    Host_array<int> index(n);
    for(int i = 0; i < n; ++i)
      index[position[i]] = i;
    const auto place = [&](int i, int j) { // of the weight of the edge ij in row i; of the first one, if there are two
      const auto row = graph->target.begin();
      return std::lower_bound(row + graph->offset[i], row + graph->offset[i + 1], j) - row;
    };

    // Every vertex reads the edges to the smaller ones, then those copy them.
    std::atomic<bool> are_good(true);
    for_each_part(loop, n, [&](int begin, int end) {
      for(int i = begin; i < end; ++i) {
        std::fill(graph->weight.begin() + graph->offset[i], graph->weight.begin() + graph->offset[i + 1], 0);
        for(halfedge_descriptor h : halfedges_around_target(halfedge(vertex[i], mesh), mesh)) {
          const int j = index[numbering(source(h, mesh))];
          if(j > i)
            continue;
          const double w = CGAL::to_double(get(weights, edge(h, mesh)));
          auto k = place(i, j);
          while(graph->weight[k] != 0 && k + 1 < graph->offset[i + 1] && graph->target[k + 1] == j)
            ++k;
          graph->weight[k] = w;
          if(!is_good_weight(w))
            are_good = false;
        }
      }
    });
    if(!are_good)
      explain_bad_weight(mesh, numbering, index, weights);
    for_each_part(loop, n, [&](int begin, int end) {
      for(int i = begin; i < end; ++i)
        for(int k = graph->offset[i]; k < graph->offset[i + 1]; ++k) {
          const int j = graph->target[k];
          if(j > i)
            graph->weight[k] = graph->weight[place(j, i) + (k - place(i, j))];
        }
    });
    choose_weight_unit(loop);
  }

private:
  /// The neighbours of every vertex in the order of vertices(mesh), in compressed rows.
  struct Neighbours {
    Host_array<int> offset, target;
  };

  /// All numbers of vertices and halfedges are of type int. Looks at no element, and allocates nothing.
  static void check_size(const TriangleMesh& mesh)
  {
    constexpr std::size_t limit = static_cast<std::size_t>((std::numeric_limits<int>::max)());
    const auto size = [](const auto& range) {
      return static_cast<std::size_t>(std::distance(range.begin(), range.end()));
    };
    const std::size_t vertex_count = size(vertices(mesh)), face_count = size(faces(mesh));
    if(vertex_count >= limit || face_count > limit / 3)
      throw Error(Error_code::TOO_LARGE, std::to_string(vertex_count) + " vertices and " + std::to_string(face_count) +
                                           " faces; at most 715,827,882 faces are supported");
  }

  template <class Loop>
  static bool are_triangles(const TriangleMesh& mesh, const std::vector<face_descriptor>& descriptors, const Loop& loop)
  {
    if(descriptors.empty())
      return false;
    const int n = static_cast<int>(descriptors.size());
    return first_index(loop, n, [&](int f) { return !is_triangle(halfedge(descriptors[f], mesh), mesh); }) == n;
  }

  /// Walks round every vertex. Returns whether that meets each of its faces, and no border: whether the triangles form
  /// a closed surface.
  template <class Loop>
  static bool read_neighbours(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering,
                              const std::vector<vertex_descriptor>& descriptors, std::size_t number_of_faces,
                              const Loop& loop, Neighbours& neighbours)
  {
    // Faces tell how long the rows are, if all is well.
    const int n = static_cast<int>(descriptors.size());
    Host_array<int>& offset = neighbours.offset;
    offset.assign(n + 1, 0);
    for(halfedge_descriptor h : halfedges(mesh)) {
      if(is_border(h, mesh))
        return false;
      ++offset[numbering(target(h, mesh)) + 1];
    }
    for(int i = 0; i < n; ++i)
      offset[i + 1] += offset[i];
    if(offset[n] != static_cast<int>(3 * number_of_faces))
      return false;
    neighbours.target.resize(offset[n]);
    return first_index(loop, n, [&](int i) {
             int at = offset[i];
             if(at == offset[i + 1])
               return true;
             for(halfedge_descriptor h : halfedges_around_target(halfedge(descriptors[i], mesh), mesh)) {
               if(at == offset[i + 1])
                 return true;
               neighbours.target[at++] = numbering(source(h, mesh));
             }
             return at != offset[i + 1];
           }) == n;
  }

  /// Throws the Error that says what and where; returns if there is nothing to say.
  void explain_what_is_wrong(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering) const
  {
    std::size_t face_count = 0;
    for(auto f : faces(mesh)) {
      if(!is_triangle(halfedge(f, mesh), mesh))
        throw Error(Error_code::NOT_TRIANGULAR, "face " + std::to_string(face_count) + " has " +
                                                  std::to_string(degree(f, mesh)) +
                                                  " corners; triangulate the mesh first");
      ++face_count;
    }
    if(face_count == 0)
      throw Error(Error_code::EMPTY_MESH, "there is nothing to map");

    // Incident faces of each vertex as the faces tell it, to be compared with the walk round the vertex.
    Host_array<int> incident(numbering.size(), 0);
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
      throw Error(Error_code::ISOLATED_VERTEX, counted(isolated, "isolated vertex", "isolated vertices") +
                                                 ", the first one is vertex " + std::to_string(first_isolated) +
                                                 "; remove them");
    if(border > 0)
      throw Error(Error_code::BOUNDARY, counted(border, "boundary edge", "boundary edges") + "; fill the holes first");
    for(vertex_descriptor v : vertices(mesh)) {
      int walked = 0;
      for(halfedge_descriptor h : halfedges_around_target(halfedge(v, mesh), mesh)) {
        (void)h;
        ++walked;
      }
      if(walked != incident[numbering(v)])
        throw Error(Error_code::NON_MANIFOLD, "the faces round vertex " + std::to_string(numbering(v)) +
                                                " form several fans; duplicate the vertex");
    }
  }

  /// Fills `position`; returns the new index by old position.
  Host_array<int> number_breadth_first(const Neighbours& neighbours)
  {
    const int n = static_cast<int>(neighbours.offset.size()) - 1;
    Host_array<int> index(n, -1);
    position.reserve(n);
    const auto visit = [&](int p) {
      if(index[p] < 0) {
        index[p] = static_cast<int>(position.size());
        position.push_back(p);
      }
    };
    std::size_t components = 0;
    for(int seed = 0; seed < n; ++seed) {
      if(index[seed] >= 0)
        continue;
      ++components;
      std::size_t head = position.size();
      visit(seed);
      for(; head < position.size(); ++head)
        for(int k = neighbours.offset[position[head]]; k < neighbours.offset[position[head] + 1]; ++k)
          visit(neighbours.target[k]);
    }
    if(components > 1)
      throw Error(Error_code::SEVERAL_COMPONENTS,
                  counted(components, "component", "components") + "; map them one by one");
    return index;
  }

  void check_topology(std::size_t number_of_faces) const
  {
    // V - E + F = 2 - 2g, and 2E = 3F since all faces are triangles.
    const long long characteristic =
      static_cast<long long>(position.size()) - static_cast<long long>(number_of_faces / 2);
    if(characteristic != 2)
      throw Error(Error_code::WRONG_GENUS, "genus " + std::to_string((2 - characteristic) / 2) +
                                             "; only surfaces without handles map to the sphere");
  }

  template <class VertexPointMap, class Loop>
  void read_points(VertexPointMap points, const Loop& loop)
  {
    const int n = static_cast<int>(vertex.size());
    point.resize(n);
    const int bad = first_index(loop, n, [&](int i) {
      const vec3 p = point[i] = coordinates(get(points, vertex[i]));
      return !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z);
    });
    if(bad < n)
      throw Error(Error_code::NON_FINITE_COORDINATE, "vertex " + std::to_string(position[bad]));
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

  template <class Loop>
  void measure_areas(const Loop& loop)
  {
    Host_array<double> twice_area(face.size());
    for_each_part(loop, static_cast<int>(face.size()), [&](int begin, int end) {
      for(int f = begin; f < end; ++f) {
        const auto [a, b, c] = face[f];
        const vec3 n = outer(sub(point[b], point[a]), sub(point[c], point[a]));
        twice_area[f] = std::sqrt(inner(n, n));
      }
    });
    area.assign(vertex.size(), 0);
    for(std::size_t f = 0; f < face.size(); ++f)
      for(int i : face[f])
        area[i] += twice_area[f] / 6;
  }

  /// Fills the rows of `graph`, in ascending order.
  template <class Loop>
  void renumber(const Neighbours& neighbours, const Host_array<int>& index, const Loop& loop)
  {
    const int n = static_cast<int>(vertex.size());
    graph->offset.resize(n + 1);
    for(int i = 0; i < n; ++i)
      graph->offset[i + 1] = graph->offset[i] + neighbours.offset[position[i] + 1] - neighbours.offset[position[i]];
    graph->target.resize(neighbours.target.size());
    for_each_part(loop, n, [&](int begin, int end) {
      for(int i = begin; i < end; ++i) {
        const auto row = graph->target.begin() + graph->offset[i];
        const auto from = neighbours.target.begin() + neighbours.offset[position[i]];
        const auto last = std::transform(from, neighbours.target.begin() + neighbours.offset[position[i] + 1], row,
                                         [&](int p) { return index[p]; });
        std::sort(row, last);
      }
    });
  }

  static bool is_good_weight(double w) { return w > 0 && std::isfinite(w); }

  /// Weights whose products would overflow or underflow are taken in another unit, which maps do not depend on.
  template <class Loop>
  void choose_weight_unit(const Loop& loop)
  {
    constexpr double harmless = 1e100;
    Host_array<double>& weight = graph->weight;
    const double largest = weight.empty() ? 1 : *std::max_element(weight.begin(), weight.end());
    if(largest < harmless && largest > 1 / harmless)
      return;
    const int exponent = std::ilogb(largest);
    weight_unit = std::ldexp(1., exponent);
    for_each_part(loop, static_cast<int>(vertex.size()), [&](int begin, int end) {
      for(int k = graph->offset[begin]; k < graph->offset[end]; ++k)
        weight[k] = (std::max)((std::numeric_limits<double>::min)(), std::ldexp(weight[k], -exponent));
    });
  }

  /// Throws the Error for the first edge whose weight is not good.
  template <class EdgeWeightMap>
  void explain_bad_weight(const TriangleMesh& mesh, const Vertex_numbering<TriangleMesh>& numbering,
                          const Host_array<int>& index, EdgeWeightMap weights) const
  {
    for(int i = 0; i < static_cast<int>(vertex.size()); ++i)
      for(halfedge_descriptor h : halfedges_around_target(halfedge(vertex[i], mesh), mesh)) {
        const int j = index[numbering(source(h, mesh))];
        const double w = j > i ? 1 : CGAL::to_double(get(weights, edge(h, mesh)));
        if(!is_good_weight(w))
          blame_weight(mesh, h, w, i, j);
      }
  }

  [[noreturn]] void blame_weight(const TriangleMesh& mesh, halfedge_descriptor h, double w, int i, int j) const
  {
    const std::string edge_name =
      "edge " + std::to_string(position[j]) + "-" + std::to_string(position[i]) + " has weight " + to_string(w);
    for(halfedge_descriptor side : {h, opposite(h, mesh)})
      if(is_degenerate(mesh, side, i, j))
        throw Error(Error_code::DEGENERATE_FACE, edge_name + " because a face at it has no area; use barycentric or "
                                                             "conformal weights, or repair the mesh");
    throw Error(Error_code::BAD_WEIGHT, edge_name + "; weights must be positive and finite");
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_MESH_H
