// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H

#include <CGAL/Spherical_parameterization/Indexed_triangle_mesh.h>
#include <CGAL/Spherical_parameterization/values/Result.h>
#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/driver/arguments.h>
#include <CGAL/Spherical_parameterization/internal/driver/read_problem.h>
#include <CGAL/Spherical_parameterization/internal/driver/solve.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <CGAL/tags.h>

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace CGAL::Spherical_parameterization {

namespace internal {

/// The accuracy and the number of iterations that the named parameters ask for.
template <class NamedParameters>
Effort make_effort(const NamedParameters& np)
{
  Effort effort;
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::accuracy_t>::value) {
    const double accuracy = parameters::get_parameter(np, internal_np::accuracy);
    CGAL_SP_PRECONDITION(accuracy > 0 && accuracy <= (std::numeric_limits<double>::max)(),
                         "the accuracy has to be positive and finite");
    effort.accuracy = accuracy;
  }
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::number_of_iterations_t>::value) {
    const auto number = parameters::get_parameter(np, internal_np::number_of_iterations);
    CGAL_SP_PRECONDITION(!(number < 0), "the number of iterations must not be negative");
    effort.number_of_iterations = static_cast<std::size_t>(number);
  }
  return effort;
}

/// What tells the overloads of parameterize() apart.
template <class TriangleMesh, class Method>
using If_method_for = std::enable_if_t<Is_mesh<TriangleMesh>::value && Is_method<Method>::value, int>;
template <class TriangleMesh, class VertexSphereMap>
using If_map_for = std::enable_if_t<Is_mesh<TriangleMesh>::value && !Is_method<VertexSphereMap>::value, int>;

/// Both front doors lead here: read, solve, write. `with_input(read)` returns `read(mesh, inputs)`.
template <class ExecutionPolicy, class Method, class NamedParameters, class VertexSphereMap, class With_input>
Result run(const ExecutionPolicy& policy, const Method& method, const NamedParameters& np, VertexSphereMap sphere_map,
           With_input with_input)
{
  const Method_solver<Method> solver(method); // checks the options
  const Effort effort = make_effort(np);
  Monitor monitor = make_monitor(np);
  const Stopwatch total;
  Result result;
  if constexpr(is_supported_policy<ExecutionPolicy>())
    try {
      const auto input = with_input([&](const auto& mesh, const auto& inputs) {
        return read_problem<ExecutionPolicy>(mesh, solver, sphere_map, inputs, monitor, result);
      });
      result.seconds.read = total.seconds() - result.seconds.weights;
      monitor.advance(0);
      const Solution solution = solve<Host_loop>(policy, method, input.problem, effort, monitor);
      write_solution(solution, input, sphere_map, result);
      monitor.finish();
    } catch(const Input_error& error) { // of reading
      result.error = error.code();
      result.detail = monitor.is_interrupted() ? monitor.reason_without_map() : error.detail();
      if(monitor.is_interrupted())
        result.termination = monitor.termination();
      result.seconds.read = total.seconds() - result.seconds.weights;
    }
  result.seconds.total = total.seconds();
  return result;
}

} // namespace internal

/// \addtogroup PkgSphericalParameterizationMap
/// @{

/// Maps a closed triangle mesh of genus 0 to the unit sphere.
///
/// The result is certified: if `Result::error` is `OK`, every face is positively oriented as seen from outside by an
/// exact predicate on the coordinates written to `sphere_map`, and the map covers the sphere once. It is then a
/// bijection. Otherwise the error says what is wrong. `sphere_map` is written whenever there is a map (`NOT_CONVERGED`,
/// `INTERRUPTED` and `NOT_BIJECTIVE`: the best one found, if there is one).
///
/// `Result::termination` says why the method ended. It is `CONVERGED` if and only if the residual of the stored map is
/// within the accuracy, or, where `sphere_map` holds floats, within what their rounding leaves. The residual of a valid
/// map may be larger: if vertices were moved to repair faces
/// (`Result::moved_vertices`), or if `Isometric` used up its steps. Calls on different meshes, or on the same mesh with
/// different maps, may run concurrently.
///
/// \tparam ExecutionPolicy  a model of `SphericalParameterizationPolicy`
/// \tparam TriangleMesh     a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Method           a model of `SphericalParameterizationMethod`
/// \tparam VertexSphereMap  a model of `VertexSphereMap`
/// \tparam NamedParameters  a sequence of CGAL's named parameters
/// \param policy  where to run: `CGAL::Sequential_tag`; `CGAL::Parallel_tag`, if linked with TBB (`CGAL::TBB_support`);
///                an `OpenCL_device`, if OpenCL_device.h is included. All policies give the same bits (see
///                `OpenCL_device` for an exception).
/// \param mesh    a closed triangle mesh of genus 0; its own indices are not used
/// \param method  `Balanced`, `Saddle_point`, `Isometric` or `Automatic`
/// \param sphere_map  gets the unit vectors. Must be readable if there are fixed vertices (whose positions it holds;
///                they will be normalised) or for `Saddle_point::Start::GIVEN`.
/// \param np  an optional sequence of named parameters:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_weight_map}
///     \cgalParamDescription{the spring constants. Unless the policy is `CGAL::Sequential_tag`\, several threads read
///       them at the same time. Before CGAL 6.1 this parameter must be the first of the chain.}
///     \cgalParamType{`Conformal_weights`\, or a model of `SphericalParameterizationWeightMap`}
///     \cgalParamDefault{`conformal_weights(mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the mesh, in any unit}
///     \cgalParamType{a readable property map with key vertex_descriptor and a value with `x()`\, `y()` and `z()`}
///     \cgalParamDefault{the mesh's own}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{which vertices are fixed at their positions in `sphere_map`: three or more\, in distinct
///       directions}
///     \cgalParamType{a readable property map with key vertex_descriptor and value `bool`}
///     \cgalParamDefault{no vertex}
///   \cgalParamNEnd
///   \cgalParamNBegin{face_density_map}
///     \cgalParamDescription{the target area of faces on the sphere\, per area in the mesh and up to a common factor:
///       \ref densities. For `Isometric` and `Automatic`; others violate a precondition. It must be the first of a
///       chain of named parameters\, or gets the rest as argument: `face_density_map(density\, accuracy(1e-4))`.}
///     \cgalParamType{a readable property map with key face_descriptor and a positive number as value}
///     \cgalParamDefault{the same for all faces}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_density_map}
///     \cgalParamDescription{the same at vertices: a face has the mean of its corners. Excludes `face_density_map`.}
///     \cgalParamType{a readable property map with key vertex_descriptor and a positive number as value}
///     \cgalParamDefault{the same for all vertices}
///   \cgalParamNEnd
///   \cgalParamNBegin{accuracy}
///     \cgalParamDescription{the residual to reach; see the method}
///     \cgalParamType{`double`\, positive}
///     \cgalParamDefault{the method's `default_accuracy`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{maximum number of iterations; see the method}
///     \cgalParamType{an integer that is not negative}
///     \cgalParamDefault{the method's `default_number_of_iterations`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{wall-clock seconds after which the result is `INTERRUPTED`; checked in every step}
///     \cgalParamType{`double`\, not negative}
///     \cgalParamDefault{unlimited}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{called with the fraction of the work done\, in [0\, 1]; returns whether to continue. The
///       first call is made after mesh and maps have been read. After that\, they are not read again\, and only
///       `sphere_map` is written.}
///     \cgalParamType{callable as `bool(double)`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{verbose}
///     \cgalParamDescription{logs every iteration to `std::cerr`}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return the verdict, the certificate, and the work; see `Result`
/// \throws std::bad_alloc  if there is not enough memory
/// \throws OpenCL_error    if the device of an `OpenCL_device` fails
///
/// Exceptions of the property maps and the callback are passed on, but for an `Error` that another function of this
/// package throws in a property map: the result then has it.
///
/// Complexity: linear in memory, about 400 bytes per vertex, `Isometric` 1,000 to 1,500; `Balanced` takes as long as a
/// few hundred applications of the Laplacian for any number of vertices.
template <class ExecutionPolicy, class TriangleMesh, class Method, class VertexSphereMap,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_method_for<TriangleMesh, Method> = 0>
Result parameterize(const ExecutionPolicy& policy, const TriangleMesh& mesh, const Method& method,
                    VertexSphereMap sphere_map, const CGAL_NP_CLASS& np = parameters::default_values())
{
  if constexpr(internal::check_arguments<TriangleMesh, VertexSphereMap, CGAL_NP_CLASS>())
    return internal::run(policy, method, np, sphere_map, [&](const auto& read) {
      return read(mesh, internal::Mesh_inputs<TriangleMesh, CGAL_NP_CLASS>{mesh, np});
    });
  else
    return Result();
}

/// \overload
/// \param mesh,method,sphere_map,np as above; on one core \return as above
template <class TriangleMesh, class Method, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_method_for<TriangleMesh, Method> = 0>
Result parameterize(const TriangleMesh& mesh, const Method& method, VertexSphereMap sphere_map,
                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  return parameterize(CGAL::Sequential_tag(), mesh, method, sphere_map, np);
}

/// \overload
/// \param policy,mesh,sphere_map,np as above; by `Balanced` \return as above
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_map_for<TriangleMesh, VertexSphereMap> = 0>
Result parameterize(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map,
                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  return parameterize(policy, mesh, Balanced(), sphere_map, np);
}

/// \overload
/// \param mesh,sphere_map,np as above; by `Balanced`, on one core \return as above
template <class TriangleMesh, class VertexSphereMap, class CGAL_NP_TEMPLATE_PARAMETERS,
          internal::If_map_for<TriangleMesh, VertexSphereMap> = 0>
Result parameterize(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                    const CGAL_NP_CLASS& np = parameters::default_values())
{
  return parameterize(CGAL::Sequential_tag(), mesh, Balanced(), sphere_map, np);
}

/// \cond SKIP_IN_MANUAL
/// What is left: the arguments are not what any of the functions above takes.
template <class... Arguments>
Result parameterize(const Arguments&...)
{
  static_assert(sizeof...(Arguments) == 0,
                "parameterize() takes ([policy,] mesh, [method,] sphere map [, named parameters]) in this order: the "
                "mesh is a model of FaceListGraph, the method is Balanced, Isometric, Automatic or Saddle_point");
  return Result();
}
/// \endcond

/// Maps the triangles of a soup to the unit sphere: points and index triples, as CGAL's functions for polygon soups
/// take them. No mesh data structure is built. To map a soup more than once, or for the other functions of this
/// package, make an `Indexed_triangle_mesh`.
///
/// The triangles must form a closed, connected, oriented surface of genus 0. Otherwise `Result::error` and
/// `Result::detail` say what is wrong, with the indices of points and triangles.
///
/// \tparam PointRange     a range of points with x(), y(), z() or operator[]
/// \tparam TriangleRange  a range of ranges of three integers
/// \tparam SpherePoints   a random access range of points with three coordinates, such as
///                        `std::vector<std::array<double, 3>>`
/// \param policy     as for `parameterize()`
/// \param points     in any unit
/// \param triangles  the indices of their points, counterclockwise as seen from outside
/// \param method     as for `parameterize()`
/// \param sphere_points  gets the unit vectors, in the order of `points`. If its size differs from that of `points`, it
///                   is resized, if it can be. On entry it must hold the positions of fixed vertices.
/// \param np  the named parameters of `parameterize()` except `vertex_point_map`. The keys of
///            `vertex_is_constrained_map` and `vertex_density_map` are indices of points (`std::size_t`), those of
///            `face_density_map` indices of triangles. The keys of `edge_weight_map` are pairs of indices of points
///            (`std::pair<std::size_t, std::size_t>`), the smaller one first.
/// \return the verdict, the certificate, and the work
///
/// Complexity: as `parameterize()`; checking takes O(n).
template <class ExecutionPolicy, class PointRange, class TriangleRange, class Method, class SpherePoints,
          class CGAL_NP_TEMPLATE_PARAMETERS>
Result parameterize_triangle_soup(const ExecutionPolicy& policy, const PointRange& points,
                                  const TriangleRange& triangles, const Method& method, SpherePoints& sphere_points,
                                  const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef std::pair<std::size_t, std::size_t> Edge;
  static_assert(internal::Is_method<Method>::value,
                "parameterize_triangle_soup() takes (policy, points, triangles, method, sphere points [, named "
                "parameters]): the method is Balanced, Isometric, Automatic or Saddle_point");
  static_assert(parameters::is_default_parameter<CGAL_NP_CLASS, internal_np::vertex_point_t>::value,
                "parameterize_triangle_soup() takes its points as an argument: leave out vertex_point_map");
  if constexpr(internal::Is_method<Method>::value &&
               internal::check_named_parameters<Edge, std::size_t, std::size_t, CGAL_NP_CLASS>())
    return internal::run(policy, method, np, internal::Range_map<SpherePoints>{&sphere_points}, [&](const auto& read) {
      const Indexed_triangle_mesh mesh(policy, points, triangles);
      internal::make_room(sphere_points, mesh.number_of_vertices());
      return read(mesh, internal::Soup_inputs<Indexed_triangle_mesh, CGAL_NP_CLASS>{mesh, np});
    });
  else
    return Result();
}

/// \overload
/// \param points,triangles,sphere_points as above; by `Balanced`, on one core \return as above
template <class PointRange, class TriangleRange, class SpherePoints>
Result parameterize_triangle_soup(const PointRange& points, const TriangleRange& triangles, SpherePoints& sphere_points)
{
  return parameterize_triangle_soup(CGAL::Sequential_tag(), points, triangles, Balanced(), sphere_points);
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H
