// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_PROPERTIES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_PROPERTIES_H

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/locate/weighted_mean.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/locate.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

namespace internal {

/// Queries are independent of each other.
template <class Loop, class TriangleMesh>
std::vector<Face_location<TriangleMesh>> locate_all(const Loop& loop, const Spherical_locator<TriangleMesh>& locator,
                                                    const Host_array<vec3>& directions)
{
  constexpr int queries = 256; // on a thread at a time
  std::vector<Face_location<TriangleMesh>> result(directions.size());
  for_each_part<queries>(loop, static_cast<int>(directions.size()), [&](int begin, int end) {
    for(int i = begin; i < end; ++i)
      result[i] = locator.locate(directions[i]);
  });
  return result;
}

/// Where the centres of the faces of another map are.
template <class Loop, class TriangleMesh, class ToMesh, class ToSphereMap>
std::vector<Face_location<TriangleMesh>> locate_centres(const Loop& loop,
                                                        const Spherical_locator<TriangleMesh>& locator,
                                                        const ToMesh& to, ToSphereMap to_sphere)
{
  const Mapped_surface map = read_map(to, to_sphere, Reading::UNCHECKED, loop);
  Host_array<vec3> centre;
  for(int f = 0; f < map.number_of_faces(); ++f) {
    const auto corner = map.of_image(f);
    centre.push_back(add(corner[0], add(corner[1], corner[2])));
  }
  return locate_all(loop, locator, centre);
}

} // namespace internal

/// The value at a point of the mesh, interpolated linearly between the vertices.
/// \param mesh        a triangle mesh, a model of `FaceGraph`
/// \param location    a face of it, and the weights of its corners
/// \param vertex_map  readable, key vertex_descriptor; value a number, a vector that can be multiplied by a double
///                    and added, or a point or vector with x(), y(), z(), or `std::array` of three numbers
/// \return the weighted mean of the values at the corners: numbers in their range, points in their bounding box
template <class TriangleMesh, class VertexMap>
typename boost::property_traits<VertexMap>::value_type
interpolate(const TriangleMesh& mesh, const Face_location<TriangleMesh>& location, VertexMap vertex_map)
{
  const auto h = halfedge(location.first, mesh);
  typedef typename boost::property_traits<VertexMap>::value_type Value;
  return internal::weighted_mean<Value>(location.second, get(vertex_map, source(h, mesh)),
                                        get(vertex_map, target(h, mesh)), get(vertex_map, target(next(h, mesh), mesh)));
}

/// Transfers data of vertices from one mesh to another (or to another map of the same mesh): every vertex gets the
/// value that `from` has at its image.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param from        the inverse of the map of the mesh that has the data
/// \param from_map    readable, key vertex_descriptor of that mesh; see `interpolate()`
/// \param to          the mesh that gets the data, a model of `VertexListGraph`
/// \param to_sphere   readable, key vertex_descriptor of `to`; a map in the same position as that of `from` (see
///                    `align_maps.h`)
/// \param to_map      writable, key vertex_descriptor of `to`
/// \throws Error  `NON_FINITE_COORDINATE` if an image is not a direction, before anything is written
///
/// Complexity: one query (`Spherical_locator::locate()`) for each vertex of `to`.
template <class ExecutionPolicy, class FromMesh, class FromMap, class ToMesh, class ToSphereMap, class ToMap,
          internal::If_policy<ExecutionPolicy> = 0>
void transfer_vertex_property(const ExecutionPolicy& policy, const Spherical_locator<FromMesh>& from, FromMap from_map,
                              const ToMesh& to, ToSphereMap to_sphere, ToMap to_map)
{
  const auto place =
    internal::locate_all(internal::host_loop(policy), from, internal::vectors_at(vertices(to), to_sphere));
  std::size_t i = 0;
  for(auto v : vertices(to))
    put(to_map, v, interpolate(from.mesh(), place[i++], from_map));
}
CGAL_SP_ON_ONE_CORE(transfer_vertex_property)

/// Transfers data of faces, such as labels: every face gets the value of the face of `from` at its centre.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param from        the inverse of the map of the mesh that has the data
/// \param from_map    readable, key face_descriptor of the mesh that has the data
/// \param to          the mesh that gets the data, a triangle mesh and a model of `FaceListGraph`
/// \param to_sphere   readable, key vertex_descriptor of `to`; a map in the same position as that of `from`
/// \param to_map      writable, key face_descriptor of `to`
/// \throws Error  `NON_FINITE_COORDINATE` if a centre is not a direction, before anything is written
///
/// Complexity: one query for each face of `to`.
template <class ExecutionPolicy, class FromMesh, class FromMap, class ToMesh, class ToSphereMap, class ToMap,
          internal::If_policy<ExecutionPolicy> = 0>
void transfer_face_property(const ExecutionPolicy& policy, const Spherical_locator<FromMesh>& from, FromMap from_map,
                            const ToMesh& to, ToSphereMap to_sphere, ToMap to_map)
{
  const auto place = internal::locate_centres(internal::host_loop(policy), from, to, to_sphere);
  std::size_t i = 0;
  for(auto f : faces(to))
    put(to_map, f, get(from_map, place[i++].first));
}
CGAL_SP_ON_ONE_CORE(transfer_face_property)

/// Gives the segments of a mesh the labels of the corresponding segments of another one, so that shapes are labelled
/// consistently: every segment gets the label that the largest share of its area has there. It keeps its boundary,
/// which is more precise than a correspondence between different shapes.
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param from        the inverse of the map of the mesh that has the labels
/// \param from_labels readable, key face_descriptor of that mesh; values can be compared
/// \param to          the mesh that gets the labels, a triangle mesh and a model of `FaceListGraph`
/// \param to_sphere   readable, key vertex_descriptor of `to`; a map in the same position as that of `from`, such as a
///                    registered one (`register_maps()`)
/// \param to_segments readable, key face_descriptor of `to`: its segments (`segmentation_via_area_stretch()`); values
///                    can be compared
/// \param to_labels   writable, key face_descriptor of `to`; may be `to_segments`
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \throws Error  `NON_FINITE_COORDINATE` if a centre is not a direction, before anything is written
///
/// Complexity: one query for each face of `to`.
template <class ExecutionPolicy, class FromMesh, class FromMap, class ToMesh, class ToSphereMap, class ToSegmentMap,
          class ToMap, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
void transfer_segment_labels(const ExecutionPolicy& policy, const Spherical_locator<FromMesh>& from,
                             FromMap from_labels, const ToMesh& to, ToSphereMap to_sphere, ToSegmentMap to_segments,
                             ToMap to_labels, const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename boost::property_traits<FromMap>::value_type Label;
  typedef typename boost::property_traits<ToSegmentMap>::value_type Segment;
  const auto loop = internal::host_loop(policy);
  const auto place = internal::locate_centres(loop, from, to, to_sphere);
  internal::Vertices<ToMesh> vertex;
  const internal::Surface surface =
    internal::read_surface(to, internal::vertex_points(to, np), internal::Reading::UNCHECKED, loop, vertex);
  const auto& area = surface.face_area(loop);
  std::map<Segment, std::map<Label, double>> areas;
  std::size_t i = 0;
  for(auto f : faces(to)) {
    areas[get(to_segments, f)][get(from_labels, place[i].first)] += area[i];
    ++i;
  }
  for(auto f : faces(to)) {
    const auto& of_segment = areas.at(get(to_segments, f));
    put(to_labels, f, std::max_element(of_segment.begin(), of_segment.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first);
  }
}
CGAL_SP_ON_ONE_CORE(transfer_segment_labels)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_PROPERTIES_H
