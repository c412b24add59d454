// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_STRETCH_HISTOGRAM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_STRETCH_HISTOGRAM_H

#include <cstddef>
#include <cstdint>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationSearch
/// Which histogram of the area stretch.
struct Stretch_histogram {
  /// How the surface is sampled. Every point has the stretch of the vertex in whose barycentric cell it lies.
  enum class Sampling {
    EXACT_AREAS, ///< no sampling: vertices are weighted by the areas of their cells
    UNIFORM,     ///< evenly spaced in the accumulated area of the faces
    RANDOM,      ///< independent points, uniformly distributed by area
    VERTICES     ///< no sampling, and equal weights of vertices: depends on the tessellation
  };
  /// What is counted.
  enum class Scale {
    LOGARITHMIC, ///< log of the stretch, which reaches 60 in limbs
    LINEAR       ///< the stretch itself
  };
  Sampling sampling = Sampling::EXACT_AREAS; ///< how the surface is sampled
  Scale scale = Scale::LOGARITHMIC;          ///< what is counted
  std::size_t bins = 32;                     ///< 2 or more
  double low = -4;                           ///< beginning of the first bin, on the scale; it includes values below
  double high = 28;                          ///< end of the last bin; it includes values above
  std::size_t number_of_samples = 4096;      ///< `UNIFORM` and `RANDOM`; fewer than about 4096 add noise
  std::uint32_t random_seed = 0;             ///< `RANDOM`
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_STRETCH_HISTOGRAM_H
