// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/Result.h>
#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/base/Failure.h>
#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/problem/Map_task.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Source_mesh.h>
#include <CGAL/Spherical_parameterization/internal/problem/fixed_vertices.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/driver/run_automatic.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/run_balanced.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/run_isometric.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/run_saddle_point.h>
#include <CGAL/Spherical_parameterization/internal/driver/verdict.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <CGAL/property_map.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationMap
/// @{

/// Maps a closed triangle mesh of genus 0 to the unit sphere.
///
/// The result is certified: `Result::error` is `OK` if and only if the method has converged, every face is positively
/// oriented as seen from outside by an exact predicate on the coordinates written to `sphere_map`, and the map covers
/// the sphere once. It is then a bijection. In all other cases the error says what is wrong; `sphere_map` is written
/// whenever there is a map (`NOT_CONVERGED`, `INTERRUPTED` and `NOT_BIJECTIVE`: the best one found).
/// Calls on different meshes, or on the same mesh with different maps, may run concurrently.
///
/// \tparam ExecutionPolicy  a model of `SphericalParameterizationPolicy`
/// \tparam TriangleMesh     a model of `FaceListGraph` and `HalfedgeListGraph`
/// \tparam Method           a model of `SphericalParameterizationMethod`
/// \tparam VertexSphereMap  a model of `VertexSphereMap`
/// \tparam NamedParameters  a sequence of CGAL's named parameters
/// \param policy  where to run: `CGAL::Sequential_tag`; `CGAL::Parallel_tag`, if linked with TBB (`CGAL::TBB_support`);
///                an `OpenCL_device`, if OpenCL_device.h is included. The result does not depend on it, to the last bit
///                (but see `OpenCL_device`).
/// \param mesh    a closed triangle mesh of genus 0; its own indices are not used
/// \param method  `Balanced`, `Saddle_point`, `Isometric` or `Automatic`
/// \param sphere_map  where the unit vectors go. Must be readable where there are fixed vertices (whose positions it
///                holds; they will be normalised) or for `Saddle_point::Start::GIVEN`.
/// \param np  an optional sequence of named parameters:
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{edge_weight_map}
///     \cgalParamDescription{the spring constants. Unless the policy is `CGAL::Sequential_tag`\, several threads read
///       them at once. Before CGAL 6.1 this parameter has to come first in the chain.}
///     \cgalParamType{a model of `SphericalParameterizationWeightMap`}
///     \cgalParamDefault{`conformal_weights(mesh)`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the mesh, in any unit}
///     \cgalParamType{a readable property map with key vertex_descriptor and a value with `x()`\, `y()` and `z()`}
///     \cgalParamDefault{the mesh's own}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_is_constrained_map}
///     \cgalParamDescription{which vertices are fixed where `sphere_map` has them: three or more\, in distinct
///       directions; not for `Isometric`}
///     \cgalParamType{a readable property map with key vertex_descriptor and value `bool`}
///     \cgalParamDefault{no vertex}
///   \cgalParamNEnd
///   \cgalParamNBegin{accuracy}
///     \cgalParamDescription{what the residual has to come down to; see the method}
///     \cgalParamType{`double`\, positive}
///     \cgalParamDefault{the method's `default_accuracy`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_iterations}
///     \cgalParamDescription{the most iterations; see the method}
///     \cgalParamType{an integer that is not negative}
///     \cgalParamDefault{the method's `default_number_of_iterations`}
///   \cgalParamNEnd
///   \cgalParamNBegin{maximum_running_time}
///     \cgalParamDescription{wall-clock seconds after which the result is `INTERRUPTED`}
///     \cgalParamType{`double`}
///     \cgalParamDefault{unlimited}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{called with the fraction of the work done\, in [0\, 1]; returns whether to go on}
///     \cgalParamType{callable as `bool(double)`}
///     \cgalParamDefault{none}
///   \cgalParamNEnd
///   \cgalParamNBegin{verbose}
///     \cgalParamDescription{logs every iteration to `std::cerr`}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
/// \return the verdict, the certificate, and what the work was; see `Result`
/// \throws std::bad_alloc  if there is not enough memory
/// \throws OpenCL_error    if the device of an `OpenCL_device` fails
///
/// What the property maps and the callback throw goes through.
///
/// Complexity: linear in memory, about 500 bytes per vertex; `Balanced` takes as long as a few hundred applications
/// of the Laplacian for any number of vertices.
template <class ExecutionPolicy, class TriangleMesh, class Method, class VertexSphereMap,
          class NamedParameters = parameters::Default_named_parameters>
Result parameterize(const ExecutionPolicy& policy, const TriangleMesh& mesh, const Method& method,
                    VertexSphereMap sphere_map, const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::is_default_parameter;
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename boost::property_traits<VertexSphereMap>::value_type Sphere_point;
  internal::check_options(method);

  const internal::Stopwatch total;
  Result result;
  std::function<bool(double)> callback;
  if constexpr(!is_default_parameter<NamedParameters, internal_np::callback_t>::value)
    callback = get_parameter(np, internal_np::callback);
  internal::Monitor monitor(
    choose_parameter(get_parameter(np, internal_np::maximum_running_time), std::numeric_limits<double>::infinity()),
    std::move(callback), choose_parameter(get_parameter(np, internal_np::verbose), false));
  try {
    const internal::Stopwatch watch;
    const auto points = internal::vertex_points(mesh, np);
    typedef typename boost::property_traits<std::decay_t<decltype(points)>>::value_type Point;
    const std::conditional_t<internal::are_plain_coordinates<Point>(),
                             typename internal::Backend<ExecutionPolicy>::Host_loop, internal::Sequential_loop>
      loop;
    internal::Source_mesh<TriangleMesh> source(mesh, points, loop);
    result.number_of_vertices = source.vertex.size();
    result.number_of_faces = source.face.size();
    const auto set_weights = [&] {
      if constexpr(is_default_parameter<NamedParameters, internal::edge_weight_tag>::value)
        source.set_weights(mesh, conformal_weights(mesh, 5, 85, np), loop);
      else
        source.set_weights(mesh, get_parameter(np, internal::edge_weight_tag()), loop);
    };
    const std::string missing_weights = internal::weigh(method, set_weights);

    const auto is_constrained =
      choose_parameter(get_parameter(np, internal_np::vertex_is_constrained),
                       Static_boolean_property_map<typename Graph_traits::vertex_descriptor, false>());
    const std::vector<char> is_fixed = internal::fixed_vertices(source.vertex, is_constrained);
    internal::Map_task task = {source.graph, source.face, source.point, source.area,     is_fixed,          {}, {},
                               {},           monitor,     result,       missing_weights, source.weight_unit};
    if constexpr(!is_default_parameter<NamedParameters, internal_np::accuracy_t>::value)
      task.accuracy = get_parameter(np, internal_np::accuracy);
    if constexpr(!is_default_parameter<NamedParameters, internal_np::number_of_iterations_t>::value)
      task.number_of_iterations = static_cast<std::size_t>(get_parameter(np, internal_np::number_of_iterations));
    if(task.has_fixed() || internal::needs_given_start(method))
      task.given = internal::given_positions(source.vertex, source.position, sphere_map, is_fixed,
                                             internal::needs_given_start(method));
    result.seconds.read = watch.seconds();

    internal::Choice_of_backend<ExecutionPolicy>::call(
      policy, task.size(), [&](const auto& backend, const std::string& device) {
        result.device = device;
        result.method = internal::name(method);
        internal::Solver_report report;
        internal::Host_array<internal::vec3> v = internal::run(backend, method, task, report);
        if(backend.best_accuracy(task.size()) > 0 && !task.is_on_sphere) // low precision: as near as doubles are
          for(internal::vec3& p : v)
            p = internal::unit(p);
        for(std::size_t i = 0; i < is_fixed.size(); ++i)
          if(is_fixed[i]) // to the last bit
            v[i] = task.given[i];

        const internal::Stopwatch certify_watch;
        for(std::size_t i = 0; i < v.size(); ++i)
          put(sphere_map, source.vertex[i], Sphere_point{v[i].x, v[i].y, v[i].z});
        internal::pass_verdict(backend.host_loop(), source.face, v, task.has_fixed(), report, monitor, result);
        result.seconds.certify += certify_watch.seconds();
      });
    monitor.begin_stage(1, 1);
    monitor.advance(1);
  } catch(const internal::Failure& failure) {
    result.error = failure.code;
    result.detail = failure.detail;
  }
  result.seconds.total = total.seconds();
  return result;
}

/// The default: `Balanced` on one core, as `parameterize(CGAL::Sequential_tag(), mesh, Balanced(), sphere_map, np)`.
/// \param mesh        a closed triangle mesh of genus 0
/// \param sphere_map  where the unit vectors go
/// \param np          the named parameters of the function above
/// \return the verdict, the certificate, and what the work was
template <class TriangleMesh, class VertexSphereMap, class NamedParameters = parameters::Default_named_parameters>
Result parameterize(const TriangleMesh& mesh, VertexSphereMap sphere_map,
                    const NamedParameters& np = parameters::default_values())
{
  return parameterize(CGAL::Sequential_tag(), mesh, Balanced(), sphere_map, np);
}

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PARAMETERIZE_H
