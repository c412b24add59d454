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

/// The default: a vote of girth profiles and four concavity segmentations.
///
/// Girth profiles find where a limb ends, but not parts that are no limbs: fins, lids, the steps of a turned part. Such
/// parts are bordered by concave creases. A bottom-up normalized cut finds creases, but cuts all of them. There are
/// four such cuts, at four scales (valleys of 0.02 to 0.07 times the square root of the area), with one vote each; the
/// girth profiles have two votes. Neighbours whose union has a majority are united. If a shape has no limbs, the girths
/// vote for no cut, and three of the four scales have to agree.
///
/// O(n log n); on one core 15,000 faces take about 0.3 s.
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
