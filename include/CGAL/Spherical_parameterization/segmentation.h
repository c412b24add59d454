// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Segmentation of a mesh into body and limbs by its spherical parameterization. As with CGAL's SDF values, the measure
// and the cut are separate calls:
//
//   face_log_area_stretch(mesh, sphere, stretch);                              // like sdf_values()
//   segmentation_from_area_stretch(mesh, sphere, stretch, segments);           // like segmentation_from_sdf_values()
//   segmentation_via_area_stretch(mesh, sphere, segments);                     // both
//
// The sphere should be conformal (the default of parameterize()): its stretch knows how long and how thin a limb is.
// It need not be valid: tips too thin for doubles, where faces are flipped, do no harm.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SEGMENTATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SEGMENTATION_H

#include <CGAL/Spherical_parameterization/Result.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/concave_cuts.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/girth_profiles.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/majority_vote.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/region_growing.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/segment_selection.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/assertions.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {

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
/// Those are bordered by concave creases, which a bottom-up normalised cut finds, at the price of cutting every crease.
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

/// What became of a segmentation. `segment_map` is written only if there is no error.
struct Segmentation_result {
  Error_code error = Error_code::OK;  ///< what is wrong with the mesh or the map
  std::string detail;                 ///< what and where; empty if `OK`
  std::size_t number_of_segments = 0; ///< 0 if there is an error

  /// \return `true` iff there is no error
  explicit operator bool() const { return error == Error_code::OK; }
};

namespace internal {

inline void check_limits(const Segment_limits& limits)
{
  CGAL_precondition(limits.minimum_area >= 0 && limits.minimum_area <= 1);
  (void)limits;
}

inline std::vector<int> segments_of(const Segmentation_mesh& mesh, const std::vector<double>& stretch,
                                    const Girth_profiles& method)
{
  return selected_segments(mesh, girth_labels(mesh, stretch), method.minimum_area, method.number_of_segments);
}

inline std::vector<int> segments_of(const Segmentation_mesh& mesh, const std::vector<double>& stretch,
                                    const Region_growing& method)
{
  CGAL_precondition(method.threshold >= 0);
  return selected_segments(mesh, grown_labels(mesh, stretch, method.threshold), method.minimum_area,
                           method.number_of_segments);
}

inline std::vector<int> segments_of(const Segmentation_mesh& mesh, const std::vector<double>& stretch,
                                    const Majority_vote& method)
{
  constexpr double girth_weight = 2;
  std::vector<Voter> voters = {{segments_of(mesh, stretch, Girth_profiles()), girth_weight}};
  for(std::vector<int>& label : concavity_segments(mesh))
    voters.push_back({std::move(label), 1});
  return majority_segments(mesh, voters, method.minimum_area, method.number_of_segments);
}

} // namespace internal

/// Cuts a mesh by its stretch. Every segment is connected; their numbers are 0 ... n-1 in the order of their first
/// faces.
///
/// Deterministic. Scaling and rotating the mesh and rotating the sphere change nothing, but where decisions hang on
/// rounding; nor does another numbering, but where the shape leaves a choice, as symmetric ones do.
/// \param mesh        a closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value of any length but 0
/// \param stretch_map readable, key face_descriptor, value double: what `face_log_area_stretch()` has written. Faces
///                    with less than 1e-36 of the sphere, and flipped ones, count as if they had 1e-36: doubles resolve
///                    nothing smaller near length 1, so that limbs that are too thin end in a plateau.
/// \param segment_map writable, key face_descriptor, value constructible from std::size_t
/// \param method      `Majority_vote`, `Girth_profiles` or `Region_growing`
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the number of segments, or what is wrong with the mesh or the maps
template <class TriangleMesh, class VertexSphereMap, class FaceStretchMap, class FaceSegmentMap,
          class Method = Majority_vote, class NamedParameters = parameters::Default_named_parameters>
Segmentation_result segmentation_from_area_stretch(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                                   FaceStretchMap stretch_map, FaceSegmentMap segment_map,
                                                   const Method& method = Method(),
                                                   const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::property_traits<FaceSegmentMap>::value_type Segment_id;
  constexpr double least_share = 1e-36;
  constexpr double least_area = 1e-300;
  internal::check_limits(method);
  Segmentation_result result;
  try {
    const internal::Segmentation_mesh arrays =
      internal::read_segmentation_mesh(mesh, internal::vertex_points(mesh, np), sphere_map);
    std::vector<double> stretch;
    stretch.reserve(arrays.face.size());
    for(auto f : faces(mesh)) {
      const double value = get(stretch_map, f);
      if(!std::isfinite(value))
        throw Error{Error_code::NON_FINITE_COORDINATE, "the stretch of face " + std::to_string(stretch.size())};
      stretch.push_back((std::min)(value, std::log((std::max)(arrays.area[stretch.size()], least_area) / least_share)));
    }
    const std::vector<int> segment = internal::segments_of(arrays, stretch, method);
    std::size_t i = 0;
    for(auto f : faces(mesh)) {
      const std::size_t id = static_cast<std::size_t>(segment[i++]);
      put(segment_map, f, static_cast<Segment_id>(id));
      result.number_of_segments = (std::max)(result.number_of_segments, id + 1);
    }
  } catch(const Error& error) {
    result.error = error.code();
    result.detail = error.detail();
  }
  return result;
}

/// Measure and cut in one call.
/// \param mesh        a closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; the map need not be valid
/// \param segment_map writable, key face_descriptor, value constructible from std::size_t
/// \param method      `Majority_vote`, `Girth_profiles` or `Region_growing`
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the number of segments, or what is wrong with the mesh or the map
template <class TriangleMesh, class VertexSphereMap, class FaceSegmentMap, class Method = Majority_vote,
          class NamedParameters = parameters::Default_named_parameters>
Segmentation_result segmentation_via_area_stretch(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                                  FaceSegmentMap segment_map, const Method& method = Method(),
                                                  const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  std::unordered_map<face_descriptor, double, boost::hash<face_descriptor>> stretch;
  const boost::associative_property_map<decltype(stretch)> stretch_map(stretch);
  face_log_area_stretch(mesh, sphere_map, stretch_map, np);
  return segmentation_from_area_stretch(mesh, sphere_map, stretch_map, segment_map, method, np);
}

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SEGMENTATION_H
