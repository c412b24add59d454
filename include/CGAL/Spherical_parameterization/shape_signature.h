// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/signature/signature_values.h>

#include <array>
#include <cmath>
#include <cstddef>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSearch
/// @{

/// A shape as a point of R^96 with the distance L1: near to those of its other poses, and independent of position,
/// size and orientation (reflections included). See `shape_signature()`.
///
/// Coordinates, all nonnegative, and scaled so that two unlike shapes are about 1 apart in girths and in limbs:
/// -  0 ... 15: girths, a coarse histogram
/// - 16 ... 79: girths, a fine one
/// - 80 ... 87: how long the limbs are, longest first
/// - 88 ... 95: how much of the surface they are, largest first
struct Shape_signature {
  static constexpr std::size_t coarse_bins = internal::Signature_sizes::coarse_bins; ///< of the coarse histogram
  static constexpr std::size_t fine_bins = internal::Signature_sizes::fine_bins;     ///< of the fine histogram
  static constexpr std::size_t limbs = internal::Signature_sizes::limbs;             ///< the longest ones
  static constexpr std::size_t size = internal::Signature_sizes::all;                ///< 96

  std::array<double, size> values{}; ///< the coordinates
};

/// How unlike two shapes are: L1, in [0, infinity). Poses of a shape are typically .2 apart, other shapes 2.
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

/// A shape descriptor for retrieval: what a shape is like, whatever its pose, position, size and triangles, how thick
/// it is, and what limbs it has.
///
/// Both are read off the logarithm u of the area stretch of the conformal map to the sphere (the conformal factor),
/// which changes along a limb of radius r with slope 2 / r, as far as the limb is long. It is not taken from the areas
/// of the map but recovered by one Poisson solve on the intrinsic Delaunay triangulation of the surface, and smoothed a
/// little, so that tessellation and bad triangles hardly matter. Then the histogram of log |grad u|, weighted by area,
/// and the persistence of the minima of u.
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh  closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a conformal map to the sphere whose centroid
///        of the source area is at the centre, as `parameterize()` computes it. Only where the sphere is large does it
///        have to be right: a map that fails to be bijective in thin limbs will do, and so will a barycentric one.
/// \param np  optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the signature
/// \throws Error  for a mesh that is not closed, of genus 0, finite and with an area; and for a map without area
///
/// Complexity: up to 100,000 vertices that of two sparse Cholesky factorizations (10 ms for 5,000 vertices), on one
/// core whatever the policy; beyond that linear (multigrid).
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Shape_signature shape_signature(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  return Shape_signature{
    internal::signature_values(loop, internal::read_map(mesh, internal::vertex_points(mesh, np), sphere_map,
                                                        internal::Reading::BREADTH_FIRST, loop))};
}
CGAL_SP_ON_ONE_CORE(shape_signature)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H
