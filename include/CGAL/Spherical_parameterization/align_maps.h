// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_MAPS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_MAPS_H

#include <CGAL/Spherical_parameterization/values/Harmonic_coefficients.h>
#include <CGAL/Spherical_parameterization/values/Rotation.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/rotation.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>

#include <boost/property_map/property_map.hpp>

#include <array>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

namespace internal {

/// The coordinates of the mesh as three functions on the sphere, sampled on a grid.
template <class TriangleMesh, class PointMap>
Sampled_fields sampled_points(const Host_loop& loop, const Spherical_locator<TriangleMesh>& locator, PointMap points,
                              const Latitude_rows& grid)
{
  Host_array<vec3> sample;
  for(const auto& place : locate_all(loop, locator, grid.directions()))
    sample.push_back(coordinates(interpolate(locator.mesh(), place, points)));
  return coordinate_fields(sample);
}

} // namespace internal

/// The rotation of the sphere that aligns the map `a` with the map `b`. Maps are unique only up to rotation, but
/// transfer of data and morphing need maps in the same position. The rotation maximizes the correlation of the two
/// shapes as functions on the sphere, independent of their positions and sizes. The shapes must have the same
/// orientation in space.
///
/// It is the best of all rotations for harmonics up to degree 31: `best_rotation()`.
/// \param a         the inverse of the first map
/// \param points_a  readable, key vertex_descriptor of the mesh of `a`, value with x(), y(), z() or `std::array`
/// \param b         the inverse of the second map
/// \param points_b  readable, key vertex_descriptor of the mesh of `b`, value with x(), y(), z() or `std::array`
/// \param policy,np  see \ref pd_calls
/// \return R such that x in the map `a` corresponds to R x in the map `b`; see `rotated_map()`
/// \throws Error  `NON_FINITE_COORDINATE` for points that are not finite, and `INTERRUPTED`
///
/// Complexity: 8,192 queries in each map, and 25 ms on one core.
template <class ExecutionPolicy, class MeshA, class PointMapA, class MeshB, class PointMapB,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Rotation aligning_rotation(const ExecutionPolicy& policy, const Spherical_locator<MeshA>& a, PointMapA points_a,
                           const Spherical_locator<MeshB>& b, PointMapB points_b,
                           const CGAL_NP_CLASS& np = parameters::default_values())
{
  constexpr int degree = 31;
  internal::Monitor monitor = internal::make_monitor(np);
  const internal::Watched_loop loop(internal::host_loop(policy), monitor);
  const internal::Latitude_rows grid = internal::grid_to_sample(degree);
  const internal::Sampled_fields fields_b = internal::sampled_points(loop.bare(), b, points_b, grid),
                                 fields_a = internal::sampled_points(loop.bare(), a, points_a, grid);
  const Harmonic_coefficients of_b = internal::analyze_rows(loop, grid, fields_b, degree),
                              of_a = internal::analyze_rows(loop, grid, fields_a, degree);
  internal::check_finite(of_b);
  internal::check_finite(of_a);
  return internal::best_correlations(loop, of_b, of_a).front().rotation;
}
CGAL_SP_ON_ONE_CORE(aligning_rotation)

/// A rotated view of a spherical map, to be passed to `transfer_vertex_property()` and similar functions. The rotated
/// coordinates are not stored, since their rounding could flip faces of thin limbs.
template <class VertexSphereMap>
struct Rotated_map {
  /// \cond SKIP_IN_MANUAL
  typedef typename boost::property_traits<VertexSphereMap>::key_type key_type;
  typedef std::array<double, 3> value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;
  /// \endcond

  VertexSphereMap sphere_map; ///< readable, key vertex_descriptor
  Rotation rotation;          ///< what its values are turned by

  friend value_type get(const Rotated_map& map, const key_type& key)
  {
    return internal::array_of(internal::rotated(map.rotation, internal::coordinates(get(map.sphere_map, key))));
  }
};

/// Makes a `Rotated_map`.
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param rotation    what its values are turned by
/// \return a readable property map with values of type `std::array<double, 3>`
template <class VertexSphereMap>
Rotated_map<VertexSphereMap> rotated_map(VertexSphereMap sphere_map, const Rotation& rotation)
{
  return {sphere_map, rotation};
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_ALIGN_MAPS_H
