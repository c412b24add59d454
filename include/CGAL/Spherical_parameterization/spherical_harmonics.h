// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_SPHERICAL_HARMONICS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_SPHERICAL_HARMONICS_H

#include <CGAL/Spherical_parameterization/values/Harmonic_analysis.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/analysis.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Spherical_parameterization {

namespace internal {

/// The values of a vertex map, numbers or vectors, as one or three fields.
template <class TriangleMesh, class VertexMap>
Sampled_fields read_fields(const TriangleMesh& mesh, VertexMap map)
{
  if constexpr(std::is_arithmetic_v<typename boost::property_traits<VertexMap>::value_type>) {
    Sampled_fields result = {1, {}};
    for(auto v : vertices(mesh))
      result.value.push_back(static_cast<double>(get(map, v)));
    return result;
  } else
    return coordinate_fields(vectors_at(vertices(mesh), map));
}

} // namespace internal

/// \addtogroup PkgSphericalParameterizationHarmonics
/// @{

/// Analysis of data at the vertices in spherical harmonics: the coefficients of the function on the sphere that has the
/// values of the data at the images of the vertices. For a shape (SPHARM; C. Brechbuehler, G. Gerig, O. Kuebler,
/// "Parametrization of closed surfaces for 3-D shape description", 1995) these are three functions, the coordinates.
///
/// \param policy      `CGAL::Sequential_tag`, the default, or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors: a valid map. Maps of low isometric
/// distortion
///                    (`Isometric`) need fewer degrees than conformal ones, which give limbs a tiny part of the sphere.
/// \param vertex_map  readable, key vertex_descriptor; value a number, or a point or vector of three coordinates
/// \param degree      of the coefficients, 0 to `largest_harmonic_degree`
/// \param method      `Least_squares` or `Integration`
/// \param np          optional named parameters: `vertex_point_map`, by default the mesh's own, for
///                    `Vertex_weights::SURFACE_AREA`; `callback` and `maximum_running_time`, as in `parameterize()`
/// \return the coefficients of one or of three functions, and whether least squares converged
/// \throws Error  `NON_FINITE_COORDINATE` for an image that is not a direction, or a value that is not finite;
///                `NOT_BIJECTIVE` for a map with flipped faces or a degree other than 1; `DEGENERATE_FACE` if all
///                weights are 0; `INTERRUPTED`
/// \pre for `Least_squares` there are (degree + 1)^2 vertices or more, and the degree is at most 8191
///
/// Complexity: O(n) and O(L^3) for every iteration, or O(L^3) and the number of quadrature points for integrals.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class VertexMap,
          class Method = Least_squares, class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Harmonic_analysis harmonic_analysis(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                    VertexMap vertex_map, int degree, const Method& method = Method(),
                                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  static_cast<void>(Harmonic_coefficients(degree, 0)); // checks it
  internal::Monitor monitor = internal::make_monitor(np);
  const internal::Watched_loop loop(internal::host_loop(policy), monitor);
  constexpr internal::Reading reading = internal::Reading::CHECKED;
  return internal::analyze_vertices(
    loop,
    internal::needs_points(method)
      ? internal::read_map(mesh, internal::vertex_points(mesh, np), sphere_map, reading, loop.bare())
      : internal::read_map(mesh, sphere_map, reading, loop.bare()),
    internal::read_fields(mesh, vertex_map), degree, method);
}
CGAL_SP_ON_ONE_CORE(harmonic_analysis)

/// The values of the functions at directions, to 1e-12 of the root of their power.
/// \param coefficients  of the functions
/// \param directions    a range of vectors of any length but 0: with x(), y(), z() or operator[]
/// \param policy,np  see \ref pd_calls
/// \return for each direction the values of all functions
/// \throws Error  `NON_FINITE_COORDINATE` if a direction or a coefficient is not finite, or a direction is zero;
///                `INTERRUPTED`
///
/// Complexity: O(L^3 + n).
template <class ExecutionPolicy, class DirectionRange, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
std::vector<double> harmonic_values(const ExecutionPolicy& policy, const Harmonic_coefficients& coefficients,
                                    const DirectionRange& directions,
                                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  internal::Host_array<internal::vec3> direction = internal::vectors_of(directions);
  internal::check_finite(coefficients);
  internal::check_directions(direction);
  internal::Monitor monitor = internal::make_monitor(np);
  const auto value =
    internal::evaluate_harmonics(internal::Watched_loop(internal::host_loop(policy), monitor), coefficients, direction);
  return std::vector<double>(value.begin(), value.end());
}
CGAL_SP_ON_ONE_CORE(harmonic_values)

/// Synthesis: gives every vertex the value at its image. With the mesh and the map of the analysis the result is a
/// reconstruction; with an icosphere (`make_icosphere()`) every shape gets the same vertices and faces.
/// \param coefficients  of one function if the values are numbers, of three if they are points
/// \param mesh          a model of `VertexListGraph`
/// \param sphere_map    readable, key vertex_descriptor, value vectors of any length but 0
/// \param vertex_map    writable, key vertex_descriptor; value a number, or constructible from three numbers
/// \param policy,np  see \ref pd_calls
/// \throws Error  as `harmonic_values()`, before anything is written
/// \pre there are as many functions as the values have coordinates
///
/// Complexity: O(L^3 + n).
template <class ExecutionPolicy, class Mesh, class VertexSphereMap, class VertexMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_policy<ExecutionPolicy> = 0>
void harmonic_synthesis(const ExecutionPolicy& policy, const Harmonic_coefficients& coefficients, const Mesh& mesh,
                        VertexSphereMap sphere_map, VertexMap vertex_map,
                        const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename boost::property_traits<VertexMap>::value_type Value;
  constexpr int fields = std::is_arithmetic_v<Value> ? 1 : 3;
  CGAL_SP_PRECONDITION(coefficients.number_of_fields() == fields,
                       "numbers are synthesized from one function, points from three");
  const std::vector<double> value =
    harmonic_values(policy, coefficients, internal::vectors_at(vertices(mesh), sphere_map), np);
  const double* x = value.data();
  for(auto v : vertices(mesh)) {
    if constexpr(fields == 1)
      put(vertex_map, v, internal::stored_number<Value>(*x));
    else
      put(vertex_map, v, internal::stored_point<Value>({x[0], x[1], x[2]}));
    x += fields;
  }
}
CGAL_SP_ON_ONE_CORE(harmonic_synthesis)

/// The error of a reconstructed shape.
struct Reconstruction_error {
  double root_mean_square; ///< of the distances between corresponding vertices
  double relative;         ///< the same over the root mean square distance of the vertices from their mean
  double largest;          ///< of the distances; the Hausdorff distance of the two surfaces is not larger
};

/// Compares two positions of the vertices of a mesh.
/// \param mesh    a model of `VertexListGraph`
/// \param points  readable, key vertex_descriptor: the shape
/// \param others  readable, key vertex_descriptor: the reconstruction
/// \return the error; 0 for a mesh without vertices
template <class Mesh, class PointMap, class OtherPointMap>
Reconstruction_error reconstruction_error(const Mesh& mesh, PointMap points, OtherPointMap others)
{
  auto p = internal::vectors_at(vertices(mesh), points), q = internal::vectors_at(vertices(mesh), others);
  double largest_coordinate = 0;
  for(const auto* shape : {&p, &q})
    for(const internal::vec3& x : *shape)
      largest_coordinate = (std::max)({largest_coordinate, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  const int exponent = largest_coordinate > 0 ? std::ilogb(largest_coordinate) : 0;
  for(auto* shape : {&p, &q}) // squares neither overflow nor vanish then
    for(internal::vec3& x : *shape)
      x = {std::ldexp(x.x, -exponent), std::ldexp(x.y, -exponent), std::ldexp(x.z, -exponent)};
  const double n = static_cast<double>(p.size());
  internal::vec3 mean = {0, 0, 0};
  for(const internal::vec3& x : p)
    mean = internal::add_scaled(mean, 1 / n, x);
  double error = 0, size = 0, largest = 0;
  for(std::size_t i = 0; i < p.size(); ++i) {
    const internal::vec3 difference = internal::sub(p[i], q[i]), from_mean = internal::sub(p[i], mean);
    const double square = internal::inner(difference, difference);
    error += square / n;
    size += internal::inner(from_mean, from_mean) / n;
    largest = (std::max)(largest, square);
  }
  return {std::ldexp(std::sqrt(error), exponent), size > 0 ? std::sqrt(error / size) : 0,
          std::ldexp(std::sqrt(largest), exponent)};
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_SPHERICAL_HARMONICS_H
