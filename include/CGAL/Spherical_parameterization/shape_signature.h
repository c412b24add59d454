// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/signature/signature_values.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSearch
/// @{

/// The signature of a shape: 96 numbers, compared by the L1 distance. It is similar for all poses of a shape, and
/// independent of position, size and orientation (including reflections). See `shape_signature()`.
///
/// The numbers are nonnegative, and scaled such that dissimilar shapes differ by about 1 in girths and in limbs:
/// -  0 ... 15: girths, a coarse histogram
/// - 16 ... 79: girths, a fine one
/// - 80 ... 87: lengths of the limbs, longest first
/// - 88 ... 95: their shares of the surface, largest first
struct Shape_signature {
  static constexpr std::size_t coarse_bins = internal::Signature_sizes::coarse_bins; ///< of the coarse histogram
  static constexpr std::size_t fine_bins = internal::Signature_sizes::fine_bins;     ///< of the fine histogram
  static constexpr std::size_t limbs = internal::Signature_sizes::limbs;             ///< the longest ones
  static constexpr std::size_t size = internal::Signature_sizes::all;                ///< 96

  std::array<double, size> values{}; ///< the coordinates
};

/// The L1 distance of two signatures. It is typically 0.2 between poses of one shape, and 2 between different shapes.
/// \param a  a signature
/// \param b  another one
/// \return the sum of the absolute differences
inline double distance(const Shape_signature& a, const Shape_signature& b)
{
  double sum = 0;
  for(std::size_t i = 0; i < Shape_signature::size; ++i)
    sum += std::abs(a.values[i] - b.values[i]);
  return sum;
}

/// A shape descriptor for retrieval. It describes how thick a shape is and what limbs it has, independent of pose,
/// position, size and triangulation.
///
/// It is computed from the logarithm u of the area stretch of the conformal map to the sphere (the conformal factor).
/// Along a limb of radius r, u has the slope 2 / r over the length of the limb. One Poisson solve on the intrinsic
/// Delaunay triangulation of the surface yields u, instead of the areas of the map, and u is slightly smoothed; so
/// tessellation and bad triangles have little influence. The signature has the area-weighted histogram of log |grad u|,
/// and the persistence of the minima of u.
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh  closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a conformal map to the sphere whose centroid
///        of the source area is at the centre, as `parameterize()` computes it. The map needs to be accurate only where
///        the sphere is large: a map that is not bijective in thin limbs can be used, and so can a barycentric one.
/// \param np  optional named parameters: `vertex_point_map`, by default the mesh's own; `callback` and
///        `maximum_running_time`, as in `parameterize()`
/// \return the signature
/// \throws Error  if the mesh is not closed, of genus 0, finite and of positive area, or if the map has no area;
///                `INTERRUPTED`
///
/// Complexity: up to 100,000 vertices that of two sparse Cholesky factorizations (10 ms for 5,000 vertices), on one
/// core whatever the policy; beyond that linear (multigrid).
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Shape_signature shape_signature(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  internal::Monitor monitor = internal::make_monitor(np);
  const internal::Mapped_surface map =
    internal::read_map(mesh, internal::vertex_points(mesh, np), sphere_map, internal::Reading::BREADTH_FIRST, loop);
  const internal::Watched_loop watched(loop, monitor);
  watched.advance(0);
  return Shape_signature{internal::signature_values(watched, map)};
}
CGAL_SP_ON_ONE_CORE(shape_signature)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H
