// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H

#include <CGAL/Spherical_parameterization/internal/signature/conformal_factor.h>
#include <CGAL/Spherical_parameterization/internal/distortion/histogram.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/persistence.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {

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
  static constexpr std::size_t coarse_bins = 16;                           ///< of the coarse histogram
  static constexpr std::size_t fine_bins = 64;                             ///< of the fine histogram
  static constexpr std::size_t limbs = 8;                                  ///< the longest ones
  static constexpr std::size_t size = coarse_bins + fine_bins + 2 * limbs; ///< 96

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

namespace internal {

/// Typical distances of unlike shapes, which make both parts of the signature weigh the same: what 35 models of 9
/// classes of the SHREC 2007 watertight track have on average.
constexpr double girth_unit = 0.685;
constexpr double limb_unit = 21;

/// Histograms of log |grad u|, linearly interpolated between bins. On a cylinder of radius r, |grad u| is 2 / r.
inline void add_girths(const Discrete_surface& surface, const Discrete_surface::Vector& u, Shape_signature& signature)
{
  constexpr double log_low = -1, log_high = 5; // from a radius of 5 to a hundredth, where a ball of the same area has 1
  const Discrete_surface::Vector gradient = surface.gradient_norm(u);
  Histogram coarse(Shape_signature::coarse_bins, log_low, log_high);
  Histogram fine(Shape_signature::fine_bins, log_low, log_high);
  for(int i = 0; i < surface.size(); ++i) {
    const double girth = std::log((std::max)(gradient[i], 1e-9));
    coarse.add_interpolated(girth, surface.mass()[i]);
    fine.add_interpolated(girth, surface.mass()[i]);
  }
  auto out = signature.values.begin();
  for(const Histogram* histogram : {&coarse, &fine})
    for(double share : histogram->shares())
      *out++ = share / 2 / girth_unit;
}

/// The minima of u are the tips of limbs. A limb's persistence is about twice its length over its radius.
inline void add_limbs(const Discrete_surface& surface, const Discrete_surface::Vector& u, Shape_signature& signature)
{
  constexpr double shortest = 1; // what is shorter than half its radius is a bump; limbs fade in from there
  constexpr double mass_weight = 6;
  std::vector<Basin> limbs = basins(u, surface.mass(), [&](int i, const auto& visit) {
    for(Discrete_surface::Matrix::InnerIterator entry(surface.laplacian(), i); entry; ++entry)
      visit(static_cast<int>(entry.row()));
  });
  limbs.resize((std::min)(limbs.size(), Shape_signature::limbs), Basin{0, 0, 0});
  auto length = signature.values.begin() + Shape_signature::coarse_bins + Shape_signature::fine_bins;
  auto mass = length + Shape_signature::limbs;
  for(const Basin& limb : limbs) {
    const double excess = (std::max)(limb.persistence - shortest, 0.);
    *length++ = std::sqrt(excess) / limb_unit;
    *mass++ =
      mass_weight * std::sqrt(limb.mass / (4 * Discrete_surface::pi())) * (std::min)(excess / shortest, 1.) / limb_unit;
  }
  std::sort(signature.values.end() - Shape_signature::limbs, signature.values.end(), std::greater<double>());
}

} // namespace internal

/// What a shape is like, whatever its pose, position, size and triangles: how thick it is, and what limbs it has.
///
/// Both are read off the logarithm u of the area stretch of the conformal map to the sphere, which changes along a limb
/// of radius r with slope 2 / r, as far as the limb is long. It is not taken from the areas of the map but recovered
/// by one Poisson solve on the intrinsic Delaunay triangulation of the surface, and smoothed a little, so that
/// tessellation and bad triangles hardly matter. Then the histogram of log |grad u|, weighted by area, and the
/// persistence of the minima of u.
///
/// \param mesh  closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a conformal map to the sphere whose centroid
///        of the source area is at the centre, as `parameterize()` computes it. Only where the sphere is large does it
///        have to be right: a map that fails to be bijective in thin limbs will do, and so will a barycentric one.
/// \param np  optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the signature
/// \throws std::invalid_argument for a mesh that is not closed, of genus 0, finite and with an area; and for a map
///         without area
///
/// Complexity: up to 100,000 vertices that of two sparse Cholesky factorisations (10 ms for 5,000 vertices), beyond
/// that linear (multigrid).
template <class TriangleMesh, class VertexSphereMap, class NamedParameters = parameters::Default_named_parameters>
Shape_signature shape_signature(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                const NamedParameters& np = parameters::default_values())
{
  constexpr double smoothing_time = 0.003; // of a surface of area 4 pi: over a twentieth of the radius of that ball
  constexpr int fewest_vertices = 2000;    // coarser meshes are refined: their faces are as long as limbs are thick
  const internal::Conformal_factor<TriangleMesh> factor(mesh, internal::vertex_points(mesh, np), sphere_map,
                                                        fewest_vertices);
  const internal::Discrete_surface::Vector u = internal::smoothed(factor.surface, factor.u, smoothing_time);
  Shape_signature signature;
  internal::add_girths(factor.surface, u, signature);
  internal::add_limbs(factor.surface, u, signature);
  return signature;
}

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SHAPE_SIGNATURE_H
