// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/step.h"

#include "input/compression.h"
#include "input/files.h"
#include "preparation/points.h"
#include "preparation/prepare.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/harmonic_alignment.h>
#include <CGAL/Spherical_parameterization/harmonic_files.h>
#include <CGAL/Spherical_parameterization/spherical_harmonics.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

namespace tool {
namespace {

struct Harmonics_options {
  int degree = 15;
  std::string fit = "least-squares";
  bool align = false;
};

SP::Coefficient_format format_of(const std::string& file)
{
  const std::string extension = lower_case_extension(without_compression(file));
  return extension == ".csv"    ? SP::Coefficient_format::CSV
         : extension == ".json" ? SP::Coefficient_format::JSON
                                : SP::Coefficient_format::SPHARM_PDM;
}

/// Least squares want as many data as unknowns.
void check_degree(const Harmonics_options& options, const std::string& file, const Mesh& mesh)
{
  const int largest = static_cast<int>(std::sqrt(static_cast<double>(mesh.number_of_vertices()))) - 1;
  if(options.fit == "least-squares" && options.degree > largest)
    throw Refusal(bad_degree, file,
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
  });
  return points;
}

/// Moves points as `aligned_to_ellipsoid()` moves the shape of its coefficients.
void move_to_ellipsoid(const SP::First_order_ellipsoid& ellipsoid, std::vector<Point>& points)
{
  for(Point& p : points) {
    const Point from_centre = minus(p, ellipsoid.centre);
    for(std::size_t k = 0; k < 3; ++k)
      p[k] = dot(ellipsoid.axes[k], from_centre);
  }
}

/// How the error falls with the degree: of the first degrees of the coefficients.
Json errors_by_degree(const Harmonics_options& options, const std::string& file, const Mapped_mesh& input,
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
    stop_if_interrupted(file);
    if(degree == options.degree)
      return rows;
  }
}

/// \param written  the coefficients, moved if that is asked for
Json harmonics_json(const Harmonics_options& options, const std::string& file, const Mapped_mesh& input,
                    const SP::Harmonic_analysis& analysis, const SP::Harmonic_coefficients& written)
{
  Json harmonics = {{"degree", options.degree},
                    {"fit", options.fit},
                    {"iterations", analysis.iterations},
                    {"converged", analysis.has_converged},
                    {"errors", errors_by_degree(options, file, input, analysis.coefficients)},
                    {"power_spectrum", SP::power_spectrum(written)}};
  if(options.degree > 0) {
    const SP::First_order_ellipsoid ellipsoid = SP::first_order_ellipsoid(analysis.coefficients);
    harmonics["ellipsoid"] = {{"centre", ellipsoid.centre},
                              {"radii", ellipsoid.radii},
                              {"axes", ellipsoid.axes},
                              {"sphere_axes", ellipsoid.sphere_axes}};
  }
  return harmonics;
}

void harmonics(const Harmonics_options& options, Run& run)
{
  Mapped_mesh& input = run.input;
  const std::string& file = run.options.input;
  run.read();
  check_degree(options, file, input.mesh());
  run.map();

  const Stopwatch analyzing;
  const SP::Harmonic_analysis analysis = analyzed(options, input);
  const double seconds_analysis = analyzing.seconds();
  std::vector<Point> points = reconstructed(input, analysis.coefficients);
  const SP::Reconstruction_error error =
    SP::reconstruction_error(input.mesh(), as_map(input.mesh().points()), as_map(points));
  const SP::Harmonic_coefficients written =
    options.align ? SP::aligned_to_ellipsoid(analysis.coefficients) : analysis.coefficients;
  Json json = run.has("--report") ? harmonics_json(options, file, input, analysis, written) : Json();
  run.figures.seconds_measure = analyzing.seconds();
  const double seconds_errors = run.figures.seconds_measure - seconds_analysis;
  json["seconds"] = {{"analysis", seconds_analysis}, {"errors", seconds_errors}};
  run.details["harmonics"] = std::move(json);
  stop_if_interrupted(file);
  SP::write_coefficients(*run.out(), written, format_of(run.file()));
  if(options.align) {
    move_to_ellipsoid(SP::first_order_ellipsoid(analysis.coefficients), points);
    run.annotations = in_space_of({}, run.annotations);
  }
  run.write("--reconstruct", input.mesh(), points, Surface::SHAPE);
  run.commit();

  std::ostringstream line, text;
  line.precision(3);
  text.precision(3);
  line << "degree " << options.degree << ", " << analysis.coefficients.size() << " coefficients of x, y and z"
       << (options.align ? ", aligned to the first-order ellipsoid" : "");
  text << preparation_text(file, input.prepared) << run.file() << ": " << line.str() << '\n';
  if(!analysis.has_converged)
    text << "least squares stopped after " << analysis.iterations
         << " iterations without reaching their accuracy: there are few vertices for this degree; --fit integrals is "
            "safer\n";
  text << "error at the vertices: root mean square " << error.root_mean_square << " (" << error.relative
       << " of the size), at most " << error.largest << '\n'
       << run.figures.seconds_total << " s: map " << input.result.seconds.total << ", harmonics " << seconds_analysis
       << ", errors " << seconds_errors;
  line << ", relative error " << error.relative << (analysis.has_converged ? "" : ", accuracy not reached");
  run.text = text.str();
  run.line = line.str();
}

Work harmonics_work()
{
  const auto own = std::make_shared<Harmonics_options>();
  Work work = {[own](Run& run) { harmonics(*own, run); }};
  Options& options = work.options;
  options("--degree", own->degree, "The largest degree: (DEGREE + 1)^2 coefficients per coordinate").in("[0,2000]");
  options("--fit", own->fit,
          "Least squares at the vertices, which need as many vertices as coefficients, or integrals over the faces")
    .of({"least-squares", "integrals"});
  options("--align", own->align,
          "Move the shape to the position of its first-order ellipsoid, the longest axis along x, so that the "
          "coefficients of shapes in any position can be compared");
  work.check = [own](const Request&) {
    require(!own->align || own->degree > 0, "--align", "requires --degree 1 or more");
  };
  return work;
}

} // namespace

Step harmonics_step()
{
  return {
    "harmonics",
    "Describe a shape by spherical harmonics (SPHARM)",
    {Takes::EACH, "isometric", "conformal", Takes::OPTION, Prepare::ALL,
     "the coefficients are those of the repaired mesh, whose vertices and faces --reconstruct writes"},
    {{"-o,--output",
      "Output file of the coefficients: .csv, .json, or .coef, the format of SPHARM-PDM",
      {".csv", ".json", ".coef"},
      Output::FILE,
      Output::REQUIRED},
     {"--reconstruct", "Write the shape of the coefficients, with the vertices and faces of IN", {}, Output::MESH}},
    harmonics_work,
    "harmonics bunny.ply -o bunny.csv --degree 32",
    "The report has the errors by degree, with Hausdorff distances, the power spectrum and the ellipsoid of the shape "
    "where IN is."};
}

} // namespace tool
