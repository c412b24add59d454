// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/map_command.h"

#include "mapping/mapped_mesh.h"
#include "mapping/report.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "output/stretch_ply.h"
#include "output/write_mesh.h"
#include "system/guarded.h"
#include "system/interruption.h"

#include <CGAL/Real_timer.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace tool {
namespace {

/// The command line of `map`.
struct Map_options : Mapping_options {
  std::string output;
  std::string report;
  std::string stretch_ply;
};

void add_map_options(CLI::App& command, Map_options& options)
{
  add_mapping_options(command, options);
  command
    .add_option(
      "-o,--output", options.output,
      "Output file of the sphere: .off, .obj or .ply. Its vertices and faces are those of IN, in the same order")
    ->required()
    ->type_name("FILE");
  command
    .add_option("--report", options.report,
                "Write the certificate, distortion, times, memory and settings, or the error, as JSON")
    ->type_name("FILE");
  command
    .add_option("--stretch-ply", options.stretch_ply, "Write IN as PLY, coloured by the logarithm of the area stretch")
    ->type_name("FILE");
  command.footer("Example: spherical-parameterization map bunny.ply -o sphere.off --method automatic\n"
                 "Exit code: 0 a certified map was written, 1 no map was written (stderr says why), 2 wrong usage,\n"
                 "130 interrupted.");
}

void check_map_options(const Map_options& options)
{
  require_extension("--output", options.output, {".off", ".obj", ".ply"});
  if(!options.stretch_ply.empty())
    require_extension("--stretch-ply", options.stretch_ply, {".ply"});
  check_files(input_files(options),
              {{"--output", options.output}, {"--report", options.report}, {"--stretch-ply", options.stretch_ply}});
  check_mapping_options(options);
}

/// Either all of the files get their names or none.
void write(const Map_options& options, const Mesh& mesh, Sphere_map sphere, Atomic_file& sphere_file,
           Atomic_file* stretch_file)
{
  write_mesh(sphere_file.stream(), output_format(options.output), mesh, sphere);
  if(stretch_file)
    write_stretch_ply(stretch_file->stream(), mesh, sphere);
  stop_if_interrupted(options.input);
  Atomic_file::commit_all({stretch_file, &sphere_file});
}

void print_certificate(const Map_options& options, const Mapped_mesh& input, const Report& report)
{
  const CGAL::Spherical_parameterization::Result& result = input.result;
  std::cout.precision(3);
  if(input.triangulated_polygons > 0)
    std::cout << input.triangulated_polygons
              << " polygons were triangulated, so the faces of the sphere are not those of " << options.input << '\n';
  std::cout << options.input << ": " << result.number_of_vertices << " vertices, " << result.number_of_faces
            << " faces\n"
            << "valid spherical map: " << result.flipped_faces << " flipped faces, degree " << result.degree
            << ", residual " << result.residual << '\n'
            << (options.method == "automatic" ? "automatic: " : "") << result.method << ", "
            << (result.method == "isometric" ? "" : options.weights + " weights, ") << options.policy << " on "
            << result.device << ": " << result.start_iterations << " + " << result.iterations << " iterations";
  if(result.sweeps > 0)
    std::cout << " of " << result.sweeps << " sweeps in total";
  std::cout << '\n';
  if(!result.fallback_reason.empty())
    std::cout << "earlier attempts failed: " << result.fallback_reason << '\n';
  std::cout << report.seconds_total << " s: read " << input.seconds_read << ", start map " << result.seconds.start_map
            << ", solve " << result.seconds.solve << ", certify " << result.seconds.certify << ", write "
            << report.seconds_write << '\n'
            << "written: " << options.output << (options.stretch_ply.empty() ? "" : " and " + options.stretch_ply)
            << std::endl;
}

void map(const Map_options& options, Mapped_mesh& input, Report& report)
{
  CGAL::Real_timer total;
  total.start();
  read_input(options, input);
  Atomic_file sphere_file(options.output);
  const auto stretch_file = options.stretch_ply.empty() ? nullptr : std::make_unique<Atomic_file>(options.stretch_ply);
  if(!options.report.empty())
    Atomic_file(options.report); // it is written at the end, also if there is no map
  map_input(options, input);

  if(!options.report.empty()) {
    CGAL::Real_timer measuring;
    measuring.start();
    report.distortion = CGAL::Spherical_parameterization::distortion_summary(input.mesh, input.sphere);
    report.seconds_measure = measuring.time();
  }
  CGAL::Real_timer writing;
  writing.start();
  write(options, input.mesh, input.sphere, sphere_file, stretch_file.get());
  report.seconds_write = writing.time();
  report.seconds_total = total.time();
  print_certificate(options, input, report);
}

int run(const Map_options& options)
{
  Report report;
  report.options = options;
  Mapped_mesh input;
  CGAL::Real_timer total;
  total.start();
  report.refusal = guarded(options.input, [&] { map(options, input, report); });
  report.result = input.result;
  report.seconds_read = input.seconds_read;
  report.seconds_total = total.time();

  std::optional<Refusal> refusal = report.refusal;
  if(!options.report.empty()) {
    const std::optional<Refusal> of_report = guarded(options.input, [&] { write_report(options.report, report); });
    if(!refusal)
      refusal = of_report;
  }
  return exit_code_of(refusal);
}

} // namespace

void add_map_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("map", "Map a closed genus-0 triangle mesh to the sphere, certified");
  const auto options = std::make_shared<Map_options>();
  add_map_options(*command, *options);
  command->callback([options, &exit_code] {
    check_map_options(*options);
    exit_code = run(*options);
  });
}

} // namespace tool
