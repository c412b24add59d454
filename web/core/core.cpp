// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// The door through which JavaScript comes in: the bytes of a file, settings, and a function that hears what happens.

#include "input/mesh.h"
#include "input/mesh_readers.h"
#include "system/refusal.h"
#include "system/stopwatch.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/segmentation.h>
#include <CGAL/Spherical_parameterization/version.h>

#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace page {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using emscripten::val;
using tool::as_map;
using tool::Mesh;
using Points = tool::Sphere;

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
SP::Result map_by(const Mesh& mesh, Points& sphere, const Method& method, const val& settings, const val& hear)
{
  const auto go_on = [&hear](double fraction) { return hear(std::string("progress"), fraction).template as<bool>(); };
  return SP::parameterize(
    CGAL::Sequential_tag(), mesh, method, as_map<Mesh::Vertex_index>(sphere),
    CGAL::parameters::edge_weight_map(weights_of(mesh, settings["weights"].as<std::string>())).callback(go_on));
}

SP::Result map_by_settings(const Mesh& mesh, Points& sphere, const val& settings, const val& hear)
{
  const std::string method = settings["method"].as<std::string>();
  const double area_exponent = settings["area_exponent"].as<double>();
  const double spring_exponent = settings["spring_exponent"].as<double>();
  if(method == "balanced")
    return map_by(mesh, sphere, SP::Balanced{spring_exponent}, settings, hear);
  if(method == "saddle-point")
    return map_by(mesh, sphere, SP::Saddle_point(), settings, hear);
  if(method == "isometric")
    return map_by(mesh, sphere, SP::Isometric{area_exponent}, settings, hear);
  SP::Automatic automatic;
  automatic.spring_exponent = spring_exponent;
  automatic.area_exponent = area_exponent;
  return map_by(mesh, sphere, automatic, settings, hear);
}

/// What is shown of a map besides its coordinates, but for the segments.
void measure(const Mesh& mesh, const Points& sphere, val& answer)
{
  const auto images = as_map<Mesh::Vertex_index>(sphere);
  std::vector<double> values(mesh.number_of_faces());
  SP::face_angle_distortion(mesh, images, as_map<Mesh::Face_index>(values));
  answer.set("face_angle_distortion", to_array(values));
  SP::face_log_area_stretch(mesh, images, as_map<Mesh::Face_index>(values));
  answer.set("face_stretch", to_array(values));
  answer.set("distortion", to_object(SP::distortion_summary(mesh, images)));
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

val seconds_of(const SP::Result& result, double read, double measured)
{
  val seconds = val::object();
  seconds.set("read", read + result.seconds.read);
  seconds.set("weights", result.seconds.weights);
  seconds.set("start_map", result.seconds.start_map);
  seconds.set("solve", result.seconds.solve);
  seconds.set("certify", result.seconds.certify);
  seconds.set("measure", measured);
  return seconds;
}

void refuse(val& answer, const std::string& code, const std::string& what)
{
  answer.set("error_code", code);
  answer.set("error", what);
}

/// The last mesh and its map: they are kept for `segment_last()`.
std::optional<Mesh> last_mesh;
Points last_sphere;

/// The segments of the faces of the mesh that was mapped last, or undefined if there are none.
val segment_last()
{
  if(!last_mesh)
    return val::undefined();
  std::vector<int> segments(last_mesh->number_of_faces());
  const auto found = SP::segmentation_via_area_stretch(*last_mesh, as_map<Mesh::Vertex_index>(last_sphere),
                                                       as_map<Mesh::Face_index>(segments));
  return found ? to_array(segments) : val::undefined();
}

/// Reads, maps and measures. `hear("mesh", {points, triangles})` is called as soon as the file has been read, also if
/// the mesh is refused then; `hear("progress", fraction)` returns whether to go on.
val map_file(const std::string& name, const std::string& bytes, const val& settings, const val& hear)
{
  val answer = val::object();
  refuse(answer, "OK", "");
  last_mesh.reset();
  try {
    const tool::Stopwatch reading;
    if(bytes.empty())
      throw tool::Refusal(tool::unreadable_file, name, "is empty", "export it again");
    const tool::Soup soup = tool::read_soup(name, bytes);
    if(!settings["triangulate"].as<bool>())
      tool::check_triangles(name, soup);
    val mesh_of_file = val::object();
    mesh_of_file.set("points", to_array(soup.points));
    mesh_of_file.set("triangles", to_array(soup.triangles));
    hear(std::string("mesh"), mesh_of_file);
    answer.set("vertices", static_cast<double>(soup.points.size()));
    answer.set("faces", static_cast<double>(soup.triangles.size()));
    Mesh mesh(soup.points, soup.triangles);
    const double seconds_read = reading.seconds();

    Points sphere(soup.points.size());
    const SP::Result result = map_by_settings(mesh, sphere, settings, hear);
    const bool has_map = sphere[0] != Points::value_type(); // else nothing was written
    const tool::Stopwatch measuring;
    if(has_map) {
      write_result(result, answer);
      measure(mesh, sphere, answer);
      answer.set("sphere", to_array(sphere));
    }
    answer.set("seconds", seconds_of(result, seconds_read, measuring.seconds()));
    if(has_map) {
      last_mesh = std::move(mesh);
      last_sphere = std::move(sphere);
    }
    if(!result)
      refuse(answer, SP::get_error_name(result.error),
             name + ": " + get_error_message(result.error) + (result.detail.empty() ? "" : ": " + result.detail));
  } catch(const tool::Refusal& refusal) {
    refuse(answer, refusal.code(), refusal.what());
  } catch(const SP::Error& error) { // of Indexed_triangle_mesh
    refuse(answer, SP::get_error_name(error.code()), name + ": has " + error.detail());
  } catch(const std::bad_alloc&) {
    refuse(answer, tool::out_of_memory, name + ": not enough memory; use the command-line tool");
  }
  return answer;
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
} // namespace page

EMSCRIPTEN_BINDINGS(page)
{
  emscripten::function("mapFile", &page::map_file);
  emscripten::function("orientation", &page::orientation);
  emscripten::function("segmentLast", &page::segment_last);
  emscripten::constant("version", std::string(CGAL_SPHERICAL_PARAMETERIZATION_VERSION));
}
