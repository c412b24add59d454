// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_DISTORTION_SUMMARY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_DISTORTION_SUMMARY_H

#include <cstddef>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationMeasures
/// The distribution of a measure over the surface. Faces are weighted by their source area.
struct Distribution {
  double mean = 0;          ///< weighted by area
  double deviation = 0;     ///< root of the mean square difference from the mean
  double min = 0;           ///< the smallest value
  double percentile_1 = 0;  ///< 1 % of the area have smaller values
  double percentile_5 = 0;  ///< 5 % of the area have smaller values
  double median = 0;        ///< half of the area has smaller values
  double percentile_95 = 0; ///< 5 % of the area have larger values
  double percentile_99 = 0; ///< 1 % of the area have larger values
  double max = 0;           ///< the largest value
};

/// \ingroup PkgSphericalParameterizationMeasures
/// The distortion of a map; see `measure_distortion.h` for the measures. Where faces are flipped, their areas on the
/// sphere are negative: log area stretch and spherical energy are NaN then.
struct Distortion_summary {
  Distribution log_area_stretch;    ///< see `face_log_area_stretch()`
  Distribution angle_distortion;    ///< radians; see `face_angle_distortion()`
  Distribution dilatation;          ///< see `face_dilatation()`
  Distribution symmetric_dirichlet; ///< between flat triangles; 4 = isometric; see `face_symmetric_dirichlet()`
  /// With det(a, b, c) / 2 in place of the area of the flat triangle abc on the sphere: the inscribed polyhedron of a
  /// map may be far from the sphere, as with long edges along a tube, and the flat measure does not see it.
  Distribution spherical_symmetric_dirichlet;
  std::size_t degenerate_faces = 0; ///< number of source faces of area 0, ignored
};

/// \ingroup PkgSphericalParameterizationMeasures
/// How much lengths change between a surface and corresponding points of another one, see `face_length_changes()`.
struct Length_changes {
  Distribution factor;       ///< how many times lengths become longer or shorter
  double share_of_large = 0; ///< of the area of the surface, on which that is more than `large`

  static constexpr double large = 3; ///< what corresponds is squeezed or stretched
};

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_DISTORTION_SUMMARY_H
