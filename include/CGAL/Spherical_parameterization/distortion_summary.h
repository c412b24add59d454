// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/distortion/summarize.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/values/Distortion_summary.h>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMeasures
/// @{

/// Summary of the distortion of a valid map: area, angle and quasi-conformal distortion, symmetric Dirichlet energy.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the distribution of each measure over the source area
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

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_DISTORTION_SUMMARY_H
