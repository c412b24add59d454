// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/mesh_command.h"

#include "mapping/report.h"
#include "mapping/spherical_map.h"
#include "system/interruption.h"
#include "system/stopwatch.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>

#include <cmath>
#include <sstream>

namespace tool {
namespace {

/// The command line of `certify`.
struct Certify_options : Mesh_options {
  std::string report;
};

void check_certify_options(const Certify_options&) {}

Sphere mirror_image(Sphere points)
{
  for(Point& p : points)
    p[0] = -p[0];
  return points;
}

/// Points off a common sphere are projected to it, of which people should know.
void say_radius(std::ostream& out, const std::string& file, const Given_sphere& sphere)
{
  constexpr double rounding = 1e-3; // of files of floats, and of programs that keep spheres only roughly
  out << file << ": ";
  if(sphere.largest_radius <= (1 + rounding) * sphere.smallest_radius)
    out << "radius " << sphere.largest_radius << '\n';
  else
    out << "points at distances from " << sphere.smallest_radius << " to " << sphere.largest_radius
        << " of the origin, from which they are projected to the sphere\n";
}

void say_distortion(std::ostream& out, const SP::Distortion_summary& d)
{
  constexpr double degrees = 57.295779513082321;
  out << "angle distortion: mean " << degrees * d.angle_distortion.mean << " degrees, 95 % of the area below "
      << degrees * d.angle_distortion.percentile_95 << "\narea shrinks by factors from "
      << std::exp(d.log_area_stretch.percentile_5) << " to " << std::exp(d.log_area_stretch.percentile_95)
      << " (90 % of the area)";
}

void certify(const Certify_options& options, Mapped_mesh& input, Report& report, Outcome& outcome)
{
  const Stopwatch total;
  watch_for_interruption();
  if(!options.report.empty())
    Atomic_file(options.report); // it is written at the end, also of a sphere that is not valid
  input.settings = std::make_shared<Map_settings>();
  input.settings->policy = make_policy(options);
  input.file = read_mesh(options.input, options.triangulate ? Polygons::TRIANGULATE : Polygons::REFUSE);
  const Given_sphere sphere = read_given_sphere(options.sphere, options.input, input.mesh());
  input.seconds_read = total.seconds();

  const Stopwatch certifying;
  const auto certified = [&](const std::vector<Point>& points) {
    return tool::certify(input.settings->policy, input.mesh(), points);
  };
  input.result = certified(sphere.points);
  input.result.seconds.certify = certifying.seconds();
  const bool is_mirrored = input.result.degree == -1;
  // the measures are of maps that keep the orientation
  input.sphere = is_mirrored ? mirror_image(sphere.on_unit_sphere) : sphere.on_unit_sphere;
  const Stopwatch measuring;
  report.distortion = on_host(
    input, [&](const auto& policy) { return SP::distortion_summary(policy, input.mesh(), as_map(input.sphere)); });
  report.seconds_measure = measuring.seconds();
  stop_if_interrupted(options.input);

  const SP::Result& result = input.result;
  std::ostringstream certificate, text;
  certificate << "spherical map: " << result.flipped_faces << " flipped faces, degree " << result.degree;
  text.precision(3);
  text << options.input << ": " << result.number_of_vertices << " vertices, " << result.number_of_faces << " faces\n"
       << (result        ? "valid "
           : is_mirrored ? "mirrored "
                         : "no valid ")
       << certificate.str() << '\n';
  say_radius(text, options.sphere, sphere);
  say_distortion(text, *report.distortion);
  outcome.text = text.str();
  outcome.line = "valid " + certificate.str() + ", " + std::to_string(result.number_of_vertices) + " vertices";
  if(is_mirrored) {
    const std::size_t left = certified(mirror_image(sphere.points)).flipped_faces;
    throw Refusal("MIRRORED", options.sphere,
                  std::string("is a mirror image, ") +
                    (left == 0 ? std::string("otherwise a valid spherical map")
                               : "and its mirror image has " + std::to_string(left) + " flipped faces"),
                  "negate one coordinate of the sphere, or turn the faces of the mesh round");
  }
  if(!result)
    throw Refusal(result.error, options.sphere, "is no valid spherical map: " + result.detail, "");
}

void certify_and_report(const Certify_options& options, Outcome& outcome)
{
  reported(options.report, options,
           [&](Mapped_mesh& input, Report& report) { certify(options, input, report, outcome); });
}

/// There is no output but the report.
const Mesh_command<Certify_options> certify_command = {
  "", check_certify_options, certify_and_report, {{"--report", &Certify_options::report}}};

} // namespace

void add_certify_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("certify", "Certify and measure a spherical map of any program");
  const auto options = std::make_shared<Certify_options>();
  add_collection_options(*command, *options);
  command->get_option("IN")->description("MESH... SPHERE: closed triangle meshes of genus 0, or folders of them, and "
                                         "at the end the sphere, or the folder of "
                                         "the spheres with the same names. A sphere has the same vertices and faces in "
                                         "the same order as its mesh, about the "
                                         "origin, of any radius");
  command
    ->add_option(
      "-o,--output", options->output,
      "Folder for the reports of several MESH, and of what is done, so that the same command goes on with it")
    ->type_name("FOLDER");
  command->add_flag("--triangulate", options->triangulate,
                    "Triangulate the polygons of MESH as 'map' does; SPHERE has triangles");
  add_file_option(*command, "--report", options->report,
                  "Write certificate and distortion as JSON, with the keys of 'map'");
  add_footer(*command, "certify lh.pial.ply lh.sphere.ply --report report.json", "the map is valid",
             "it is not, or is mirrored (stderr says why)");
  command->callback([options, command, &exit_code] {
    check_collection_options(*options);
    require(options->inputs.size() + (options->list.empty() ? 0 : 1) >= 2, "SPHERE", "is required, behind MESH");
    options->sphere = options->inputs.back();
    options->inputs.pop_back();
    require(options->output.empty() || options->are_many(options->output), "--output",
            "is a folder for several MESH; for one its name ends with a slash");
    exit_code = run_mesh_command(*command, certify_command, *options);
  });
}

} // namespace tool
