// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SEGMENTATION_METHODS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SEGMENTATION_METHODS_H

#include <cstddef>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSegmentation
/// @{

/// What all methods of segmentation understand.
struct Segment_limits {
  /// Segments smaller than this share of the whole area, in [0, 1], are given to a neighbour.
  double minimum_area = 0.01;
  /// 0: the method chooses. Else the method's least convincing cuts are left out until there are so many; if it has
  /// found less, there are less.
  std::size_t number_of_segments = 0;
};

/// The default: girth profiles and four concavity segmentations vote.
///
/// Girth profiles know where a limb ends, but not of parts that are no limbs: fins, lids, the steps of a turned part.
/// Those are bordered by concave creases, which a bottom-up normalized cut finds, at the price of cutting every crease.
/// It is made at four scales (valleys of 0.02 to 0.07 times the square root of the area), each with one vote; the
/// girth profiles have two. Neighbours whose union has a majority are united. Where a shape has no limbs the girths
/// abstain from cutting, and three of the four scales have to agree.
///
/// O(n log n); on one core 15,000 faces take about 0.3 s.
///
/// \cgalModels{SphericalSegmentationMethod}
struct Majority_vote : Segment_limits {};

/// Girth profiles alone: the fastest. Cuts limbs off where, along the isolines round their tips on the sphere, the
/// girth starts to grow like that of a body, and at necks. What is no limb is one segment. O(n) for each tip.
///
/// \cgalModels{SphericalSegmentationMethod}
struct Girth_profiles : Segment_limits {};

/// The published method: region growing over the stretch. T. Athanasiadis and I. Fudos, "Parallel computation of
/// spherical parameterizations for mesh analysis", Computers & Graphics 35 (SMI 2011), section 5.1. Seeds are the local
/// extrema of the stretch (Definition 2), taken in descending order; a region grows from each over the faces whose
/// logarithmic stretch differs by at most `threshold` from that of the seed, and seeds it meets are dropped.
///
/// \cgalModels{SphericalSegmentationMethod}
struct Region_growing : Segment_limits {
  double threshold = 1; ///< difference of logarithms of the stretch; 0 or more
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_VALUES_SEGMENTATION_METHODS_H
