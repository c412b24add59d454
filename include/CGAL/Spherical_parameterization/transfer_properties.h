// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_PROPERTIES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_PROPERTIES_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/locate.h>

#include <CGAL/tags.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

namespace internal {

template <class Value, class = void>
struct Is_linear : std::false_type {};
template <class Value>
struct Is_linear<Value, std::void_t<decltype(1. * std::declval<const Value&>() + 1. * std::declval<const Value&>())>>
  : std::true_type {};

/// Between the least and the largest of them, whatever the rounding: what is constant stays so, and nothing overflows.
template <class Number>
Number weighted_mean_of_numbers(const std::array<double, 3>& w, Number x0, Number x1, Number x2)
{
  const auto [least, largest] = std::minmax({x0, x1, x2});
  return std::clamp<Number>(w[0] * x0 + w[1] * x1 + w[2] * x2, least, largest);
}

template <class Value>
struct Is_array_of_three : std::false_type {};
template <class Number>
struct Is_array_of_three<std::array<Number, 3>> : std::true_type {};

/// w_0 x_0 + w_1 x_1 + w_2 x_2 of numbers, vectors of any library, or points (which CGAL does not add up).
template <class Value>
Value weighted_mean(const std::array<double, 3>& w, const Value& x0, const Value& x1, const Value& x2)
{
  if constexpr(std::is_arithmetic<Value>::value)
    return static_cast<Value>(weighted_mean_of_numbers<std::common_type_t<double, Value>>(w, x0, x1, x2));
  else if constexpr(Is_linear<Value>::value)
    return static_cast<Value>(w[0] * x0 + w[1] * x1 + w[2] * x2);
  else {
    const vec3 a = coordinates(x0), b = coordinates(x1), c = coordinates(x2);
    const vec3 p = {weighted_mean_of_numbers(w, a.x, b.x, c.x), weighted_mean_of_numbers(w, a.y, b.y, c.y),
                    weighted_mean_of_numbers(w, a.z, b.z, c.z)};
    if constexpr(Is_array_of_three<Value>::value) {
      typedef typename Value::value_type Number;
      return {static_cast<Number>(p.x), static_cast<Number>(p.y), static_cast<Number>(p.z)};
    } else
      return Value(p.x, p.y, p.z);
  }
}

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

/// Carries data of vertices from one mesh to another (or to another map of the same mesh): every vertex gets the value
/// that `from` has under its image.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param from        the inverse of the map of the mesh that has the data
/// \param from_map    readable, key vertex_descriptor of that mesh; see `interpolate()`
/// \param to          the mesh that gets the data, a model of `VertexListGraph`
/// \param to_sphere   readable, key vertex_descriptor of `to`; a map in the same position as that of `from` (see
///                    `align_maps.h`)
/// \param to_map      writable, key vertex_descriptor of `to`
/// \throws Error  `NON_FINITE_COORDINATE` at an image that is no direction, before anything is written
///
/// Complexity: one query (`Spherical_locator::locate()`) for each vertex of `to`.
template <class ExecutionPolicy, class FromMesh, class FromMap, class ToMesh, class ToSphereMap, class ToMap>
void transfer_vertex_property(const ExecutionPolicy& policy, const Spherical_locator<FromMesh>& from, FromMap from_map,
                              const ToMesh& to, ToSphereMap to_sphere, ToMap to_map)
{
  const auto place =
    internal::locate_all(internal::host_loop(policy), from, internal::vectors_at(vertices(to), to_sphere));
  std::size_t i = 0;
  for(auto v : vertices(to))
    put(to_map, v, interpolate(from.mesh(), place[i++], from_map));
}

/// \overload
/// \param from,from_map,to,to_sphere,to_map as above; on one core
template <class FromMesh, class FromMap, class ToMesh, class ToSphereMap, class ToMap>
void transfer_vertex_property(const Spherical_locator<FromMesh>& from, FromMap from_map, const ToMesh& to,
                              ToSphereMap to_sphere, ToMap to_map)
{
  transfer_vertex_property(CGAL::Sequential_tag(), from, from_map, to, to_sphere, to_map);
}

/// Carries data of faces, such as labels: every face gets the value of the face of `from` under its centre.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param from        the inverse of the map of the mesh that has the data
/// \param from_map    readable, key face_descriptor of the mesh that has the data
/// \param to          the mesh that gets the data, a triangle mesh and a model of `FaceListGraph`
/// \param to_sphere   readable, key vertex_descriptor of `to`; a map in the same position as that of `from`
/// \param to_map      writable, key face_descriptor of `to`
/// \throws Error  `NON_FINITE_COORDINATE` at a centre that is no direction, before anything is written
///
/// Complexity: one query for each face of `to`.
template <class ExecutionPolicy, class FromMesh, class FromMap, class ToMesh, class ToSphereMap, class ToMap>
void transfer_face_property(const ExecutionPolicy& policy, const Spherical_locator<FromMesh>& from, FromMap from_map,
                            const ToMesh& to, ToSphereMap to_sphere, ToMap to_map)
{
  const auto loop = internal::host_loop(policy);
  const internal::Mapped_surface map = internal::read_map(to, to_sphere, internal::Reading::UNCHECKED, loop);
  internal::Host_array<internal::vec3> centre;
  for(int f = 0; f < map.number_of_faces(); ++f) {
    const auto corner = map.on_sphere(f);
    centre.push_back(internal::add(corner[0], internal::add(corner[1], corner[2])));
  }
  const auto place = internal::locate_all(loop, from, centre);
  std::size_t i = 0;
  for(auto f : faces(to))
    put(to_map, f, get(from_map, place[i++].first));
}

/// \overload
/// \param from,from_map,to,to_sphere,to_map as above; on one core
template <class FromMesh, class FromMap, class ToMesh, class ToSphereMap, class ToMap>
void transfer_face_property(const Spherical_locator<FromMesh>& from, FromMap from_map, const ToMesh& to,
                            ToSphereMap to_sphere, ToMap to_map)
{
  transfer_face_property(CGAL::Sequential_tag(), from, from_map, to, to_sphere, to_map);
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TRANSFER_PROPERTIES_H
