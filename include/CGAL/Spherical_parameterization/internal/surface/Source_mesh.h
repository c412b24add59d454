// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SOURCE_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SOURCE_MESH_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/algebra/Bounding_box.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/surface/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/surface/breadth_first.h>
#include <CGAL/Spherical_parameterization/internal/surface/check_face_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/conformal_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/corner_table_of.h>
#include <CGAL/Spherical_parameterization/internal/surface/fans.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Moves the bounding box to the origin and scales it to size 1. Lengths and areas are only ever compared with each
/// other: this keeps their squares and products far from overflow and underflow.
inline void scale_to_unit_box(Host_array<vec3>& point)
{
  const Bounding_box box(point);
  const vec3 low = box.low;
  const double divisor = box.half_size();
  for(vec3& p : point)
    p = {(p.x / 2 - low.x / 2) / divisor, (p.y / 2 - low.y / 2) / divisor, (p.z / 2 - low.z / 2) / divisor};
}

/// Weights whose products would overflow or underflow are taken in another unit, which maps do not depend on. Returns
/// what a weight of 1 in the graph is to the caller.
inline double choose_weight_unit(const Host_loop& loop, Host_array<double>& weight)
{
  constexpr double harmless = 1e100;
  const double largest = weight.empty() ? 1 : *std::max_element(weight.begin(), weight.end());
  if(largest < harmless && largest > 1 / harmless)
    return 1;
  const int exponent = std::ilogb(largest);
  for_each_index(loop, static_cast<int>(weight.size()), [&](int k) {
    weight[k] = (std::max)((std::numeric_limits<double>::min)(), std::ldexp(weight[k], -exponent));
  });
  return std::ldexp(1., exponent);
}

/// Whether the mesh is given by its faces as sets of vertices: no edge ends where it begins, no two have the same ends.
/// \param graph  its edges, in ascending order
inline bool is_simplicial(const Host_loop& loop, const Weighted_graph& graph)
{
  return first_index(loop, graph.size(), [&](int i) {
           const auto begin = graph.target.begin() + graph.offset[i], end = graph.target.begin() + graph.offset[i + 1];
           return std::find(begin, end, i) != end || std::adjacent_find(begin, end) != end;
         }) == graph.size();
}

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
    std::make_shared<Weighted_graph>();         ///< neighbours in ascending order; weights are left to set_weights()
  double weight_unit = 1;                       ///< what a weight of 1 in the graph is to the caller
  std::optional<Spring_lengths> spring_lengths; ///< if the graph is not of edges of the mesh

  /// Throws Error.
  template <class VertexPointMap>
  Source_mesh(const TriangleMesh& mesh, VertexPointMap points, const Host_loop& loop = Host_loop())
  {
    check_size(mesh);
    const auto numbering = numbering_of<vertex_descriptor>(mesh, vertices(mesh));
    const std::vector<face_descriptor> face_descriptors(faces(mesh).begin(), faces(mesh).end());
    const std::vector<vertex_descriptor> vertex_descriptors(vertices(mesh).begin(), vertices(mesh).end());
    if constexpr(Has_breadth_first_order<TriangleMesh>::value)
      position = mesh.breadth_first_order();
    else
      position = checked_breadth_first_order(mesh, numbering, vertex_descriptors, face_descriptors, loop);
    const int n = static_cast<int>(position.size());
    vertex.resize(position.size());
    for_each_index(loop, n, [&](int i) { vertex[i] = vertex_descriptors[position[i]]; });
    read_points(points, loop);
    scale_to_unit_box(point);
    face.resize(face_descriptors.size());
    const Host_array<int> index = inverse_permutation(loop, position);
    const auto number = [&](vertex_descriptor v) { return index[numbering(v)]; };
    for_each_index(loop, static_cast<int>(face.size()),
                   [&](int f) { face[f] = corners_of_face(mesh, number, face_descriptors[f]); });
    read_edges_and_areas(loop);
  }

  /// Reads the weight of every edge once, and writes it into both rows of the graph. Throws Error if a weight is not
  /// positive and finite.
  template <class EdgeWeightMap>
  void set_weights(const TriangleMesh& mesh, EdgeWeightMap weights, const Host_loop& loop)
  {
    const int n = graph->size();
    const auto numbering = numbering_of<vertex_descriptor>(mesh, vertices(mesh));
    const Host_array<int> index = inverse_permutation(loop, position);
    const Host_array<int>&offset = graph->offset, &target = graph->target;
    Host_array<double>& weight = graph->weight;
    weight.resize(target.size());
    const auto place = [&](int i, int j) { // of the weight of the edge ij in row i; of the first one, if there are two
      return std::lower_bound(target.begin() + offset[i], target.begin() + offset[i + 1], j) - target.begin();
    };
    // f(h, w, j) for the edges from vertex i to smaller ones j, with their weights w
    const auto for_each_weight = [&](int i, auto f) {
      for(halfedge_descriptor h : halfedges_around_target(halfedge(vertex[i], mesh), mesh)) {
        const int j = index[numbering(source(h, mesh))];
        if(j <= i)
          f(h, CGAL::to_double(get(weights, edge(h, mesh))), j);
      }
    };
    const auto is_good = [](double w) { return w > 0 && std::isfinite(w); };

    // Every vertex reads the edges to the smaller ones, then those copy them.
    std::atomic<bool> are_good(true);
    for_each_index(loop, n, [&](int i) {
      std::fill(weight.begin() + offset[i], weight.begin() + offset[i + 1], 0);
      for_each_weight(i, [&](halfedge_descriptor, double w, int j) {
        auto k = place(i, j);
        while(weight[k] != 0 && k + 1 < offset[i + 1] && target[k + 1] == j)
          ++k;
        weight[k] = w;
        if(!is_good(w))
          are_good = false;
      });
    });
    for(int i = 0; i < n && !are_good; ++i)
      for_each_weight(i, [&](halfedge_descriptor h, double w, int j) {
        if(!is_good(w))
          blame_weight(mesh, h, w, i, j);
      });
    for_each_index(loop, n, [&](int i) {
      for(int k = offset[i]; k < offset[i + 1]; ++k)
        if(target[k] > i)
          weight[k] = weight[place(target[k], i) + (k - place(i, target[k]))];
    });
    weight_unit = choose_weight_unit(loop, weight);
  }

  /// Replaces the edges of the mesh by those of its intrinsic Delaunay triangulation, with cotangent weights.
  void set_conformal_weights(const TriangleMesh& mesh, const Host_loop& loop)
  {
    *graph = Weighted_graph(); // its memory is needed
    *graph = conformal_graph(loop, corner_table_of(mesh, face, loop), point, spring_lengths.emplace());
  }

private:
  template <class VertexPointMap>
  void read_points(VertexPointMap points, const Host_loop& loop)
  {
    const int n = static_cast<int>(vertex.size());
    point.resize(n);
    const int bad =
      first_index(loop, n, [&](int i) { return !is_finite(point[i] = coordinates(get(points, vertex[i]))); });
    if(bad < n)
      throw Input_error(Error_code::NON_FINITE_COORDINATE, "vertex " + std::to_string(position[bad]));
  }

  /// The rows of the graph, and every vertex's share of the areas.
  void read_edges_and_areas(const Host_loop& loop)
  {
    const int n = static_cast<int>(point.size()), m = static_cast<int>(face.size());
    Host_array<double> twice_area(m);
    for_each_index(loop, m, [&](int f) {
      const vec3 normal_vector = normal(point, face[f]);
      twice_area[f] = std::sqrt(inner(normal_vector, normal_vector));
    });
    area.resize(n);
    graph->offset.resize(n + 1);
    graph->offset[n] = 3 * m;
    graph->target.resize(3 * face.size());
    for_each_fan(loop, face, n, [&](const Fan& fan) {
      const auto row = graph->target.begin() + fan.first;
      auto end = row;
      double sum = 0;
      for(int c : fan) {
        sum += twice_area[c / 3] / 6;
        *end++ = face[c / 3][(c + 1) % 3];
      }
      std::sort(row, end);
      area[fan.vertex] = sum;
      graph->offset[fan.vertex] = fan.first;
    });
  }

  /// Throws the Error for the weight w of the edge h from vertex j to vertex i.
  [[noreturn]] void blame_weight(const TriangleMesh& mesh, halfedge_descriptor h, double w, int i, int j) const
  {
    const auto is_degenerate = [&](halfedge_descriptor side) { // the face on its left
      const auto apex = std::find(vertex.begin(), vertex.end(), target(next(side, mesh), mesh)) - vertex.begin();
      const vec3 n = normal(point, {i, j, static_cast<int>(apex)});
      return inner(n, n) == 0;
    };
    const std::string edge_name =
      "edge " + std::to_string(position[j]) + "-" + std::to_string(position[i]) + " has weight " + to_string(w);
    if(is_degenerate(h) || is_degenerate(opposite(h, mesh)))
      throw Input_error(Error_code::DEGENERATE_FACE, edge_name + " because a face at it has no area; use conformal or "
                                                                 "barycentric weights, or repair the mesh");
    throw Input_error(Error_code::BAD_WEIGHT, edge_name + "; weights must be positive and finite");
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SOURCE_MESH_H
