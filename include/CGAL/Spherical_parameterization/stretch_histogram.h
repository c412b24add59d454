// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_STRETCH_HISTOGRAM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_STRETCH_HISTOGRAM_H

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/distortion/stretch_shares.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/values/Stretch_histogram.h>

#include <cmath>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSearch
/// @{

/// The signature of the paper: the histogram of the area stretch factor of Definition 1, as `vertex_log_area_stretch()`
/// measures it. T. Athanasiadis and I. Fudos, SMI 2011, section 5.3. The shares add up to 1. `shape_signature()`
/// distinguishes shapes better, and depends less on the tessellation.
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param options     which histogram
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return one share for each bin
/// \pre options.bins >= 2, options.low < options.high, both are finite, options.number_of_samples >= 1
/// \throws Error  `DEGENERATE_FACE` for a mesh of area 0, and the errors of `vertex_log_area_stretch()`
///
/// Complexity: linear in the size of the mesh and the number of samples.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
std::vector<double> stretch_histogram(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                      VertexSphereMap sphere_map, const Stretch_histogram& options = {},
                                      const CGAL_NP_CLASS& np = parameters::default_values())
{
  CGAL_SP_PRECONDITION(options.bins >= 2, "a histogram has two bins or more");
  CGAL_SP_PRECONDITION(options.low < options.high && std::isfinite(options.high - options.low),
                       "the first bin of a histogram begins below the end of the last one, at a finite distance");
  CGAL_SP_PRECONDITION(options.number_of_samples >= 1, "a histogram has one sample or more");
  const auto loop = internal::host_loop(policy);
  const internal::Mapped_surface map =
    internal::read_map(mesh, internal::vertex_points(mesh, np), sphere_map, internal::Reading::MEASURED, loop);
  return internal::stretch_shares(loop, map, options);
}
CGAL_SP_ON_ONE_CORE(stretch_histogram)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_STRETCH_HISTOGRAM_H
