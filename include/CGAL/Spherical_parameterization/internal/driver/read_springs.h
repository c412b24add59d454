// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_SPRINGS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_SPRINGS_H

#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/conformal_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/neighbours.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/values/Conformal_weights.h>
#include <CGAL/Spherical_parameterization/values/Error.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The springs of a problem.
struct Springs {
  Weighted_graph graph;                  ///< neighbours in ascending order
  double weight_unit = 1;                ///< what a weight of 1 in the graph is to the caller
  std::optional<Spring_lengths> lengths; ///< if they are not the edges of the mesh
};

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

/// Throws the Error for the weight w of the edge h from vertex j to vertex i.
template <class TriangleMesh>
[[noreturn]] void blame_weight(const TriangleMesh& mesh, const Surface& surface, const Vertices<TriangleMesh>& vertex,
                               typename boost::graph_traits<TriangleMesh>::halfedge_descriptor h, double w, int i,
                               int j)
{
  const auto is_flat = [&](auto side) { // the face on its left: no area, or to rounding an angle of 180 degrees there
    const auto apex = std::find(vertex.begin(), vertex.end(), target(next(side, mesh), mesh)) - vertex.begin();
    const auto is_straight = [&](int corner, int other) {
      const auto to = [&](auto v) { return scaled_to_unit_box(sub(surface.point[v], surface.point[corner])); };
      const vec3 a = to(other), b = to(apex), n = outer(a, b);
      const double rounding = inner(a, b) < 0 ? 4 * std::numeric_limits<double>::epsilon() : 0;
      return inner(n, n) <= rounding * inner(a, a) * inner(b, b);
    };
    return is_straight(i, j) || is_straight(j, i);
  };
  const std::string edge_name = "edge " + std::to_string(surface.position[j]) + "-" +
                                std::to_string(surface.position[i]) + " has weight " +
                                (std::isnan(w) ? "NaN" : to_string(w));
  if(is_flat(h) || is_flat(opposite(h, mesh)))
    throw Input_error(Error_code::DEGENERATE_FACE, edge_name +
                                                     " because a face at it has almost no area; use conformal or "
                                                     "barycentric weights, or repair the mesh");
  throw Input_error(Error_code::BAD_WEIGHT, edge_name + "; weights must be positive and finite");
}

/// Reads the weight of every edge once, and writes it into both rows of the graph. Throws Error if a weight is not
/// positive and finite.
/// \param surface  read breadth-first
template <class TriangleMesh, class EdgeWeightMap>
Springs read_springs(const TriangleMesh& mesh, const Surface& surface, const Vertices<TriangleMesh>& vertex,
                     const EdgeWeightMap& weights, const Watched_loop<Host_loop>& loop)
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  Springs springs;
  springs.graph = neighbours(loop.bare(), surface);
  const int n = springs.graph.size();
  const auto numbering = numbering_of<typename Graph_traits::vertex_descriptor>(mesh, vertices(mesh));
  const Host_array<int> index = inverse_permutation(loop.bare(), surface.position);
  const Host_array<int>&offset = springs.graph.offset, &target = springs.graph.target;
  Host_array<double>& weight = springs.graph.weight;
  weight.resize(target.size());
  const auto place = [&](int i, int j) { // of the weight of the edge ij in row i; of the first one, if there are two
    return std::lower_bound(target.begin() + offset[i], target.begin() + offset[i + 1], j) - target.begin();
  };
  // f(h, w, j) for the edges from vertex i to smaller ones j, with their weights w
  const auto for_each_weight = [&](int i, auto f) {
    for(auto h : halfedges_around_target(halfedge(vertex[i], mesh), mesh)) {
      const int j = index[numbering(source(h, mesh))];
      if(j <= i)
        f(h, as_double(get(weights, edge(h, mesh))), j);
    }
  };
  const auto is_good = [](double w) { return w > 0 && std::isfinite(w); };

  // Every vertex reads the edges to the smaller ones, then those copy them.
  std::atomic<bool> are_good(true);
  for_each_index(loop, n, [&](int i) {
    std::fill(weight.begin() + offset[i], weight.begin() + offset[i + 1], 0);
    for_each_weight(i, [&](auto, double w, int j) {
      auto k = place(i, j);
      while(weight[k] != 0 && k + 1 < offset[i + 1] && target[k + 1] == j)
        ++k;
      weight[k] = w;
      if(!is_good(w))
        are_good = false;
    });
  });
  for(int i = 0; i < n && !are_good; ++i)
    for_each_weight(i, [&](auto h, double w, int j) {
      if(!is_good(w))
        blame_weight(mesh, surface, vertex, h, w, i, j);
    });
  for_each_index(loop, n, [&](int i) {
    for(int k = offset[i]; k < offset[i + 1]; ++k)
      if(target[k] > i)
        weight[k] = weight[place(target[k], i) + (k - place(i, target[k]))];
  });
  springs.weight_unit = choose_weight_unit(loop.bare(), weight);
  return springs;
}

/// The edges of the intrinsic Delaunay triangulation of the surface, with cotangent weights.
template <class TriangleMesh>
Springs read_springs(const TriangleMesh& mesh, const Surface& surface, const Vertices<TriangleMesh>&, Conformal_weights,
                     const Watched_loop<Host_loop>& loop)
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  Corner_table table;
  if constexpr(Has_idx<face_descriptor>::value) // faster than to match them; with a hash table of faces it is not
    if(surface.is_simplicial) {
      const std::vector<face_descriptor> all(faces(mesh).begin(), faces(mesh).end());
      table = {surface.face, read_twins(mesh, all, loop.bare())}; // from here on the callback may change the mesh
    }
  if(table.face.empty())
    table = surface.copy_of_corner_table(loop);
  Springs springs;
  springs.graph = conformal_graph(loop, std::move(table), surface.point, springs.lengths.emplace());
  return springs;
}

template <class TriangleMesh, class EdgeWeightMap>
Springs read_springs(const TriangleMesh& mesh, const Surface& surface, const Vertices<TriangleMesh>& vertex,
                     const std::variant<Conformal_weights, EdgeWeightMap>& weights, const Watched_loop<Host_loop>& loop)
{
  return std::visit([&](const auto& chosen) { return read_springs(mesh, surface, vertex, chosen, loop); }, weights);
}

/// Whether the weights follow from the surface alone: the mesh is looked at for its opposite halfedges at most, before
/// the loop asks the callback.
template <class EdgeWeightMap>
bool is_of_surface(const EdgeWeightMap&)
{
  return std::is_same_v<EdgeWeightMap, Conformal_weights>;
}
template <class EdgeWeightMap>
bool is_of_surface(const std::variant<Conformal_weights, EdgeWeightMap>& weights)
{
  return std::holds_alternative<Conformal_weights>(weights);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_SPRINGS_H
