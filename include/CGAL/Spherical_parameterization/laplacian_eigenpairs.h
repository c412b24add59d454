// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_LAPLACIAN_EIGENPAIRS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_LAPLACIAN_EIGENPAIRS_H

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/kernel_signatures.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/laplacian_spectrum.h>
#include <CGAL/Spherical_parameterization/internal/surface/conformal_graph.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/values/Laplacian_eigenpairs.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSpectrum
/// @{

/// The smallest eigenvalues of the Laplace-Beltrami operator of a surface, and their functions: the vibrations of a
/// drum of this shape. They depend on lengths inside the surface only, so that two poses of a body have nearly the
/// same.
///
/// The Laplacian has the conformal weights: cotangents of the intrinsic Delaunay triangulation (A. Bobenko,
/// B. Springborn, "A discrete Laplace-Beltrami operator for simplicial surfaces", Discrete & Computational Geometry 38,
/// 2007), the masses are the thirds of the areas. It is solved by block Lanczos iteration with the factorization of the
/// shifted matrix, to 1e-11 relative to the shift. No pair is missed, since the factorization counts the pairs below.
///
/// \param policy  `CGAL::Sequential_tag`, the default, or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh    a closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param number  number of pairs, including that of the eigenvalue 0
/// \param np      optional named parameters: `vertex_point_map`, by default the mesh's own; `callback` and
///                `maximum_running_time`, as in `parameterize()`
/// \return the pairs; vertices in the order of `vertices(mesh)`
/// \throws Error  the codes of `parameterize()` for the mesh; `DEGENERATE_FACE` if the faces around a vertex have
///                the area 0; `NON_FINITE_COORDINATE` for sizes above 1e140 or below 1e-140; `NOT_CONVERGED`;
///                `INTERRUPTED`
/// \pre 1 <= number <= number of vertices
///
/// Memory: 3 numbers per vertex and pair. Time: O(n^1.5) for the factorization, and O(n number^2).
template <class ExecutionPolicy, class TriangleMesh, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
Laplacian_eigenpairs laplacian_eigenpairs(const ExecutionPolicy& policy, const TriangleMesh& mesh, std::size_t number,
                                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  const auto points = internal::vertex_points(mesh, np);
  internal::Monitor monitor = internal::make_monitor(np);
  internal::Vertices<TriangleMesh> vertex;
  const internal::Surface surface = internal::read_surface(mesh, points, internal::Reading::CHECKED, loop, vertex);
  CGAL_SP_PRECONDITION(number >= 1 && number <= vertex.size(), "there are as many eigenpairs as vertices");
  // of the surface in a box of size 1
  const double unit = 2 * internal::Bounding_box(internal::vectors_at(vertex, points)).half_size();
  if(unit > 0 && !(unit > 1e-140 && unit < 1e140))
    throw Error(Error_code::NON_FINITE_COORDINATE, "the squares of lengths overflow or vanish; scale the mesh");
  internal::Spring_lengths lengths;
  const internal::Weighted_graph laplacian = internal::conformal_graph(
    internal::Watched_loop(loop, monitor), surface.copy_of_corner_table(loop), surface.point, lengths);
  Laplacian_eigenpairs pairs =
    internal::laplacian_spectrum(loop, laplacian, surface.vertex_area(loop), static_cast<int>(number), monitor);
  for(double& value : pairs.value)
    value = value / unit / unit;
  for(double& value : pairs.functions)
    value /= unit;
  for(double& mass : pairs.mass)
    mass *= unit * unit;
  return pairs;
}
CGAL_SP_ON_ONE_CORE(laplacian_eigenpairs)

/// The heat kernel signature: the share of a unit of heat at a vertex that is still there after some time. J. Sun,
/// M. Ovsjanikov, L. Guibas, "A concise and provably informative multi-scale signature based on heat diffusion", SGP
/// 2009.
/// \param pairs  pairs of the surface. Missing pairs have an influence for times below about 4 / (their eigenvalue).
/// \param times  not negative, in units of length^2
/// \return one time after the other, the values of all vertices: entry t * number of vertices + i
inline std::vector<double> heat_kernel_signature(const Laplacian_eigenpairs& pairs, const std::vector<double>& times)
{
  std::vector<std::vector<double>> filters;
  for(double time : times) {
    CGAL_SP_PRECONDITION(time >= 0 && std::isfinite(time),
                         "times of the heat kernel signature must be finite, and not negative");
    std::vector<double>& filter = filters.emplace_back();
    for(double value : pairs.value)
      filter.push_back(std::exp(-value * time));
  }
  return internal::filtered_squares(pairs, filters);
}

/// The wave kernel signature: the probability of finding a quantum particle of some energy at a vertex. M. Aubry,
/// U. Schlickewei, D. Cremers, "The wave kernel signature: a quantum mechanical approach to shape analysis", ICCV
/// Workshops 2011. Energies are spaced evenly on a logarithmic scale, between the first eigenvalue above 0 and the last
/// one, two standard deviations from either. The deviation is that of the paper, 7 parts of the range, of which there
/// are as many as energies, but at most a fifth of the range.
/// \param pairs  pairs of the surface, two or more
/// \param number_of_energies  number of energies, two or more
/// \return one energy after the other, the values of all vertices: entry e * number of vertices + i; 1 / length^2
inline std::vector<double> wave_kernel_signature(const Laplacian_eigenpairs& pairs,
                                                 std::size_t number_of_energies = 100)
{
  CGAL_SP_PRECONDITION(pairs.number() >= 2, "the wave kernel signature needs two pairs or more");
  CGAL_SP_PRECONDITION(number_of_energies >= 2, "the wave kernel signature has two energies or more");
  return internal::filtered_squares(pairs, internal::wave_kernel_filters(pairs.value, number_of_energies));
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_LAPLACIAN_EIGENPAIRS_H
