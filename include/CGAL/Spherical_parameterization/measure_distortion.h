// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H

#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMeasures
/// @{

namespace internal {

/// Writes value(k) for every k of the range; returns the smallest and the largest value.
template <class Range, class Map, class Value>
std::pair<double, double> put_values(const Range& range, Map map, const Value& value)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> result(infinity, -infinity);
  for(auto k : range) {
    const double x = value(k);
    put(map, k, x);
    result.first = (std::min)(result.first, x);
    result.second = (std::max)(result.second, x);
  }
  return result;
}

} // namespace internal

/// Number of faces (a, b, c) with orientation(O, a, b, c) <= 0, by exact predicates on the coordinates as doubles.
/// A map without such faces and of degree 1 is bijective.
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor; need not be normalised
/// \return the number of faces that are flipped, degenerate, or not finite
///
/// Complexity: linear.
template <class TriangleMesh, class VertexSphereMap>
std::size_t number_of_flipped_faces(const TriangleMesh& mesh, VertexSphereMap sphere_map)
{
  std::size_t flipped = 0;
  for(auto f : faces(mesh)) {
    const auto c = internal::corners(mesh, sphere_map, f);
    if(!internal::is_finite(c[0], c[1], c[2]) || !internal::is_positively_oriented(c[0], c[1], c[2]))
      ++flipped;
  }
  return flipped;
}

/// How often the map covers the sphere, counted with orientation, by exact predicates on the coordinates as doubles.
/// Faces with coordinates that are not finite do not count.
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors
/// \return the degree: 1 for a valid map, -1 for a mirrored one
///
/// Complexity: linear.
template <class TriangleMesh, class VertexSphereMap>
int degree_of_map(const TriangleMesh& mesh, VertexSphereMap sphere_map)
{
  return internal::degree([&](internal::vec3 q) {
    double sum = 0;
    for(auto f : faces(mesh)) {
      const auto c = internal::corners(mesh, sphere_map, f);
      if(internal::is_finite(c[0], c[1], c[2]))
        sum += internal::covering(c[0], c[1], c[2], q);
    }
    return sum;
  });
}

/// \name Measures per face
/// Each writes one value per face and returns the smallest and the largest one. All are linear in the size of the mesh.
/// @{

/// The area stretch of Definition 1 of the paper (Athanasiadis and Fudos, SMI 2011), as a natural logarithm:
/// log((source area / total source area) / (spherical area / 4 pi)). Positive where the map shrinks, as in limbs, where
/// it reaches 60 and more. Areas below 1e-300 of the total count as that.
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a valid map
/// \param face_map    writable, key face_descriptor, value double
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the smallest and the largest value
template <class TriangleMesh, class VertexSphereMap, class FaceMap,
          class NamedParameters = parameters::Default_named_parameters>
std::pair<double, double> face_log_area_stretch(const TriangleMesh& mesh, VertexSphereMap sphere_map, FaceMap face_map,
                                                const NamedParameters& np = parameters::default_values())
{
  const auto measures = internal::make_face_measures(mesh, sphere_map, np);
  return internal::put_values(faces(mesh), face_map, [&](auto f) { return measures.log_area_stretch(f); });
}

/// Mean over the three corners of |angle between the great circles - angle in the source|, in radians, in [0, pi).
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a valid map
/// \param face_map    writable, key face_descriptor, value double
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the smallest and the largest value
template <class TriangleMesh, class VertexSphereMap, class FaceMap,
          class NamedParameters = parameters::Default_named_parameters>
std::pair<double, double> face_angle_distortion(const TriangleMesh& mesh, VertexSphereMap sphere_map, FaceMap face_map,
                                                const NamedParameters& np = parameters::default_values())
{
  const auto measures = internal::make_face_measures(mesh, sphere_map, np);
  return internal::put_values(faces(mesh), face_map, [&](auto f) { return measures.angle_distortion(f); });
}

/// The quasi-conformal dilatation sigma_1 / sigma_2 >= 1 of the affine map between the flat triangles; 1 where it is
/// conformal, infinite for faces without area.
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a valid map
/// \param face_map    writable, key face_descriptor, value double
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the smallest and the largest value
template <class TriangleMesh, class VertexSphereMap, class FaceMap,
          class NamedParameters = parameters::Default_named_parameters>
std::pair<double, double> face_dilatation(const TriangleMesh& mesh, VertexSphereMap sphere_map, FaceMap face_map,
                                          const NamedParameters& np = parameters::default_values())
{
  const auto measures = internal::make_face_measures(mesh, sphere_map, np);
  return internal::put_values(faces(mesh), face_map, [&](auto f) { return measures.dilatation(f); });
}

/// The symmetric Dirichlet energy sigma_1^2 + sigma_2^2 + 1/sigma_1^2 + 1/sigma_2^2 >= 4 of the affine map between the
/// flat triangles, both surfaces scaled to the same area; 4 where it is isometric, infinite for faces without area.
/// J. Smith and S. Schaefer, "Bijective parameterization with free boundaries", SIGGRAPH 2015.
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a valid map
/// \param face_map    writable, key face_descriptor, value double
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the smallest and the largest value
template <class TriangleMesh, class VertexSphereMap, class FaceMap,
          class NamedParameters = parameters::Default_named_parameters>
std::pair<double, double> face_symmetric_dirichlet(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                                   FaceMap face_map,
                                                   const NamedParameters& np = parameters::default_values())
{
  const auto measures = internal::make_face_measures(mesh, sphere_map, np);
  return internal::put_values(faces(mesh), face_map, [&](auto f) { return measures.flat_symmetric_dirichlet(f); });
}

/// @}
/// \name Measures per vertex
/// @{

/// Any measure per face as one per vertex: the mean over the faces of a vertex, as in Definition 1 of the paper.
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param face_map    readable, key face_descriptor, value double
/// \param vertex_map  writable, key vertex_descriptor, value double
/// \return the smallest and the largest value
template <class TriangleMesh, class FaceMap, class VertexMap>
std::pair<double, double> mean_over_faces(const TriangleMesh& mesh, FaceMap face_map, VertexMap vertex_map)
{
  return internal::put_values(vertices(mesh), vertex_map, [&](auto v) {
    double sum = 0;
    int count = 0;
    for(auto h : halfedges_around_target(halfedge(v, mesh), mesh)) {
      sum += get(face_map, face(h, mesh));
      ++count;
    }
    return sum / count;
  });
}

/// The area stretch of Definition 1 itself: for every vertex the mean of `face_log_area_stretch()`.
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a valid map
/// \param stretch_map writable, key vertex_descriptor, value double
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the smallest and the largest value
template <class TriangleMesh, class VertexSphereMap, class VertexStretchMap,
          class NamedParameters = parameters::Default_named_parameters>
std::pair<double, double> log_area_stretch(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                           VertexStretchMap stretch_map,
                                           const NamedParameters& np = parameters::default_values())
{
  const auto measures = internal::make_face_measures(mesh, sphere_map, np);
  typedef typename boost::graph_traits<TriangleMesh>::face_descriptor face_descriptor;
  const auto of_face = [&](face_descriptor f) { return measures.log_area_stretch(f); };
  return mean_over_faces(mesh, boost::make_function_property_map<face_descriptor>(of_face), stretch_map);
}

/// @}

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
