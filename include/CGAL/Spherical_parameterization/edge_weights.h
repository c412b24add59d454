// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_EDGE_WEIGHTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_EDGE_WEIGHTS_H

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/values/Conformal_weights.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationWeights
/// @{

/// \name Spring weights
/// Arguments of the named parameter `edge_weight_map`: `Conformal_weights`, or a readable property map from edges to
/// double. The maps of the package compute weights on access. They keep references: the mesh must outlive them. Any
/// other readable map from edges to positive numbers can be used, too.
/// @{

/// Uniform (Tutte) weights, w = 1 for every edge: each vertex is at the projected mean of its neighbours. The map
/// depends on the connectivity alone. \cgalModels{SphericalParameterizationWeightMap}
template <class TriangleMesh>
struct Barycentric_weight_map
  : boost::static_property_map<double, typename boost::graph_traits<TriangleMesh>::edge_descriptor> {
  Barycentric_weight_map() : Barycentric_weight_map::static_property_map(1) {}
};

/// Cotangent weights of the edges of the mesh, w = (cot alpha + cot beta) / 2, with alpha and beta the angles opposite
/// to the edge, each clamped to [minimum, maximum] degrees, as in the paper. Bounds inside (0, 90) keep all weights
/// positive, also at faces of area 0 (whose angles are taken as 0 or 180 degrees). The map is conformal up to
/// discretization and clamping, so not where angles are obtuse. U. Pinkall, K. Polthier, "Computing discrete minimal
/// surfaces and their conjugates", Experimental Mathematics 2 (1993).
/// \cgalModels{SphericalParameterizationWeightMap}
template <class TriangleMesh, class VertexPointMap>
class Clamped_weight_map {
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

public:
  /// \cond SKIP_IN_MANUAL
  typedef typename Graph_traits::edge_descriptor key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;
  /// \endcond

  /// \param mesh           a triangle mesh, a model of `HalfedgeGraph`; must outlive the map
  /// \param points         readable, key vertex_descriptor, value with x(), y(), z()
  /// \param minimum_angle  of the clamping, in degrees
  /// \param maximum_angle  of the clamping, in degrees
  /// \pre 0 < minimum_angle <= maximum_angle < 90
  Clamped_weight_map(const TriangleMesh& mesh, VertexPointMap points, double minimum_angle, double maximum_angle)
    : mesh_(&mesh), points_(points), largest_(cotangent_of_degrees(minimum_angle)),
      smallest_(cotangent_of_degrees(maximum_angle))
  {
    CGAL_SP_PRECONDITION(0 < minimum_angle && minimum_angle <= maximum_angle && maximum_angle < 90,
                         "the angles of clamped weights are 0 < minimum <= maximum < 90 degrees");
  }

  friend double get(const Clamped_weight_map& m, const key_type& e)
  {
    const auto h = halfedge(e, *m.mesh_);
    return (m.opposite_cotangent(h) + m.opposite_cotangent(opposite(h, *m.mesh_))) / 2;
  }

private:
  static double cotangent_of_degrees(double angle) { return 1 / std::tan(angle * internal::pi / 180); }

  double opposite_cotangent(typename Graph_traits::halfedge_descriptor h) const
  {
    const internal::vec3 apex = internal::coordinates(get(points_, target(next(h, *mesh_), *mesh_)));
    const auto side_to = [&](auto v) {
      return internal::scaled_to_unit_box(internal::sub(internal::coordinates(get(points_, v)), apex));
    };
    const internal::vec3 a = side_to(source(h, *mesh_)), b = side_to(target(h, *mesh_));
    const double sine = internal::norm(internal::outer(a, b)), cosine = internal::inner(a, b);
    if(sine == 0)
      return cosine < 0 ? smallest_ : largest_;
    return (std::min)(largest_, (std::max)(smallest_, cosine / sine));
  }

  const TriangleMesh* mesh_;
  VertexPointMap points_;
  double largest_, smallest_;
};

/// Mean value coordinates, symmetrized: each end of the edge e has the coordinate (tan a/2 + tan b/2) / |e|, with a and
/// b its angles next to the edge. The coordinates of both ends are averaged. Not defined at faces of (almost) no area.
/// M. Floater, "Mean value coordinates", CAGD 20 (2003). \cgalModels{SphericalParameterizationWeightMap}
template <class TriangleMesh, class VertexPointMap>
class Mean_value_weight_map {
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;

public:
  /// \cond SKIP_IN_MANUAL
  typedef typename Graph_traits::edge_descriptor key_type;
  typedef double value_type;
  typedef double reference;
  typedef boost::readable_property_map_tag category;
  /// \endcond

  /// \param mesh    a triangle mesh, a model of `HalfedgeGraph`; must outlive the map
  /// \param points  readable, key vertex_descriptor, value with x(), y(), z()
  Mean_value_weight_map(const TriangleMesh& mesh, VertexPointMap points) : mesh_(&mesh), points_(points) {}

  friend double get(const Mean_value_weight_map& m, const key_type& e)
  {
    const halfedge_descriptor h = halfedge(e, *m.mesh_);
    const internal::vec3 d = internal::sub(m.point(target(h, *m.mesh_)), m.point(source(h, *m.mesh_)));
    const internal::vec3 unit = internal::scaled_to_unit_box(d);
    const double size = (std::max)({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    const double length = size * std::sqrt(internal::inner(unit, unit)); // std::hypot() differs between libraries
    return (m.half_tangents(h) + m.half_tangents(opposite(h, *m.mesh_))) / (2 * length);
  }

private:
  internal::vec3 point(typename Graph_traits::vertex_descriptor v) const
  {
    return internal::coordinates(get(points_, v));
  }

  /// tan a/2 + tan b/2 of the two angles at the source of h next to it
  double half_tangents(halfedge_descriptor h) const
  {
    const auto origin = source(h, *mesh_);
    const auto end = target(h, *mesh_);
    return half_tangent(origin, end, target(next(h, *mesh_), *mesh_)) +
           half_tangent(origin, end, target(next(opposite(h, *mesh_), *mesh_), *mesh_));
  }

  double half_tangent(typename Graph_traits::vertex_descriptor origin, typename Graph_traits::vertex_descriptor p,
                      typename Graph_traits::vertex_descriptor q) const
  {
    const internal::vec3 a = internal::scaled_to_unit_box(internal::sub(point(p), point(origin)));
    const internal::vec3 b = internal::scaled_to_unit_box(internal::sub(point(q), point(origin)));
    const double lengths = std::sqrt(internal::inner(a, a) * internal::inner(b, b));
    return internal::norm(internal::outer(a, b)) / (lengths + internal::inner(a, b)); // tan x/2 = sin x / (1 + cos x)
  }

  const TriangleMesh* mesh_;
  VertexPointMap points_;
};

/// Uniform (Tutte) weights, 1 for every edge.
/// \return a `Barycentric_weight_map`
template <class TriangleMesh>
Barycentric_weight_map<TriangleMesh> barycentric_weights(const TriangleMesh&)
{
  return {};
}

/// Conformal weights, the default of `parameterize()`, which computes them (internal/surface/conformal_graph.h).
/// \return the tag `Conformal_weights`
template <class TriangleMesh>
Conformal_weights conformal_weights(const TriangleMesh&)
{
  return {};
}

/// Clamped cotangent weights.
/// \param mesh           a triangle mesh, a model of `HalfedgeGraph`; must outlive the map
/// \param minimum_angle  of the clamping, in degrees
/// \param maximum_angle  of the clamping, in degrees
/// \param np             optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return a `Clamped_weight_map`
/// \pre 0 < minimum_angle <= maximum_angle < 90
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
auto clamped_weights(const TriangleMesh& mesh, double minimum_angle = 5, double maximum_angle = 85,
                     const NamedParameters& np = parameters::default_values())
{
  const auto points = internal::vertex_points(mesh, np);
  return Clamped_weight_map<TriangleMesh, std::decay_t<decltype(points)>>(mesh, points, minimum_angle, maximum_angle);
}

/// Symmetrized mean value weights.
/// \param mesh  a triangle mesh, a model of `HalfedgeGraph`; must outlive the map
/// \param np    optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return a `Mean_value_weight_map`
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
auto mean_value_weights(const TriangleMesh& mesh, const NamedParameters& np = parameters::default_values())
{
  const auto points = internal::vertex_points(mesh, np);
  return Mean_value_weight_map<TriangleMesh, std::decay_t<decltype(points)>>(mesh, points);
}
/// @}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_EDGE_WEIGHTS_H
