// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The door through which JavaScript comes in, behind web/core/index.ts, which checks the kinds of arguments and says
// what they mean. Arrays have three numbers per point or triangle; what is returned has the names of the tool's report.

#include "input/mesh.h"
#include "input/mesh_readers.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/segmentation.h>
#include <CGAL/Spherical_parameterization/version.h>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#if defined(__EMSCRIPTEN_PTHREADS__) && __clang_major__ < 15
#error "clang 14 has one place for the exceptions of all threads; web/build.mjs takes clang 15"
#endif

namespace core {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using emscripten::val;
using tool::as_map;
using tool::Mesh;
using Points = tool::Sphere;

const CGAL::Parallel_if_available_tag all_cores; ///< if the core has threads, else the one there is

/// The numbers as an array of JavaScript, which owns them.
template <class Number, std::size_t N, class Allocator>
val to_array(const std::vector<std::array<Number, N>, Allocator>& rows)
{
  return val(emscripten::typed_memory_view(N * rows.size(), rows.empty() ? nullptr : rows.front().data()))
    .call<val>("slice");
}
template <class Number, class Allocator>
val to_array(const std::vector<Number, Allocator>& numbers)
{
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}

/// An array of JavaScript as rows of three.
template <class Number>
std::vector<std::array<Number, 3>> rows_of(const val& array)
{
  std::vector<std::array<Number, 3>> rows(array["length"].as<std::size_t>() / 3);
  if(!rows.empty())
    val(emscripten::typed_memory_view(3 * rows.size(), rows.front().data())).call<void>("set", array);
  return rows;
}
Mesh mesh_of(const val& points, const val& triangles)
{
  return {all_cores, rows_of<double>(points), rows_of<int>(triangles)};
}

/// A map on a sphere of any radius as one on the unit sphere. Unit vectors, also those of floats, stay as they are.
Points sphere_of(const val& array)
{
  Points sphere = rows_of<double>(array);
  for(std::size_t v = 0; v < sphere.size(); ++v) {
    auto& [x, y, z] = sphere[v];
    double length = std::sqrt(x * x + y * y + z * z);
    if(!(length >= 1e-100 && length <= 1e100)) // the squares may be out of range
      length = std::hypot(x, y, z);
    if(!(length > 0 && std::isfinite(length)))
      throw SP::Error(SP::Error_code::NON_FINITE_COORDINATE,
                      "vertex " + std::to_string(v) + " of the sphere has no direction");
    if(std::abs(length - 1) >= 1e-6)
      sphere[v] = {x / length, y / length, z / length};
  }
  return sphere;
}

val to_object(const SP::Distribution& d)
{
  val object = val::object();
  object.set("mean", d.mean);
  object.set("standard_deviation", d.deviation);
  object.set("min", d.min);
  object.set("percentile_1", d.percentile_1);
  object.set("percentile_5", d.percentile_5);
  object.set("median", d.median);
  object.set("percentile_95", d.percentile_95);
  object.set("percentile_99", d.percentile_99);
  object.set("max", d.max);
  return object;
}

val to_object(const SP::Distortion_summary& d)
{
  val object = val::object();
  object.set("log_area_stretch", to_object(d.log_area_stretch));
  object.set("angle_distortion", to_object(d.angle_distortion));
  object.set("dilatation", to_object(d.dilatation));
  object.set("symmetric_dirichlet", to_object(d.symmetric_dirichlet));
  object.set("spherical_symmetric_dirichlet", to_object(d.spherical_symmetric_dirichlet));
  object.set("degenerate_faces", static_cast<double>(d.degenerate_faces));
  return object;
}

/// Any of the weights of edges as one map, so that the solvers are compiled once per method only.
struct Weight_map {
  using key_type = Mesh::Edge_index;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;

  std::variant<decltype(SP::barycentric_weights(std::declval<const Mesh&>())),
               decltype(SP::clamped_weights(std::declval<const Mesh&>())),
               decltype(SP::mean_value_weights(std::declval<const Mesh&>()))>
    weights;

  friend double get(const Weight_map& map, Mesh::Edge_index e)
  {
    return std::visit([e](const auto& chosen) { return get(chosen, e); }, map.weights);
  }
};

std::variant<SP::Conformal_weights, Weight_map> weights_of(const Mesh& mesh, const std::string& name)
{
  if(name == "barycentric")
    return Weight_map{SP::barycentric_weights(mesh)};
  if(name == "mean-value")
    return Weight_map{SP::mean_value_weights(mesh)};
  if(name == "clamped")
    return Weight_map{SP::clamped_weights(mesh)};
  return SP::Conformal_weights();
}

template <class Method>
SP::Result map_by(const Mesh& mesh, Points& sphere, const Method& method, const val& settings, const val& go_on)
{
  const auto number = [&settings](const char* name, double otherwise) {
    const val value = settings[name];
    return value.isUndefined() ? otherwise : value.as<double>();
  };
  return SP::parameterize(
    all_cores, mesh, method, as_map<Mesh::Vertex_index>(sphere),
    CGAL::parameters::edge_weight_map(weights_of(mesh, settings["weights"].as<std::string>()))
      .accuracy(number("accuracy", Method::default_accuracy))
      .number_of_iterations(static_cast<std::size_t>(std::min<double>(
        number("iterations", Method::default_number_of_iterations), std::numeric_limits<std::size_t>::max())))
      .maximum_running_time(number("maximum_running_time", std::numeric_limits<double>::infinity()))
      .callback([&go_on](double fraction) { return go_on(fraction).template as<bool>(); }));
}

SP::Result map_by_settings(const Mesh& mesh, Points& sphere, const val& settings, const val& go_on)
{
  const std::string method = settings["method"].as<std::string>();
  const double area_exponent = settings["area_exponent"].as<double>();
  const double spring_exponent = settings["spring_exponent"].as<double>();
  if(method == "balanced")
    return map_by(mesh, sphere, SP::Balanced{spring_exponent}, settings, go_on);
  if(method == "saddle-point")
    return map_by(mesh, sphere, SP::Saddle_point(), settings, go_on);
  if(method == "isometric")
    return map_by(mesh, sphere, SP::Isometric{area_exponent}, settings, go_on);
  SP::Automatic automatic;
  automatic.spring_exponent = spring_exponent;
  automatic.area_exponent = area_exponent;
  return map_by(mesh, sphere, automatic, settings, go_on);
}

void write_result(const SP::Result& result, val& answer)
{
  answer.set("method_used", result.method);
  answer.set("fallback_reason", result.fallback_reason);
  answer.set("start_iterations", static_cast<double>(result.start_iterations));
  answer.set("iterations", static_cast<double>(result.iterations));
  answer.set("sweeps", static_cast<double>(result.sweeps));
  answer.set("residual", result.residual);
  answer.set("energy", result.energy);
  answer.set("flipped_faces", static_cast<double>(result.flipped_faces));
  answer.set("moved_vertices", static_cast<double>(result.moved_vertices));
  answer.set("degree", result.degree);
  answer.set("smallest_area", result.smallest_area);
  answer.set("smallest_edge", result.smallest_edge);
}

val seconds_of(const SP::Result& result)
{
  val seconds = val::object();
  seconds.set("read", result.seconds.read);
  seconds.set("weights", result.seconds.weights);
  seconds.set("start_map", result.seconds.start_map);
  seconds.set("solve", result.seconds.solve);
  seconds.set("certify", result.seconds.certify);
  seconds.set("total", result.seconds.total);
  return seconds;
}

/// What `action(answer)` writes, and the error: a code, a sentence, and where it is and what to do.
template <class Action>
val answer_of(const Action& action)
{
  val answer = val::object();
  const auto refuse = [&answer](const std::string& code, const std::string& error, const std::string& detail = "") {
    answer.set("error_code", code);
    answer.set("error", error);
    answer.set("detail", detail);
  };
  refuse(SP::get_error_name(SP::Error_code::OK), "");
  try {
    action(answer, refuse);
  } catch(const tool::Refusal& refusal) {
    refuse(refusal.code(), refusal.what());
  } catch(const SP::Error& error) {
    refuse(SP::get_error_name(error.code()), get_error_message(error.code()), error.detail());
  } catch(const CGAL::Failure_exception& failure) {
    refuse("BAD_ARGUMENT", failure.message());
  } catch(const std::exception& exception) {
    if(dynamic_cast<const std::bad_alloc*>(&exception) || dynamic_cast<const std::length_error*>(&exception))
      refuse(tool::out_of_memory, "there is not enough memory",
             "WebAssembly has 4 GB at most; use the command-line tool");
    else
      refuse(tool::internal_error, exception.what());
  }
  return answer;
}

/// Reads the bytes of a file, in the format of its content, or else of its name.
val read_mesh(const std::string& name, const std::string& bytes, bool triangulate)
{
  return answer_of([&](val& answer, const auto&) {
    if(bytes.empty())
      tool::refuse_file(name, "is empty", "export it again");
    const tool::Soup soup = tool::read_soup(name, bytes);
    if(!triangulate)
      tool::check_triangles(name, soup, "triangulate the mesh, or choose to have it triangulated");
    answer.set("points", to_array(soup.points));
    answer.set("triangles", to_array(soup.triangles));
  });
}

/// Maps a mesh. `go_on(fraction)` returns whether to.
val parameterize(const val& points, const val& triangles, const val& settings, const val& go_on)
{
  return answer_of([&](val& answer, const auto& refuse) {
    const Mesh mesh = mesh_of(points, triangles);
    Points sphere(mesh.number_of_vertices());
    const SP::Result result = map_by_settings(mesh, sphere, settings, go_on);
    answer.set("seconds", seconds_of(result));
    if(result.termination)
      answer.set("termination", std::string(get_termination_name(*result.termination)));
    if(!result)
      refuse(SP::get_error_name(result.error), get_error_message(result.error), result.detail);
    if(sphere.front() == Points::value_type()) // nothing was written
      return;
    write_result(result, answer);
    answer.set("sphere", to_array(sphere));
  });
}

/// Measures a map.
val measure(const val& points, const val& triangles, const val& sphere)
{
  return answer_of([&](val& answer, const auto&) {
    const Mesh mesh = mesh_of(points, triangles);
    const Points places = sphere_of(sphere);
    const auto images = as_map(places);
    std::vector<double> values(mesh.number_of_faces());
    SP::face_angle_distortion(all_cores, mesh, images, as_map<Mesh::Face_index>(values));
    answer.set("face_angle_distortion", to_array(values));
    SP::face_log_area_stretch(all_cores, mesh, images, as_map<Mesh::Face_index>(values));
    answer.set("face_stretch", to_array(values));
    answer.set("distortion", to_object(SP::distortion_summary(all_cores, mesh, images)));
  });
}

/// The segments of the faces of a mesh, by its map.
val segment(const val& points, const val& triangles, const val& sphere)
{
  return answer_of([&](val& answer, const auto& refuse) {
    const Mesh mesh = mesh_of(points, triangles);
    const Points places = sphere_of(sphere);
    std::vector<int> segments(mesh.number_of_faces());
    const auto found =
      SP::segmentation_via_area_stretch(all_cores, mesh, as_map(places), as_map<Mesh::Face_index>(segments));
    if(!found)
      return refuse(SP::get_error_name(found.error), get_error_message(found.error), found.detail);
    answer.set("segments", to_array(segments));
  });
}

/// For tests: the sign of det(a, b, c) of nine coordinates, as the certificate takes it.
int orientation(const val& coordinates)
{
  const auto x = emscripten::convertJSArrayToNumberVector<double>(coordinates);
  const auto is_positive = [](const Mesh::Point& a, const Mesh::Point& b, const Mesh::Point& c) {
    // two faces of the tetrahedron are flat, and two have the orientation of a, b and c
    const Points points = {a, b, c, {-a[0], -a[1], -a[2]}};
    const std::vector<std::array<int, 3>> faces = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    return SP::number_of_flipped_faces(Mesh(points, faces), as_map(points)) == 2;
  };
  const Mesh::Point a = {x[0], x[1], x[2]}, b = {x[3], x[4], x[5]}, c = {x[6], x[7], x[8]};
  return is_positive(a, b, c) - is_positive(a, c, b);
}

} // namespace
} // namespace core

EMSCRIPTEN_BINDINGS(core)
{
  CGAL::set_error_handler([](const char*, const char*, const char*, int, const char*) {}); // else it prints
  emscripten::function("readMesh", &core::read_mesh);
  emscripten::function("parameterize", &core::parameterize);
  emscripten::function("measure", &core::measure);
  emscripten::function("segment", &core::segment);
  emscripten::function("orientation", &core::orientation);
  emscripten::constant("version", std::string(CGAL_SPHERICAL_PARAMETERIZATION_VERSION));
}
