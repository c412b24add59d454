// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "mapping/mapped_mesh.h"
#include "mapping/report.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"
#include "system/guarded.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <optional>
#include <string>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;
using SP::internal::Stopwatch;

/// The command line of `map`.
struct Map_options : Mapping_options {
  std::string output;
  std::string report;
  std::string stretch_ply;
};

void check_map_options(const Map_options& options)
{
  require_extension("--output", options.output, {".off", ".obj", ".ply"});
  if(!options.stretch_ply.empty())
    require_extension("--stretch-ply", options.stretch_ply, {".ply"});
  check_files(input_files(options),
              {{"--output", options.output}, {"--report", options.report}, {"--stretch-ply", options.stretch_ply}});
  check_mapping_options(options);
}

void print_certificate(const Map_options& options, const Mapped_mesh& input, const Report& report)
{
  const SP::Result& result = input.result;
  std::cout.precision(3);
  if(input.file->triangulated_polygons > 0)
    std::cout << input.file->triangulated_polygons
              << " polygons were triangulated, so the faces of the sphere are not those of " << options.input << '\n';
  std::cout << options.input << ": " << result.number_of_vertices << " vertices, " << result.number_of_faces
            << " faces\n"
            << "valid spherical map: " << result.flipped_faces << " flipped faces, degree " << result.degree
            << ", residual " << result.residual;
  if(result.moved_vertices > 0)
    std::cout << ", " << result.moved_vertices << " vertices moved";
  std::cout << '\n'
            << result.method << ", " << (result.method == "isometric" ? "" : options.weights + " weights, ")
            << options.policy << " on " << result.device << ": " << result.start_iterations << " + "
            << result.iterations << " iterations";
  if(result.sweeps > 0)
    std::cout << " of " << result.sweeps << " sweeps in total";
  std::cout << '\n';
  if(!result.fallback_reason.empty())
    std::cout << "automatic: " << result.fallback_reason << '\n';
  std::cout << report.seconds_total << " s: read " << input.seconds_read << ", start map " << result.seconds.start_map
            << ", solve " << result.seconds.solve << ", certify " << result.seconds.certify << ", write "
            << report.seconds_write << '\n'
            << "written: " << options.output << (options.stretch_ply.empty() ? "" : " and " + options.stretch_ply)
            << std::endl;
}

/// Either all of the files get their names or none.
void map(const Map_options& options, Mapped_mesh& input, Report& report)
{
  const Stopwatch total;
  read_input(options, input);
  Atomic_file sphere_file(options.output);
  const auto stretch_file = options.stretch_ply.empty() ? nullptr : std::make_unique<Atomic_file>(options.stretch_ply);
  if(!options.report.empty())
    Atomic_file(options.report); // it is written at the end, also if there is no map
  map_input(options, input);

  if(!options.report.empty()) {
    const Stopwatch measuring;
    report.distortion = SP::distortion_summary(input.mesh(), as_map(input.sphere));
    report.seconds_measure = measuring.seconds();
  }
  const Stopwatch writing;
  write_mesh(sphere_file.stream(), options.output, input.mesh(), input.sphere);
  if(stretch_file)
    write_stretch_ply(stretch_file->stream(), input.mesh(), input.sphere);
  stop_if_interrupted(options.input);
  Atomic_file::commit_all({stretch_file.get(), &sphere_file});
  report.seconds_write = writing.seconds();
  report.seconds_total = total.seconds();
  print_certificate(options, input, report);
}

int run(const Map_options& options)
{
  Report report;
  Mapped_mesh input;
  const Stopwatch total;
  report.refusal = guarded(options.input, [&] { map(options, input, report); });
  report.seconds_total = total.seconds();

  std::optional<Refusal> refusal = report.refusal;
  if(!options.report.empty()) {
    const auto of_report = guarded(options.input, [&] { write_report(options.report, options, input, report); });
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
  add_mapping_options(*command, *options);
  command
    ->add_option(
      "-o,--output", options->output,
      "Output file of the sphere: .off, .obj or .ply. Its vertices and faces are those of IN, in the same order")
    ->required()
    ->type_name("FILE");
  command
    ->add_option("--report", options->report,
                 "Write the certificate, distortion, times, memory and settings, or the error, as JSON")
    ->type_name("FILE");
  command
    ->add_option("--stretch-ply", options->stretch_ply,
                 "Write IN as PLY, coloured by the logarithm of the area stretch")
    ->type_name("FILE");
  command->footer("Example: spherical-parameterization map bunny.ply -o sphere.off --report report.json\n"
                  "Exit code: 0 a certified map was written, 1 no map was written (stderr says why), 2 wrong usage,\n"
                  "130 interrupted.");
  command->callback([options, &exit_code] {
    check_map_options(*options);
    exit_code = run(*options);
  });
}

} // namespace tool
