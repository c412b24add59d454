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
  /// How the surface is weighed. Every point has the stretch of the vertex in whose barycentric cell it lies.
  enum class Sampling {
    EXACT_AREAS, ///< no sampling: every vertex counts with the area of its cell
    UNIFORM,     ///< evenly spaced in the accumulated area of the faces
    RANDOM,      ///< independent points, uniformly distributed by area
    VERTICES     ///< no sampling, and every vertex counts alike: depends on the tessellation
  };
  /// What is counted.
  enum class Scale {
    LOGARITHMIC, ///< log of the stretch, which reaches 60 in limbs
    LINEAR       ///< the stretch itself
  };
  Sampling sampling = Sampling::EXACT_AREAS; ///< how the surface is weighed
  Scale scale = Scale::LOGARITHMIC;          ///< what is counted
  std::size_t bins = 32;                     ///< 2 or more
  double low = -4;                           ///< where the first bin begins, on the scale; what lies below counts there
  double high = 28;                          ///< where the last bin ends; what lies above counts there
  std::size_t number_of_samples = 4096;      ///< `UNIFORM` and `RANDOM`; fewer than about 4096 add noise
  std::uint32_t random_seed = 0;             ///< `RANDOM`
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_STRETCH_HISTOGRAM_H
