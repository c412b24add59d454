// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "mapping/mapped_mesh.h"
#include "mapping/report.h"
#include "mapping/spherical_map.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "system/error_code_names.h"
#include "system/guarded.h"
#include "system/interruption.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>

#include <CLI/CLI.hpp>

#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using SP::internal::Stopwatch;

/// The command line of `certify`.
struct Certify_options : Mapping_options {
  std::string report;
};

Sphere mirror_image(Sphere points)
{
  for(Point& p : points)
    p[0] = -p[0];
  return points;
}

/// Points off a common sphere are projected to it, of which people should know.
void print_radius(const std::string& file, const Given_sphere& sphere)
{
  constexpr double rounding = 1e-3; // of files of floats, and of programs that keep spheres only roughly
  std::cout << file << ": ";
  if(sphere.largest_radius <= (1 + rounding) * sphere.smallest_radius)
    std::cout << "radius " << sphere.largest_radius << '\n';
  else
    std::cout << "points at distances from " << sphere.smallest_radius << " to " << sphere.largest_radius
              << " of the origin, from which they are projected to the sphere\n";
}

void print_distortion(const SP::Distortion_summary& d)
{
  constexpr double degrees = 57.295779513082321;
  std::cout << "angle distortion: mean " << degrees * d.angle_distortion.mean << " degrees, 95 % of the area below "
            << degrees * d.angle_distortion.percentile_95 << "\narea shrinks by factors from "
            << std::exp(d.log_area_stretch.percentile_5) << " to " << std::exp(d.log_area_stretch.percentile_95)
            << " (90 % of the area)" << std::endl;
}

void certify(const Certify_options& options, Mapped_mesh& input, Report& report)
{
  const Stopwatch total;
  watch_for_interruption();
  if(!options.report.empty())
    Atomic_file(options.report); // it is written at the end, also of a sphere that is not valid
  input.file = read_mesh(options.input, options.triangulate ? Polygons::TRIANGULATE : Polygons::REFUSE);
  const Given_sphere sphere = read_given_sphere(options.sphere, options.input, input.mesh());
  input.seconds_read = total.seconds();

  const Stopwatch certifying;
  input.result = tool::certify(input.mesh(), sphere.points);
  input.result.seconds.certify = certifying.seconds();
  const bool is_mirrored = input.result.degree == -1;
  // the measures are of maps that keep the orientation
  input.sphere = is_mirrored ? mirror_image(sphere.on_unit_sphere) : sphere.on_unit_sphere;
  const Stopwatch measuring;
  report.distortion = SP::distortion_summary(input.mesh(), as_map(input.sphere));
  report.seconds_measure = measuring.seconds();
  stop_if_interrupted(options.input);

  const SP::Result& result = input.result;
  std::cout.precision(3);
  std::cout << options.input << ": " << result.number_of_vertices << " vertices, " << result.number_of_faces
            << " faces\n"
            << (result        ? "valid spherical map: "
                : is_mirrored ? "mirrored spherical map: "
                              : "no valid spherical map: ")
            << result.flipped_faces << " flipped faces, degree " << result.degree << '\n';
  print_radius(options.sphere, sphere);
  print_distortion(*report.distortion);
  if(is_mirrored) {
    const std::size_t left = tool::certify(input.mesh(), mirror_image(sphere.points)).flipped_faces;
    throw Refusal("MIRRORED", options.sphere,
                  std::string("is a mirror image, ") +
                    (left == 0 ? std::string("otherwise a valid spherical map")
                               : "and its mirror image has " + std::to_string(left) + " flipped faces"),
                  "negate one coordinate of the sphere, or turn the faces of the mesh round");
  }
  if(!result)
    throw Refusal(name(result.error), options.sphere, "is no valid spherical map: " + result.detail, "");
}

} // namespace

void add_certify_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("certify", "Certify and measure a spherical map of any program");
  const auto options = std::make_shared<Certify_options>();
  command->add_option("MESH", options->input, "Closed triangle mesh of genus 0: .off, .obj, .ply or .stl")
    ->required()
    ->type_name("FILE");
  command
    ->add_option("SPHERE", options->sphere,
                 "Its sphere: the same vertices and faces in the same order, about the origin, of any radius")
    ->required()
    ->type_name("FILE");
  command->add_flag("--triangulate", options->triangulate,
                    "Triangulate the polygons of MESH as 'map' does; SPHERE has triangles");
  command->add_option("--report", options->report, "Write certificate and distortion as JSON, with the keys of 'map'")
    ->type_name("FILE");
  command->footer("Example: spherical-parameterization certify lh.pial.ply lh.sphere.ply --report report.json\n"
                  "Exit code: 0 the map is valid, 1 it is not, or is mirrored (stderr says why), 2 wrong usage,\n"
                  "130 interrupted.");
  command->callback([options, &exit_code] {
    check_files(input_files(*options), {{"--report", options->report}});
    exit_code = exit_code_of(reported(options->report, *options,
                                      [&](Mapped_mesh& input, Report& report) { certify(*options, input, report); }));
  });
}

} // namespace tool
