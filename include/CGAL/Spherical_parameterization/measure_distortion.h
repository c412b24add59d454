// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H

#include <CGAL/Spherical_parameterization/internal/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/spherical_triangles.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {

namespace internal {

/// The images of the corners of face f, in the order of its halfedges.
template <class TriangleMesh, class VertexMap>
std::array<vec3, 3> corners(const TriangleMesh& mesh, VertexMap map,
                            typename boost::graph_traits<TriangleMesh>::face_descriptor f)
{
  const auto h = halfedge(f, mesh);
  return {coordinates(get(map, source(h, mesh))), coordinates(get(map, target(h, mesh))),
          coordinates(get(map, target(next(h, mesh), mesh)))};
}

} // namespace internal

/// Number of faces (a, b, c) with orientation(O, a, b, c) <= 0, by exact predicates on the coordinates as doubles.
/// A map without such faces and of degree 1 is bijective.
/// \param sphere_map  readable, key vertex_descriptor; need not be normalised
template <class TriangleMesh, class VertexSphereMap>
std::size_t number_of_flipped_faces(const TriangleMesh& mesh, VertexSphereMap sphere_map)
{
  std::size_t flipped = 0;
  for(auto f : faces(mesh)) {
    const auto c = internal::corners(mesh, sphere_map, f);
    if(!internal::is_finite(c[0]) || !internal::is_finite(c[1]) || !internal::is_finite(c[2]) ||
       !internal::is_positively_oriented(c[0], c[1], c[2]))
      ++flipped;
  }
  return flipped;
}

/// How often the map covers the sphere, counted with orientation: the sum of the signed spherical areas over 4 pi.
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
template <class TriangleMesh, class VertexSphereMap>
int degree_of_map(const TriangleMesh& mesh, VertexSphereMap sphere_map)
{
  double total = 0;
  for(auto f : faces(mesh)) {
    const auto c = internal::corners(mesh, sphere_map, f);
    total += internal::spherical_area(c[0], c[1], c[2]);
  }
  return static_cast<int>(std::lround(total / (4 * std::acos(-1.))));
}

/// The area stretch of Definition 1 of T. Athanasiadis and I. Fudos, SMI 2011, as a natural logarithm: for every vertex
/// the mean over its faces of log((source area / total source area) / (spherical area / 4 pi)). Positive where the map
/// shrinks, as in limbs, where it reaches 60 and more. Areas below 1e-300 of the total count as that.
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \param stretch_map writable, key vertex_descriptor, value double
/// \param np          `vertex_point_map`
/// \return the smallest and the largest value
template <class TriangleMesh, class VertexSphereMap, class VertexStretchMap,
          class NamedParameters = parameters::Default_named_parameters>
std::pair<double, double> log_area_stretch(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                           VertexStretchMap stretch_map,
                                           const NamedParameters& np = parameters::default_values())
{
  const auto points = internal::vertex_points(mesh, np);
  constexpr double floor = 1e-300;
  const auto source_area = [&](auto f) {
    const auto p = internal::corners(mesh, points, f);
    const internal::vec3 n = internal::outer(internal::sub(p[1], p[0]), internal::sub(p[2], p[0]));
    return std::sqrt(internal::inner(n, n)) / 2;
  };
  double total = 0;
  for(auto f : faces(mesh))
    total += source_area(f);

  std::pair<double, double> range(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for(auto v : vertices(mesh)) {
    double sum = 0;
    int count = 0;
    for(auto h : halfedges_around_target(halfedge(v, mesh), mesh)) {
      const auto f = face(h, mesh);
      const auto c = internal::corners(mesh, sphere_map, f);
      const double share = internal::spherical_area(c[0], c[1], c[2]) / (4 * std::acos(-1.));
      sum += std::log((std::max)(source_area(f) / total, floor)) - std::log((std::max)(share, floor));
      ++count;
    }
    const double stretch = sum / count;
    put(stretch_map, v, stretch);
    range.first = (std::min)(range.first, stretch);
    range.second = (std::max)(range.second, stretch);
  }
  return range;
}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
