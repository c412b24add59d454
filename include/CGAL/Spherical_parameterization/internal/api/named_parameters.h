// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_NAMED_PARAMETERS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_NAMED_PARAMETERS_H

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/version.h>

#include <boost/property_map/property_map.hpp>

namespace CGAL {

#if CGAL_VERSION_NR < 1060100000
// edge_weight_map came with CGAL 6.1. Before that it has to be the first of a chain of named parameters:
// edge_weight_map(weights).accuracy(1e-9)
namespace internal_np {
enum spherical_edge_weight_t { spherical_edge_weight };
}

namespace parameters {
template <class EdgeWeightMap>
Named_function_parameters<EdgeWeightMap, internal_np::spherical_edge_weight_t>
edge_weight_map(const EdgeWeightMap& edge_weights)
{
  return Named_function_parameters<EdgeWeightMap, internal_np::spherical_edge_weight_t>(edge_weights);
}
} // namespace parameters
#endif

namespace internal_np {
enum face_density_t { face_density };
enum vertex_density_t { vertex_density };
} // namespace internal_np

namespace parameters {
// These are no members of CGAL's named parameters. They begin a chain, or are put before one:
// face_density_map(densities, edge_weight_map(weights))
template <class FaceDensityMap, class... Others>
auto face_density_map(const FaceDensityMap& density, const Others&... others)
{
  return Named_function_parameters<FaceDensityMap, internal_np::face_density_t, Others...>(density, others...);
}

template <class VertexDensityMap, class... Others>
auto vertex_density_map(const VertexDensityMap& density, const Others&... others)
{
  return Named_function_parameters<VertexDensityMap, internal_np::vertex_density_t, Others...>(density, others...);
}
} // namespace parameters

namespace Spherical_parameterization {

using boost::get; // of pointers, which are property maps
using boost::put;

namespace internal {

template <class NamedParameters>
struct Tag_of;
template <class T, class Tag, class Base>
struct Tag_of<Named_function_parameters<T, Tag, Base>> {
  typedef Tag type;
};
/// The tag of edge_weight_map, whosever it is.
typedef Tag_of<decltype(parameters::edge_weight_map(0))>::type edge_weight_tag;

/// The vertex point map of `np`, or the mesh's own.
template <class TriangleMesh, class NamedParameters>
auto vertex_points(const TriangleMesh& mesh, const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::vertex_point_t>::value)
    return get_const_property_map(CGAL::vertex_point, mesh);
  else
    return parameters::get_parameter(np, internal_np::vertex_point);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_API_NAMED_PARAMETERS_H
