// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_READ_EDGE_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_READ_EDGE_WEIGHTS_H

#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/base/text.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Vertex_numbering.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Reads the weights of a mesh's edges into the rows of its graph.
template <class TriangleMesh>
class Edge_weight_reader {
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

public:
  /// `vertex`, `position`, `point`: by number of vertex, as in Source_mesh
  Edge_weight_reader(const TriangleMesh& mesh, const std::vector<vertex_descriptor>& vertex,
                     const Host_array<int>& position, const Host_array<vec3>& point)
    : mesh_(mesh), vertex_(vertex), position_(position), point_(point), numbering_(mesh), index_(position.size())
  {
    for(int i = 0; i < static_cast<int>(position.size()); ++i)
      index_[position[i]] = i;
  }

  /// Reads the weight of every edge once, and writes it into both rows of `graph`. Returns what a weight of 1 in the
  /// graph is to the caller. Throws Error if a weight is not positive and finite.
  template <class EdgeWeightMap, class Loop>
  double operator()(const Loop& loop, EdgeWeightMap weights, Weighted_graph& graph) const
  {
    const int n = graph.size();
    graph.weight.resize(graph.target.size());
    const auto place = [&](int i, int j) { // of the weight of the edge ij in row i; of the first one, if there are two
      const auto row = graph.target.begin();
      return std::lower_bound(row + graph.offset[i], row + graph.offset[i + 1], j) - row;
    };

    // Every vertex reads the edges to the smaller ones, then those copy them.
    std::atomic<bool> are_good(true);
    for_each_part(loop, n, [&](int begin, int end) {
      for(int i = begin; i < end; ++i) {
        std::fill(graph.weight.begin() + graph.offset[i], graph.weight.begin() + graph.offset[i + 1], 0);
        for(halfedge_descriptor h : halfedges_around_target(halfedge(vertex_[i], mesh_), mesh_)) {
          const int j = index_[numbering_(source(h, mesh_))];
          if(j > i)
            continue;
          const double w = CGAL::to_double(get(weights, edge(h, mesh_)));
          auto k = place(i, j);
          while(graph.weight[k] != 0 && k + 1 < graph.offset[i + 1] && graph.target[k + 1] == j)
            ++k;
          graph.weight[k] = w;
          if(!is_good_weight(w))
            are_good = false;
        }
      }
    });
    if(!are_good)
      explain_bad_weight(weights);
    for_each_part(loop, n, [&](int begin, int end) {
      for(int i = begin; i < end; ++i)
        for(int k = graph.offset[i]; k < graph.offset[i + 1]; ++k) {
          const int j = graph.target[k];
          if(j > i)
            graph.weight[k] = graph.weight[place(j, i) + (k - place(i, j))];
        }
    });
    return choose_weight_unit(loop, graph);
  }

private:
  static bool is_good_weight(double w) { return w > 0 && std::isfinite(w); }

  /// Weights whose products would overflow or underflow are taken in another unit, which maps do not depend on.
  template <class Loop>
  static double choose_weight_unit(const Loop& loop, Weighted_graph& graph)
  {
    constexpr double harmless = 1e100;
    Host_array<double>& weight = graph.weight;
    const double largest = weight.empty() ? 1 : *std::max_element(weight.begin(), weight.end());
    if(largest < harmless && largest > 1 / harmless)
      return 1;
    const int exponent = std::ilogb(largest);
    for_each_part(loop, graph.size(), [&](int begin, int end) {
      for(int k = graph.offset[begin]; k < graph.offset[end]; ++k)
        weight[k] = (std::max)((std::numeric_limits<double>::min)(), std::ldexp(weight[k], -exponent));
    });
    return std::ldexp(1., exponent);
  }

  /// Throws the Error for the first edge whose weight is not good.
  template <class EdgeWeightMap>
  void explain_bad_weight(EdgeWeightMap weights) const
  {
    for(int i = 0; i < static_cast<int>(vertex_.size()); ++i)
      for(halfedge_descriptor h : halfedges_around_target(halfedge(vertex_[i], mesh_), mesh_)) {
        const int j = index_[numbering_(source(h, mesh_))];
        const double w = j > i ? 1 : CGAL::to_double(get(weights, edge(h, mesh_)));
        if(!is_good_weight(w))
          blame_weight(h, w, i, j);
      }
  }

  [[noreturn]] void blame_weight(halfedge_descriptor h, double w, int i, int j) const
  {
    const std::string edge_name =
      "edge " + std::to_string(position_[j]) + "-" + std::to_string(position_[i]) + " has weight " + to_string(w);
    for(halfedge_descriptor side : {h, opposite(h, mesh_)})
      if(is_degenerate(side, i, j))
        throw Input_error(Error_code::DEGENERATE_FACE, edge_name +
                                                         " because a face at it has no area; use barycentric or "
                                                         "conformal weights, or repair the mesh");
    throw Input_error(Error_code::BAD_WEIGHT, edge_name + "; weights must be positive and finite");
  }

  /// Whether the face on the left of `side`, an edge between i and j, has no area.
  bool is_degenerate(halfedge_descriptor side, int i, int j) const
  {
    const vertex_descriptor apex = target(next(side, mesh_), mesh_);
    const auto k = std::find(vertex_.begin(), vertex_.end(), apex) - vertex_.begin();
    const vec3 n = outer(sub(point_[j], point_[i]), sub(point_[k], point_[i]));
    return inner(n, n) == 0;
  }

  const TriangleMesh& mesh_;
  const std::vector<vertex_descriptor>& vertex_;
  const Host_array<int>& position_;
  const Host_array<vec3>& point_;
  Vertex_numbering<TriangleMesh> numbering_;
  Host_array<int> index_; ///< number of a vertex by its position in vertices(mesh)
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_READ_EDGE_WEIGHTS_H
