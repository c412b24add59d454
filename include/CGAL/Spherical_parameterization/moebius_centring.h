// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MOEBIUS_CENTRING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MOEBIUS_CENTRING_H

#include <CGAL/Spherical_parameterization/internal/moebius/Centring.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// Moebius centring: moves a map by the Moebius transformation for which the centroid of a density on the surface is at
/// the centre of the sphere. This preserves angles. Afterwards, all conformal maps of a shape are the same up to a
/// rotation: A. Baden, K. Crane, M. Kazhdan, "Moebius registration", SGP 2018.
///
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param mass_map    readable, key vertex_descriptor, value double: the mass of each vertex, not negative: its area
///                    times a density
/// \param centred     writable, key vertex_descriptor, value constructible from three numbers; may be that of
///                    `sphere_map`
/// \return the distance of the centroid from the centre at the end: about 1e-13; more if half of the mass or more is at
///         one point, in which case there is no such transformation
/// \throws Error  `NON_FINITE_COORDINATE` for an image that is no direction, `BAD_WEIGHT` for a mass that is negative
///                or not finite, or if all are 0; nothing is written then
///
/// Edges are arcs of great circles, which such a transformation does not keep: it may flip long faces, and rounding the
/// smallest ones of a map that shrinks limbs much. Certify the result.
///
/// Complexity: O(n); a few steps of Newton's method.
template <class Mesh, class VertexSphereMap, class MassMap, class CentredMap>
double moebius_centred_map(const Mesh& mesh, VertexSphereMap sphere_map, MassMap mass_map, CentredMap centred)
{
  internal::Host_array<internal::vec3> image = internal::vectors_at(vertices(mesh), sphere_map);
  internal::Host_array<double> mass;
  for(auto v : vertices(mesh))
    mass.push_back(static_cast<double>(get(mass_map, v)));
  const double distance = internal::centre_by_mass(mass, image);
  internal::put_vectors(vertices(mesh), image, centred);
  return distance;
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MOEBIUS_CENTRING_H
