// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SEGMENTATION_METHODS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SEGMENTATION_METHODS_H

#include <cstddef>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSegmentation
/// @{

/// Options of all methods of segmentation.
struct Segment_limits {
  /// Segments smaller than this share of the whole area, in [0, 1], are merged with a neighbour.
  double minimum_area = 0.01;
  /// 0: the method chooses. Otherwise the least convincing cuts are left out until there are this many segments; there
  /// may be fewer if the method finds fewer.
  std::size_t number_of_segments = 0;
};

/// The default: a vote of girth profiles, four segmentations along concave creases, and one by the light inside.
///
/// Girth profiles (2.5 votes) find where a limb ends, but no fins, lids, or steps of a turned part. Bottom-up
/// normalized cuts at four scales (creases of 0.02 to 0.07 times the square root of the area; one vote each) find the
/// concave creases around such parts. Light that walls reflect inside the body (one vote) tells what lies around one
/// cavity: limbs are cut off, also where they bend, and the two sides of the wall of a cup are not. Neighbours whose
/// union has the majority are united, and then those with no crease between them, such as two halves of a rod.
///
/// O(n log n); on one core 15,000 faces take about 0.4 s. Outside is where normals point: counterclockwise faces.
///
/// \cgalModels{SphericalSegmentationMethod}
struct Majority_vote : Segment_limits {};

/// Girth profiles alone: the fastest. Cuts limbs off at necks, and where the girth along isolines around their tips on
/// the sphere starts to grow like that of a body. The rest is one segment. O(n) for each tip.
///
/// \cgalModels{SphericalSegmentationMethod}
struct Girth_profiles : Segment_limits {};

/// The published method: region growing over the stretch. T. Athanasiadis and I. Fudos, "Parallel computation of
/// spherical parameterizations for mesh analysis", Computers & Graphics 35 (SMI 2011), section 5.1. Seeds are the local
/// extrema of the stretch (Definition 2), taken in descending order; a region grows from each over the faces whose
/// logarithmic stretch differs by at most `threshold` from that of the seed. Seeds inside a region are dropped.
///
/// \cgalModels{SphericalSegmentationMethod}
struct Region_growing : Segment_limits {
  double threshold = 1; ///< difference of logarithms of the stretch; 0 or more
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SEGMENTATION_METHODS_H
