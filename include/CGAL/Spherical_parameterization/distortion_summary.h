// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/distortion/summarize.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/values/Distortion_summary.h>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMeasures
/// @{

/// Summary of the distortion of a valid map: area, angle and quasi-conformal distortion, symmetric Dirichlet energy.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the distribution of each measure over the source area; where a value is infinite, as at an image without
///         area, its mean and deviation are, too
///
/// Complexity: O(n) in practice, O(n log n) at worst.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Distortion_summary distortion_summary(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                      VertexSphereMap sphere_map,
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  return internal::summarize(
    loop, internal::read_map(mesh, internal::vertex_points(mesh, np), sphere_map, internal::Reading::UNCHECKED, loop));
}
CGAL_SP_ON_ONE_CORE(distortion_summary)

/// How many times lengths become longer or shorter from a surface to corresponding points of another one, such as those
/// that `register_maps()` finds, in the direction in which they do so most: max(sigma_1, 1 / sigma_2) >= 1 of the
/// affine map of each face, both surfaces scaled to the same area. 1 is isometric; where an image has no area it is
/// infinite.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param image_map   readable, key vertex_descriptor, value a point of space: what corresponds to the vertex
/// \param face_map    writable, key face_descriptor, value double; 1 for faces of area 0
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return how these values are spread over the area of the mesh
///
/// Complexity: as `distortion_summary()`.
template <class ExecutionPolicy, class TriangleMesh, class VertexImageMap, class FaceMap,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Length_changes face_length_changes(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexImageMap image_map,
                                   FaceMap face_map, const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  internal::Mapped_surface map =
    internal::read_map(mesh, internal::vertex_points(mesh, np), image_map, internal::Reading::UNCHECKED, loop);
  internal::scale_exactly(map.image);
  const internal::Host_array<double> change = internal::length_changes(loop, map);
  internal::put_values(faces(mesh), change, face_map);
  return internal::summarize_length_changes(loop, map.face_area(loop), change);
}
CGAL_SP_ON_ONE_CORE(face_length_changes)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
