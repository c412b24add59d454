// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Segmentation of a mesh into body and limbs by its spherical parameterization. As with CGAL's SDF values, the measure
// and the cut can be separate calls: face_log_area_stretch() and segmentation_from_area_stretch(). The sphere should be
// conformal (the default of parameterize()): its stretch knows how long and how thin a limb is. It need not be valid:
// tips too thin for doubles, where faces are flipped, do no harm.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SEGMENTATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SEGMENTATION_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/segments.h>
#include <CGAL/Spherical_parameterization/values/segmentation_methods.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationSegmentation
/// @{

/// The result of a segmentation. `segment_map` is written only if there is no error.
struct Segmentation_result {
  Error_code error = Error_code::OK;  ///< what is wrong with the mesh or the map
  std::string detail;                 ///< what and where; empty if `OK`
  std::size_t number_of_segments = 0; ///< 0 if there is an error

  /// \return `true` iff there is no error
  explicit operator bool() const { return error == Error_code::OK; }
};

namespace internal {

/// \param read_stretch  given the map as arrays, returns the stretch of the faces, in their order
template <class TriangleMesh, class VertexSphereMap, class ReadStretch, class FaceSegmentMap, class Method,
          class NamedParameters>
Segmentation_result segment(const Host_loop& loop, const TriangleMesh& mesh, VertexSphereMap sphere_map,
                            ReadStretch read_stretch, FaceSegmentMap segment_map, const Method& method,
                            const NamedParameters& np)
{
  typedef typename boost::property_traits<FaceSegmentMap>::value_type Segment_id;
  CGAL_SP_PRECONDITION(method.minimum_area >= 0 && method.minimum_area <= 1,
                       "the minimum area of segments is a share: 0 to 1");
  if constexpr(std::is_same_v<Method, Region_growing>)
    CGAL_SP_PRECONDITION(method.threshold >= 0, "the threshold of region growing must not be negative");
  Segmentation_result result;
  Monitor monitor = make_monitor(np);
  try {
    Mapped_surface map = read_map(mesh, vertex_points(mesh, np), sphere_map, Reading::BREADTH_FIRST, loop);
    std::vector<double> stretch = read_stretch(map);
    const Watched_loop<Host_loop> watched(loop, monitor);
    watched.advance(0);
    const std::vector<int> segment = segments_of(watched, std::move(map), std::move(stretch), method);
    std::size_t i = 0;
    for(auto f : faces(mesh)) {
      const std::size_t id = static_cast<std::size_t>(segment[i++]);
      put(segment_map, f, static_cast<Segment_id>(id));
      result.number_of_segments = (std::max)(result.number_of_segments, id + 1);
    }
  } catch(const Input_error& error) {
    result.error = error.code();
    result.detail = error.detail();
  }
  return result;
}

} // namespace internal

/// Segmentation (part decomposition) of a mesh by its stretch: cuts limbs off. Every segment is connected. The segments
/// are numbered 0 ... n-1 in the order of their first faces.
///
/// Deterministic. Scaling or rotating the mesh, or rotating the sphere, changes the result only where a decision
/// depends on rounding; another numbering where symmetry, or the sampling of light, leaves a choice.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh of genus 0, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value of any length but 0
/// \param stretch_map readable, key face_descriptor, value double, written by `face_log_area_stretch()`. Faces with
///                    less than 1e-36 of the sphere, and flipped faces, are treated as if they had 1e-36: doubles
///                    resolve nothing smaller near length 1, so limbs that are too thin end in a plateau.
/// \param segment_map writable, key face_descriptor, value constructible from std::size_t
/// \param method      `Majority_vote`, `Girth_profiles` or `Region_growing`
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own; `callback` and
///                    `maximum_running_time`, as in `parameterize()`: the error is `INTERRUPTED` then
/// \return the number of segments, or the error of the mesh or the maps
/// \pre the options of the method are in their ranges
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceStretchMap, class FaceSegmentMap,
          class Method = Majority_vote, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Segmentation_result segmentation_from_area_stretch(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                                   VertexSphereMap sphere_map, FaceStretchMap stretch_map,
                                                   FaceSegmentMap segment_map, const Method& method = Method(),
                                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto read_stretch = [&](const internal::Mapped_surface&) {
    std::vector<double> stretch;
    for(auto f : faces(mesh))
      stretch.push_back(get(stretch_map, f));
    return stretch;
  };
  return internal::segment(internal::host_loop(policy), mesh, sphere_map, read_stretch, segment_map, method, np);
}
CGAL_SP_ON_ONE_CORE(segmentation_from_area_stretch)

/// Segmentation (part decomposition) of a mesh by its map: measures the stretch and segments, in one call.
/// \param policy,mesh,segment_map,method,np  as for `segmentation_from_area_stretch()`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; the map need not be valid
/// \return the number of segments, or the error of the mesh or the map
/// \pre the options of the method are in their ranges
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceSegmentMap,
          class Method = Majority_vote, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Segmentation_result segmentation_via_area_stretch(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                                  VertexSphereMap sphere_map, FaceSegmentMap segment_map,
                                                  const Method& method = Method(),
                                                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  const auto measure_stretch = [&](const internal::Mapped_surface& map) {
    const internal::Face_measures measures(map, loop);
    const auto stretch = measures.values(loop, &internal::Face_measures::log_area_stretch);
    return std::vector<double>(stretch.begin(), stretch.end());
  };
  return internal::segment(loop, mesh, sphere_map, measure_stretch, segment_map, method, np);
}
CGAL_SP_ON_ONE_CORE(segmentation_via_area_stretch)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SEGMENTATION_H
