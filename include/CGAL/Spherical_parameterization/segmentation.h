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

#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/host_policy.h>
#include <CGAL/Spherical_parameterization/internal/base/compiled.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/base/precondition.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
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

/// What became of a segmentation. `segment_map` is written only if there is no error.
struct Segmentation_result {
  Error_code error = Error_code::OK;  ///< what is wrong with the mesh or the map
  std::string detail;                 ///< what and where; empty if `OK`
  std::size_t number_of_segments = 0; ///< 0 if there is an error

  /// \return `true` iff there is no error
  explicit operator bool() const { return error == Error_code::OK; }
};

namespace internal {

/// A segment for every face, by the stretch of the faces. Throws Error for what `make_segmentation_mesh()` refuses, and
/// for a stretch that is not finite.
template <class Loop, class Method>
std::vector<int> segments_of(const Loop& loop, Mapped_surface surface, std::vector<double> stretch,
                             const Method& method);

/// What the compiled library has, after the word `template` or `extern template`.
#define CGAL_SP_SEGMENTATION(PREFIX, LOOP)                                                                             \
  PREFIX std::vector<int> segments_of(const LOOP&, Mapped_surface, std::vector<double>, const Majority_vote&);         \
  PREFIX std::vector<int> segments_of(const LOOP&, Mapped_surface, std::vector<double>, const Girth_profiles&);        \
  PREFIX std::vector<int> segments_of(const LOOP&, Mapped_surface, std::vector<double>, const Region_growing&);

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
CGAL_SP_SEGMENTATION(extern template, Sequential_loop)
#ifdef CGAL_LINKED_WITH_TBB
CGAL_SP_SEGMENTATION(extern template, Parallel_loop)
#endif
#endif

inline void check_options(const Segment_limits& limits)
{
  CGAL_SP_PRECONDITION(limits.minimum_area >= 0 && limits.minimum_area <= 1,
                       "the minimum area of segments is a share: 0 to 1");
}

inline void check_options(const Region_growing& method)
{
  check_options(static_cast<const Segment_limits&>(method));
  CGAL_SP_PRECONDITION(method.threshold >= 0, "the threshold of region growing must not be negative");
}

/// \param read_stretch  returns the stretch of the faces, in their order
template <class Loop, class TriangleMesh, class VertexSphereMap, class ReadStretch, class FaceSegmentMap, class Method,
          class NamedParameters>
Segmentation_result segment(const Loop& loop, const TriangleMesh& mesh, VertexSphereMap sphere_map,
                            ReadStretch read_stretch, FaceSegmentMap segment_map, const Method& method,
                            const NamedParameters& np)
{
  typedef typename boost::property_traits<FaceSegmentMap>::value_type Segment_id;
  check_options(method);
  Segmentation_result result;
  try {
    Mapped_surface surface = read_mapped_surface(mesh, vertex_points(mesh, np), sphere_map, loop);
    const std::vector<int> segment = segments_of(loop, std::move(surface), read_stretch(), method);
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

} // namespace internal

/// Segmentation (part decomposition) of a mesh by its stretch: cuts limbs off. Every segment is connected; their
/// numbers are 0 ... n-1 in the order of their first faces.
///
/// Deterministic. Scaling and rotating the mesh and rotating the sphere change nothing, but where decisions hang on
/// rounding; nor does another numbering, but where the shape leaves a choice, as symmetric ones do.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value of any length but 0
/// \param stretch_map readable, key face_descriptor, value double: what `face_log_area_stretch()` has written. Faces
///                    with less than 1e-36 of the sphere, and flipped ones, count as if they had 1e-36: doubles resolve
///                    nothing smaller near length 1, so that limbs that are too thin end in a plateau.
/// \param segment_map writable, key face_descriptor, value constructible from std::size_t
/// \param method      `Majority_vote`, `Girth_profiles` or `Region_growing`
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the number of segments, or what is wrong with the mesh or the maps
/// \pre the options of the method are in their ranges
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceStretchMap, class FaceSegmentMap,
          class Method = Majority_vote, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          internal::If_policy<ExecutionPolicy> = 0
#endif
          >
Segmentation_result segmentation_from_area_stretch(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                                   VertexSphereMap sphere_map, FaceStretchMap stretch_map,
                                                   FaceSegmentMap segment_map, const Method& method = Method(),
                                                   const NamedParameters& np = parameters::default_values())
{
  const auto read_stretch = [&] {
    std::vector<double> stretch;
    for(auto f : faces(mesh))
      stretch.push_back(get(stretch_map, f));
    return stretch;
  };
  return internal::segment(internal::host_loop(policy), mesh, sphere_map, read_stretch, segment_map, method, np);
}

/// \overload
/// On one core.
template <class TriangleMesh, class VertexSphereMap, class FaceStretchMap, class FaceSegmentMap,
          class Method = Majority_vote, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          internal::If_no_policy<TriangleMesh> = 0
#endif
          >
Segmentation_result segmentation_from_area_stretch(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                                   FaceStretchMap stretch_map, FaceSegmentMap segment_map,
                                                   const Method& method = Method(),
                                                   const NamedParameters& np = parameters::default_values())
{
  return segmentation_from_area_stretch(CGAL::Sequential_tag(), mesh, sphere_map, stretch_map, segment_map, method, np);
}

/// Segmentation (part decomposition) of a mesh by its map: measures the stretch and cuts, in one call.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; the map need not be valid
/// \param segment_map writable, key face_descriptor, value constructible from std::size_t
/// \param method      `Majority_vote`, `Girth_profiles` or `Region_growing`
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the number of segments, or what is wrong with the mesh or the map
/// \pre the options of the method are in their ranges
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceSegmentMap,
          class Method = Majority_vote, class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          internal::If_policy<ExecutionPolicy> = 0
#endif
          >
Segmentation_result segmentation_via_area_stretch(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                                  VertexSphereMap sphere_map, FaceSegmentMap segment_map,
                                                  const Method& method = Method(),
                                                  const NamedParameters& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  const auto measure_stretch = [&] {
    const auto stretch =
      internal::make_face_measures(mesh, sphere_map, np, loop).values(loop, [](const auto& measures, int f) {
        return measures.log_area_stretch(f);
      });
    return std::vector<double>(stretch.begin(), stretch.end());
  };
  return internal::segment(loop, mesh, sphere_map, measure_stretch, segment_map, method, np);
}

/// \overload
/// On one core.
template <class TriangleMesh, class VertexSphereMap, class FaceSegmentMap, class Method = Majority_vote,
          class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
          ,
          internal::If_no_policy<TriangleMesh> = 0
#endif
          >
Segmentation_result segmentation_via_area_stretch(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                                  FaceSegmentMap segment_map, const Method& method = Method(),
                                                  const NamedParameters& np = parameters::default_values())
{
  return segmentation_via_area_stretch(CGAL::Sequential_tag(), mesh, sphere_map, segment_map, method, np);
}

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/segmentation/segments_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SEGMENTATION_H
