// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/mesh_command.h"

#include "mapping/report.h"
#include "system/standard_output.h"
#include "system/stopwatch.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <sstream>

namespace tool {
namespace {

/// The command line of `map`.
struct Map_options : Mesh_options {
  std::string report;
  std::string stretch_ply;
};

void check_map_options(const Map_options& options)
{
  output_format(options);
  if(!options.stretch_ply.empty())
    require_extension("--stretch-ply", options.stretch_ply, {".ply"});
  check_mapping_options(options);
}

void say(const Map_options& options, const Mapped_mesh& input, const Report& report, Outcome& outcome)
{
  const SP::Result& result = input.result;
  const std::string name = shown(options.input, "standard input");
  std::ostringstream text, line;
  text.precision(3);
  line << "valid spherical map: " << result.flipped_faces << " flipped faces, degree " << result.degree;
  if(input.file->triangulated_polygons > 0)
    text << input.file->triangulated_polygons
         << " polygons were triangulated, so the faces of the sphere are not those of " << name << '\n';
  const std::string preparation = preparation_text(name, input.prepared);
  if(!preparation.empty())
    text << preparation
         << "the sphere has the vertices and faces of the prepared mesh, which 'prepare --steps merge,orient' writes\n";
  text << name << ": " << result.number_of_vertices << " vertices, " << result.number_of_faces << " faces\n"
       << line.str() << ", residual " << result.residual;
  const std::string shortfall = options.sphere.empty() ? SP::get_shortcoming(result) : "";
  if(!shortfall.empty())
    text << "\nvalid, but " << shortfall;
  if(!options.density.empty())
    text << "\nstandard deviation of log(area / wanted area): " << result.density_deviation;
  text << '\n'
       << result.method << ", " << (result.method == "isometric" ? "" : options.weights + " weights, ")
       << options.policy << " on " << result.device << ": " << result.start_iterations << " + " << result.iterations
       << " iterations";
  if(result.sweeps > 0)
    text << " of " << result.sweeps << " sweeps in total";
  text << '\n';
  if(!result.fallback_reason.empty())
    text << "automatic: " << result.fallback_reason << '\n';
  if(is_verbose()) {
    const auto was_said = [&](const std::string& detail) {
      return result.fallback_reason.find(detail) < std::string::npos;
    };
    for(const SP::Result::Attempt& attempt : result.attempts)
      text << "tried " << attempt.method << " for " << attempt.seconds.total
           << " s: " << get_error_message(attempt.error)
           << (attempt.detail.empty() || was_said(attempt.detail) ? "" : ": " + attempt.detail) << '\n';
    text << "smallest area " << result.smallest_area << ", smallest edge " << result.smallest_edge
         << " roundings; peak memory " << double(peak_memory_bytes()) / 1e6 << " MB\n";
  }
  text << report.seconds_total << " s: read " << input.seconds_read << ", weights " << result.seconds.weights
       << ", start map " << result.seconds.start_map << ", solve " << result.seconds.solve << ", certify "
       << result.seconds.certify;
  if(report.seconds_measure > 0)
    text << ", measure " << report.seconds_measure;
  text << ", write " << report.seconds_write << '\n'
       << "written: " << shown(options.output, "standard output")
       << (options.stretch_ply.empty() ? "" : " and " + options.stretch_ply);
  line << ", " << result.number_of_vertices << " vertices, " << result.method;
  if(input.file->triangulated_polygons > 0)
    line << ", " << input.file->triangulated_polygons << " polygons were triangulated";
  if(!preparation.empty())
    line << ", prepared";
  if(!shortfall.empty())
    line << "; " << shortfall;
  outcome.text = text.str();
  outcome.line = line.str();
}

/// Either all of the files get their names or none.
void map(const Map_options& options, Mapped_mesh& input, Report& report, Outcome& outcome)
{
  const Stopwatch total;
  read_input(options, input);
  Atomic_files files;
  std::ostream& sphere_file = files.open(options.output);
  std::ostream* const stretch_file = files.open_if_named(options.stretch_ply);
  if(!options.report.empty())
    Atomic_file(options.report); // it is written at the end, also if there is no map
  input.needs_neighbours = !options.stretch_ply.empty();
  map_input(options, input);
  const Output_format format = output_format(options);
  certify_as_stored(options.output, format.format, input, input.sphere);

  if(!options.report.empty()) {
    const Stopwatch measuring;
    report.distortion = on_host(
      input, [&](const auto& policy) { return SP::distortion_summary(policy, input.mesh(), as_map(input.sphere)); });
    report.seconds_measure = measuring.seconds();
  }
  std::vector<double> stretch;
  if(stretch_file) {
    const Stopwatch measuring;
    stretch.resize(input.mesh().number_of_vertices());
    on_host(input, [&](const auto& policy) {
      return SP::vertex_log_area_stretch(policy, input.mesh(), as_map(input.sphere),
                                         as_map<Mesh::Vertex_index>(stretch));
    });
    report.seconds_measure += measuring.seconds();
  }
  const Stopwatch writing;
  write_mesh(sphere_file, format, input.mesh(), input.sphere, Surface::SPHERE, input.file->annotations);
  if(stretch_file)
    write_stretch_ply(*stretch_file, options.ascii, input.mesh(), stretch);
  files.commit(options.input);
  report.seconds_write = writing.seconds();
  report.seconds_total = total.seconds();
  say(options, input, report, outcome);
}

void map_and_report(const Map_options& options, Outcome& outcome)
{
  reported(options.report, options, [&](Mapped_mesh& input, Report& report) { map(options, input, report, outcome); });
}

const Mesh_command<Map_options> map_command = {
  ".ply",
  check_map_options,
  map_and_report,
  {{"--report", &Map_options::report}, {"--stretch-ply", &Map_options::stretch_ply}}};

} // namespace

void add_map_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("map", "Map a closed genus-0 triangle mesh to the sphere, certified");
  const auto options = add_mesh_command(*command, map_command, exit_code);
  add_mapping_options(*command, *options);
  add_prepare_option(*command, *options, Prepare::HARMLESS);
  add_mesh_output(
    *command, *options,
    "Output file of the sphere, whose vertices and faces are those of IN, in the same order; of several IN a "
    "folder");
  add_file_option(*command, "--report", options->report,
                  "Write the certificate, distortion, times, memory and settings, or the error, as JSON");
  add_file_option(*command, "--stretch-ply", options->stretch_ply,
                  "Write IN as PLY, coloured by the logarithm of the area stretch");
  add_footer(*command, "map bunny.ply -o sphere.off --report report.json", "a certified map was written",
             "no map was written (stderr says why)");
}

} // namespace tool
