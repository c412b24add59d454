// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/mesh_command.h"

#include "mapping/report.h"
#include "preparation/prepare.h"
#include "output/write_json.h"
#include "system/interruption.h"
#include "system/stopwatch.h"

#include <CGAL/Spherical_parameterization/harmonic_alignment.h>
#include <CGAL/Spherical_parameterization/harmonic_files.h>
#include <CGAL/Spherical_parameterization/spherical_harmonics.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace tool {
namespace {

using Json = nlohmann::ordered_json;

struct Harmonics_options : Mesh_options {
  Harmonics_options() { method = "isometric"; }

  std::string reconstruct;
  std::string report;
  int degree = 15;
  std::string fit = "least-squares";
  bool align = false;
};

void check_harmonics_options(const Harmonics_options& options)
{
  require_extension("--output", options.output, {".csv", ".json", ".coef"});
  if(!options.reconstruct.empty())
    output_format_of_name("--reconstruct", options.reconstruct, options.ascii);
  check_mapping_options(options);
}

SP::Coefficient_format format_of(const std::string& file)
{
  const std::string extension = std::filesystem::path(file).extension().string();
  return extension == ".csv"    ? SP::Coefficient_format::CSV
         : extension == ".json" ? SP::Coefficient_format::JSON
                                : SP::Coefficient_format::SPHARM_PDM;
}

/// Least squares want as many data as unknowns.
void check_degree(const Harmonics_options& options, const Mesh& mesh)
{
  const int largest = static_cast<int>(std::sqrt(static_cast<double>(mesh.number_of_vertices()))) - 1;
  if(options.fit == "least-squares" && options.degree > largest)
    throw Refusal(bad_degree, options.input,
                  std::to_string(mesh.number_of_vertices()) + " vertices are too few for least squares of degree " +
                    std::to_string(options.degree),
                  "use --degree " + std::to_string(largest) + " or less, or --fit integrals");
}

SP::Harmonic_analysis analyzed(const Harmonics_options& options, const Mapped_mesh& input)
{
  const auto analyze = [&](const auto& method) {
    return on_host(input, [&](const auto& policy) {
      return SP::harmonic_analysis(policy, input.mesh(), as_map(input.sphere), as_map(input.mesh().points()),
                                   options.degree, method, stopped_by_signals());
    });
  };
  return options.fit == "integrals" ? analyze(SP::Integration()) : analyze(SP::Least_squares());
}

/// The vertices where the functions have them.
std::vector<Point> reconstructed(const Mapped_mesh& input, const SP::Harmonic_coefficients& coefficients)
{
  std::vector<Point> points(input.mesh().number_of_vertices());
  on_host(input, [&](const auto& policy) {
    SP::harmonic_synthesis(policy, coefficients, input.mesh(), as_map(input.sphere), as_map(points),
                           stopped_by_signals());
    return 0;
  });
  return points;
}

/// How the error falls with the degree: of the first degrees of the coefficients.
Json errors_by_degree(const Harmonics_options& options, const Mapped_mesh& input,
                      const SP::Harmonic_coefficients& coefficients)
{
  Json rows = Json::array();
  for(int degree = 1;; degree = (std::min)(2 * degree, options.degree)) {
    degree = (std::min)(degree, options.degree);
    const std::vector<Point> points = reconstructed(input, SP::with_degree(coefficients, degree));
    const SP::Reconstruction_error error =
      SP::reconstruction_error(input.mesh(), as_map(input.mesh().points()), as_map(points));
    rows.push_back({{"degree", degree},
                    {"root_mean_square", error.root_mean_square},
                    {"relative", error.relative},
                    {"largest", error.largest},
                    {"hausdorff", hausdorff_distance_at_vertices(input.mesh(), input.mesh().points(), points)}});
    stop_if_interrupted(options.input);
    if(degree == options.degree)
      return rows;
  }
}

Json harmonics_json(const Harmonics_options& options, const Mapped_mesh& input, const SP::Harmonic_analysis& analysis)
{
  Json harmonics = {{"degree", options.degree},
                    {"fit", options.fit},
                    {"iterations", analysis.iterations},
                    {"converged", analysis.has_converged},
                    {"errors", errors_by_degree(options, input, analysis.coefficients)},
                    {"power_spectrum", SP::power_spectrum(analysis.coefficients)}};
  if(options.degree > 0) {
    const SP::First_order_ellipsoid ellipsoid = SP::first_order_ellipsoid(analysis.coefficients);
    harmonics["ellipsoid"] = {{"centre", ellipsoid.centre},
                              {"radii", ellipsoid.radii},
                              {"axes", ellipsoid.axes},
                              {"sphere_axes", ellipsoid.sphere_axes}};
  }
  return harmonics;
}

void harmonics(const Harmonics_options& options, Outcome& outcome)
{
  const Stopwatch total;
  Mapped_mesh input;
  read_input(options, input);
  check_degree(options, input.mesh());
  Atomic_files files;
  std::ostream& file = files.open(options.output);
  std::ostream* const mesh_file = files.open_if_named(options.reconstruct);
  std::ostream* const report_file = files.open_if_named(options.report);
  map_input(options, input);

  const Stopwatch analyzing;
  const SP::Harmonic_analysis analysis = analyzed(options, input);
  Report report;
  const double seconds_analysis = analyzing.seconds();
  const std::vector<Point> points = reconstructed(input, analysis.coefficients);
  const SP::Reconstruction_error error =
    SP::reconstruction_error(input.mesh(), as_map(input.mesh().points()), as_map(points));
  Json json = report_file ? harmonics_json(options, input, analysis) : Json();
  report.seconds_measure = analyzing.seconds();
  json["seconds"] = {{"analysis", seconds_analysis}, {"errors", report.seconds_measure - seconds_analysis}};
  stop_if_interrupted(options.input);
  const Stopwatch writing;
  SP::write_coefficients(file, options.align ? SP::aligned_to_ellipsoid(analysis.coefficients) : analysis.coefficients,
                         format_of(options.output));
  if(mesh_file)
    write_mesh(*mesh_file, output_format_of_name("--reconstruct", options.reconstruct, options.ascii), input.mesh(),
               points, Surface::SHAPE, input.file->annotations);
  report.seconds_write = writing.seconds();
  report.seconds_total = total.seconds();
  if(report_file) {
    Json whole = report_json(options, input, report);
    whole["harmonics"] = std::move(json);
    write_json(*report_file, whole);
  }
  files.commit(options.input);
  std::ostringstream line, text;
  line.precision(3);
  text.precision(3);
  line << "degree " << options.degree << ", " << analysis.coefficients.size() << " coefficients of x, y and z"
       << (options.align ? ", aligned to the first-order ellipsoid" : "");
  if(!analysis.has_converged)
    text << "least squares stopped after " << analysis.iterations
         << " iterations, short of their accuracy: there are few vertices for this degree; --fit integrals is safer\n";
  text << "error at the vertices: root mean square " << error.root_mean_square << " (" << error.relative
       << " of the size), at most " << error.largest << '\n'
       << report.seconds_total << " s: map " << input.result.seconds.total << ", harmonics " << seconds_analysis
       << ", errors " << report.seconds_measure - seconds_analysis;
  outcome.text = options.output + ": " + line.str() + '\n' + text.str();
  line << ", relative error " << error.relative << (analysis.has_converged ? "" : ", short of its accuracy");
  outcome.line = line.str();
}

const Mesh_command<Harmonics_options> harmonics_command = {
  ".csv",
  check_harmonics_options,
  harmonics,
  {{"--reconstruct", &Harmonics_options::reconstruct}, {"--report", &Harmonics_options::report}}};

} // namespace

void add_harmonics_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("harmonics", "Describe a shape by spherical harmonics (SPHARM)");
  const auto options = add_mesh_command(*command, harmonics_command, exit_code);
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  add_file_option(
    *command, "-o,--output", options->output,
    "Output file of the coefficients: .csv, .json, or .coef as SPHARM-PDM has it. Of several IN: a folder")
    ->required();
  add_checked_option(*command, "--degree", options->degree,
                     "The largest degree: (DEGREE + 1)^2 coefficients per coordinate", CLI::Range(0, 2000));
  add_checked_option(*command, "--fit", options->fit,
                     "By least squares at the vertices, or by integrals over the faces",
                     CLI::IsMember({"least-squares", "integrals"}));
  command->add_flag("--align", options->align,
                    "Write the coefficients of the shape moved to its first-order ellipsoid, the longest axis along x");
  add_file_option(*command, "--reconstruct", options->reconstruct,
                  "Write the mesh of the coefficients: vertices and faces of IN, where IN is");
  add_file_option(*command, "--report", options->report,
                  "Write map, errors by degree (Hausdorff distance, too), power spectrum and ellipsoid as JSON");
  add_footer(*command, "harmonics bunny.ply -o bunny.csv --degree 32");
  add_ascii_option(*command, options->ascii);
}

} // namespace tool
