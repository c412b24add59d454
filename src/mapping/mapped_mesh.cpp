// SPDX-License-Identifier: GPL-3.0-or-later

#include "mapping/mapped_mesh.h"

#include "output/write_mesh.h"
#include "preparation/points.h"
#include "system/refusal.h"
#include "system/terminal.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <numeric>
#include <set>
#include <tuple>

namespace tool {
namespace {

/// Which options may help. Empty where the detail of the library says what to do.
std::string remedy(const Mapping_options& options, Error_code code, std::optional<SP::Termination> termination)
{
  const bool has_fall_back = options.method != "automatic" && options.method != "isometric" && !options.falls_back;
  switch(code) {
  case Error_code::NOT_CONVERGED: {
    const std::string more = termination == SP::Termination::STALLED ? "" : "allow more --iterations";
    const std::string other = options.method == "isometric" ? ""
                              : has_fall_back               ? "try --method automatic"
                                                            : "try other --weights";
    return more + (more.empty() || other.empty() ? "" : ", or ") + other;
  }
  case Error_code::NOT_BIJECTIVE: return has_fall_back && options.sphere.empty() ? "try --method automatic" : "";
  case Error_code::INTERRUPTED: return "allow more --max-time";
  default: return "";
  }
}

/// The vertices of the mesh that is mapped, which may have been mended.
std::vector<Fixed_vertex> fixed_vertices(const std::string& file, const Mapped_mesh& input)
{
  const std::vector<int> mapped = mapped_vertices(input);
  std::vector<Fixed_vertex> fixed = read_fixed_vertices(file, mapped.size());
  std::set<std::size_t> seen;
  for(Fixed_vertex& vertex : fixed) {
    const int index = mapped[vertex.index];
    if(index < 0 || !seen.insert(static_cast<std::size_t>(index)).second)
      refuse_file(file,
                  "vertex " + std::to_string(vertex.index) +
                    (index < 0 ? " was removed" : " was merged with another fixed one") + " when the mesh was repaired",
                  "name another one");
    vertex.index = static_cast<std::size_t>(index);
  }
  return fixed;
}

/// By vertex or face of the mesh that is mapped.
std::vector<double> densities(const std::string& file, const Mapped_mesh& input)
{
  if(!input.prepared)
    return read_densities(file, input.mesh().number_of_vertices(), input.mesh().number_of_faces());
  const std::size_t vertices = input.prepared->soup.points.size();
  const std::vector<double> given = read_densities(file, vertices, input.prepared->soup.triangles.size());
  const Glued_surface& mended = input.prepared->preparation.parts.front();
  const bool is_of_vertices = given.size() == vertices;
  std::vector<double> result;
  for(const int old : is_of_vertices ? mended.old_vertex : mended.old_face) {
    if(old < 0)
      refuse_file(file,
                  std::string("gives no density for the ") + (is_of_vertices ? "vertices" : "faces") +
                    " that were added when the mesh was repaired",
                  "prepare the mesh first, and give the density of what is written");
    result.push_back(given[static_cast<std::size_t>(old)]);
  }
  return result;
}

void compute_map(const Mapping_options& options, Mapped_mesh& input)
{
  if(!options.fixed.empty())
    input.data.fixed_vertices = fixed_vertices(options.fixed, input);
  if(!options.density.empty())
    input.data.density = densities(options.density, input);

  Progress_bar bar("mapping");
  input.result = map_to_sphere(input.mesh(), input.sphere, options, input.data, [&](double fraction) {
    if(!input.needs_neighbours)
      input.file->mesh.forget_neighbours();
    bar.show(fraction);
    return !was_interrupted();
  });
  input.seconds_read += input.result.seconds.read; // the library checks, too
}

/// Whether the method has no answer where another one may have one.
bool asks_for_another_method(Error_code code)
{
  return code == Error_code::NOT_CONVERGED || code == Error_code::DEGENERATE_FACE || code == Error_code::BAD_WEIGHT;
}

bool is_turned_inwards(const Mesh& mesh)
{
  const std::vector<Point>& points = mesh.points();
  const auto corner = [&points](int v) { return minus(points[place(v)], points[0]); };
  double volume = 0; // six times that of the pyramids over the faces, from the first vertex on
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto& [i, j, k] = mesh.triangle(f);
    volume += dot(corner(i), cross(corner(j), corner(k)));
  }
  return volume < 0;
}

} // namespace

std::vector<int> mapped_vertices(const Mapped_mesh& input)
{
  if(input.prepared)
    return mended_vertices(*input.prepared);
  std::vector<int> all(input.mesh().number_of_vertices());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void read_input(const Mapping_options& options, Mapped_mesh& input)
{
  watch_for_interruption();
  input.data.policy = make_policy(options);
  const Stopwatch reading;
  const Polygons polygons = options.triangulate ? Polygons::TRIANGULATE : Polygons::REFUSE;
  input.file = options.prepare != Prepare::NO ? read_prepared_mesh(options.input, options.prepare, input.prepared)
               : options.can_prepare_all      ? read_mesh(options.input, polygons, "--prepare does it")
                                              : read_mesh(options.input, polygons);
  if(input.prepared) {
    read_data(options, input.prepared->soup.points.size(), input.prepared->soup.data);
    input.file->data = carried(input.prepared->soup.data, input.prepared->preparation.parts.front().old_vertex);
  } else
    read_data(options, input.mesh().number_of_vertices(), input.file->data);
  input.seconds_read = reading.seconds();
  input.result.number_of_vertices = input.mesh().number_of_vertices();
  input.result.number_of_faces = input.mesh().number_of_faces();
  stop_if_interrupted(options.input);
}

void read_data(const Mapping_options& options, std::size_t number_of_vertices, Vertex_data& data)
{
  for(const std::string& file : options.data)
    for(Vertex_column& column : read_vertex_data(file, number_of_vertices))
      data.push_back(std::move(column));
  number_equal_names(data);
}

std::string triangulation_text(const std::string& file, const Mapped_mesh& input, const std::string& of_what)
{
  const std::size_t polygons = input.file->triangulated_polygons;
  return polygons == 0 ? ""
                       : std::to_string(polygons) + " polygons were triangulated, so the faces " + of_what +
                           " are not those of " + file + '\n';
}

std::string preparation_text(const std::string& file, const Mapped_mesh& input)
{
  if(input.prepared)
    return preparation_text(file, input.prepared);
  return is_turned_inwards(input.mesh()) ? file + ": its faces are turned inwards; --prepare turns them\n" : "";
}

void check_orientation(const std::string& file, const Mapped_mesh& input)
{
  if(is_turned_inwards(input.mesh()))
    throw Refusal(Error_code::INCONSISTENT_ORIENTATION, file, "its faces are turned inwards, so that left is right",
                  "--prepare turns them");
}

void map_input(const Mapping_options& options, Mapped_mesh& input, Map_quality quality)
{
  const Stopwatch mapping;
  if(!options.sphere.empty())
    input.result = read_sphere(input.data.policy, options.sphere, options.input, input.mesh(), input.sphere);
  else {
    compute_map(options, input);
    if(options.falls_back && asks_for_another_method(input.result.error) && !was_interrupted()) {
      Mapping_options others = options;
      others.method = "automatic";
      if(options.max_time)
        others.max_time = std::max(0., *options.max_time - mapping.seconds());
      compute_map(others, input);
    }
  }
  input.seconds_map = mapping.seconds();
  stop_if_interrupted(options.input);

  const SP::Result& result = input.result;
  const bool is_accepted = result || (quality == Map_quality::CONVERGED && result.error == Error_code::NOT_BIJECTIVE &&
                                      (options.sphere.empty() ? !input.sphere.empty() : result.degree == 1));
  if(!is_accepted) {
    const std::string& file = result.error == Error_code::BAD_CONSTRAINTS ? options.fixed
                              : result.error == Error_code::BAD_DENSITY   ? options.density
                              : options.sphere.empty()                    ? options.input
                                                                          : options.sphere;
    const std::string what_to_do = remedy(options, result.error, result.termination);
    const std::string detail = what_to_do.empty() ? result.detail : without_remedy(result.detail, result.remedy);
    throw Refusal(result.error, file, get_error_message(result.error) + (detail.empty() ? "" : ": " + detail),
                  what_to_do);
  }
}

void check_answer(const Mapping_options& options, Error_code error, const std::string& detail)
{
  stop_if_interrupted(options.input);
  if(error != Error_code::OK)
    throw Refusal(error, options.input, std::string(get_error_message(error)) + ": " + detail,
                  remedy(options, error, std::nullopt));
}

void certify_as_stored(const std::string& output, Mesh_format format, Mapped_mesh& input, const Sphere& sphere)
{
  if(!stores_floats(format))
    return;
  const auto stored = boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) {
    return as_stored(format, Surface::SPHERE, sphere[static_cast<std::size_t>(v.idx())]);
  });
  on_host(input, [&](const auto& policy) {
    std::tie(input.result.flipped_faces, input.result.degree) = SP::certify_map(policy, input.mesh(), stored);
  });
  if(input.result.flipped_faces > 0 || input.result.degree != 1)
    throw Refusal(Error_code::NOT_BIJECTIVE, output,
                  std::to_string(input.result.flipped_faces) +
                    " faces flip when the sphere is rounded to the floats of this format",
                  "write .ply, .off or .obj, which hold doubles, or try --method isometric");
}

void take_as_stored(Mesh_format format, Mapped_mesh& input)
{
  for(Point& p : input.sphere)
    p = on_unit_sphere(as_stored(format, Surface::SPHERE, p));
  SP::Result& r = input.result;
  for(double* const figure : {&r.residual, &r.energy, &r.density_deviation, &r.smallest_area, &r.smallest_edge})
    *figure = std::numeric_limits<double>::quiet_NaN();
}

} // namespace tool
