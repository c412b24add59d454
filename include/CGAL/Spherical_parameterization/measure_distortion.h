// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMeasures
/// @{

namespace internal {

/// Writes the values of a range in its order; returns the smallest and the largest one.
template <class Range, class Values, class Map>
std::pair<double, double> put_values(const Range& range, const Values& values, Map map)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::pair<double, double> result(infinity, -infinity);
  auto value = values.begin();
  for(auto k : range) {
    put(map, k, *value);
    result = {(std::min)(result.first, *value), (std::max)(result.second, *value)};
    ++value;
  }
  return result;
}

template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceMap, class NamedParameters,
          class Measure>
std::pair<double, double> measure_faces(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                        VertexSphereMap sphere_map, FaceMap face_map, const NamedParameters& np,
                                        Measure measure)
{
  const auto loop = host_loop(policy);
  const Mapped_surface map = read_map(mesh, vertex_points(mesh, np), sphere_map, Reading::UNCHECKED, loop);
  return put_values(faces(mesh), Face_measures(map, loop).values(loop, measure), face_map);
}

} // namespace internal

/// The certificate of a map: `number_of_flipped_faces()` and `degree_of_map()` at once.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor; need not be normalized
/// \return both, in this order: 0 and 1 for a valid map
///
/// Complexity: linear.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, internal::If_policy<ExecutionPolicy> = 0>
std::pair<std::size_t, int> certify_map(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                        VertexSphereMap sphere_map)
{
  const auto loop = internal::host_loop(policy);
  const auto certificate = internal::read_map(mesh, sphere_map, internal::Reading::UNCHECKED, loop).certificate(loop);
  return {certificate.flipped_faces, certificate.degree};
}
CGAL_SP_ON_ONE_CORE(certify_map)

/// Number of flipped faces: faces (a, b, c) with orientation(O, a, b, c) <= 0, by exact predicates on the coordinates
/// as doubles. A map without such faces and of degree 1 is bijective.
/// \param policy,mesh,sphere_map  as for `certify_map()`
/// \return the number of faces that are flipped, degenerate, or not finite
///
/// Complexity: linear.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, internal::If_policy<ExecutionPolicy> = 0>
std::size_t number_of_flipped_faces(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map)
{
  return certify_map(policy, mesh, sphere_map).first;
}
CGAL_SP_ON_ONE_CORE(number_of_flipped_faces)

/// The degree of the map: how often it covers the sphere, counted with orientation, by exact predicates on the
/// coordinates as doubles. Faces with coordinates that are not finite are ignored.
/// \param policy,mesh,sphere_map  as for `certify_map()`
/// \return the degree: 1 for a valid map, -1 for a mirrored map
///
/// Complexity: linear.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, internal::If_policy<ExecutionPolicy> = 0>
int degree_of_map(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map)
{
  return certify_map(policy, mesh, sphere_map).second;
}
CGAL_SP_ON_ONE_CORE(degree_of_map)

/// \name Measures per face
/// Each writes one value per face and returns the smallest and the largest value. All are linear in the mesh size.
/// @{

/// The area distortion of faces, the area stretch of Definition 1 of the paper (Athanasiadis and Fudos, SMI
/// 2011), as a natural logarithm: log((source area / total source area) / (spherical area / 4 pi)). It is
/// positive where the map shrinks; in limbs it reaches 60 and more. Areas below 1e-300 of the total are taken as
/// that.
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a valid map
/// \param face_map    writable, key face_descriptor, value double
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own
/// \return the smallest and the largest value
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceMap,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
std::pair<double, double> face_log_area_stretch(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                                VertexSphereMap sphere_map, FaceMap face_map,
                                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measure_faces(policy, mesh, sphere_map, face_map, np, &internal::Face_measures::log_area_stretch);
}
CGAL_SP_ON_ONE_CORE(face_log_area_stretch)

/// The angle distortion of faces, 0 for a conformal map: the mean over the three corners of |angle between the great
/// circles - angle in the source|, in radians, in [0, pi).
/// \param policy,mesh,sphere_map,face_map,np  as for `face_log_area_stretch()`
/// \return the smallest and the largest value
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceMap,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
std::pair<double, double> face_angle_distortion(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                                VertexSphereMap sphere_map, FaceMap face_map,
                                                const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measure_faces(policy, mesh, sphere_map, face_map, np, &internal::Face_measures::angle_distortion);
}
CGAL_SP_ON_ONE_CORE(face_angle_distortion)

/// The quasi-conformal distortion (dilatation, shear) of faces, sigma_1 / sigma_2 >= 1 of the affine map between the
/// flat triangles; 1 where it is conformal, infinite for faces of area 0.
/// \param policy,mesh,sphere_map,face_map,np  as for `face_log_area_stretch()`
/// \return the smallest and the largest value
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceMap,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
std::pair<double, double> face_dilatation(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                          VertexSphereMap sphere_map, FaceMap face_map,
                                          const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measure_faces(policy, mesh, sphere_map, face_map, np, &internal::Face_measures::dilatation);
}
CGAL_SP_ON_ONE_CORE(face_dilatation)

/// The symmetric Dirichlet energy sigma_1^2 + sigma_2^2 + 1/sigma_1^2 + 1/sigma_2^2 >= 4 of the affine map between the
/// flat triangles, both surfaces scaled to the same area; 4 where it is isometric, infinite for faces of area 0. J.
/// Smith and S. Schaefer, "Bijective parameterization with free boundaries", SIGGRAPH 2015.
/// \param policy,mesh,sphere_map,face_map,np  as for `face_log_area_stretch()`
/// \return the smallest and the largest value
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class FaceMap,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
std::pair<double, double> face_symmetric_dirichlet(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                                   VertexSphereMap sphere_map, FaceMap face_map,
                                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  return internal::measure_faces(policy, mesh, sphere_map, face_map, np,
                                 &internal::Face_measures::flat_symmetric_dirichlet);
}
CGAL_SP_ON_ONE_CORE(face_symmetric_dirichlet)

/// @}
/// \name Measures per vertex
/// @{

/// Measure of vertices from a measure of faces: means over the faces of a vertex, as in Definition 1 of the paper.
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param face_map    readable, key face_descriptor, value double
/// \param vertex_map  writable, key vertex_descriptor, value double
/// \return the smallest and the largest value
/// \throws Error  for what is no closed, connected triangle mesh of genus 0
template <class TriangleMesh, class FaceMap, class VertexMap>
std::pair<double, double> mean_over_faces(const TriangleMesh& mesh, FaceMap face_map, VertexMap vertex_map)
{
  std::vector<double> values;
  for(auto f : faces(mesh))
    values.push_back(get(face_map, f));
  const internal::Host_loop loop;
  internal::Vertices<TriangleMesh> vertex;
  const internal::Surface surface = internal::read_faces(mesh, internal::Reading::CHECKED, loop, vertex);
  return internal::put_values(vertex, internal::means_over_faces(loop, surface, values), vertex_map);
}

/// The area distortion of Definition 1 of the paper, the logarithmic area stretch of vertices: for every vertex the
/// mean of `face_log_area_stretch()`.
/// \param policy,mesh,sphere_map,np  as for `face_log_area_stretch()`
/// \param stretch_map writable, key vertex_descriptor, value double
/// \return the smallest and the largest value
/// \throws Error  for what is no closed, connected triangle mesh of genus 0
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class VertexStretchMap,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
std::pair<double, double> vertex_log_area_stretch(const ExecutionPolicy& policy, const TriangleMesh& mesh,
                                                  VertexSphereMap sphere_map, VertexStretchMap stretch_map,
                                                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  const auto loop = internal::host_loop(policy);
  const internal::Mapped_surface map =
    internal::read_map(mesh, internal::vertex_points(mesh, np), sphere_map, internal::Reading::MEASURED, loop);
  return internal::put_values(vertices(mesh), internal::vertex_stretch(loop, map), stretch_map);
}
CGAL_SP_ON_ONE_CORE(vertex_log_area_stretch)

/// @}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_MEASURE_DISTORTION_H
