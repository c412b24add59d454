// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "input/binary.h"
#include "mapping/mapped_mesh.h"
#include "mapping/report.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "system/refusal.h"
#include "view_page.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/segmentation.h>

#include <CLI/CLI.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

namespace tool {
namespace {

constexpr int bytes_of_vertex = 3; // its number, in the page

struct View_options : Mapping_options {
  std::string output;
};

/// Fills the page with a header in JSON and with the arrays of web/src/view_page.ts, the lowest bytes first.
void write_page(std::ostream& out, const View_options& options, const Mapped_mesh& input)
{
  const Mesh& mesh = input.mesh();
  const auto sphere = as_map(input.sphere);
  nlohmann::json header;
  std::string bytes;
  const auto add = [&bytes](long number, int size) {
    for(int byte = 0; byte < size; ++byte)
      bytes += static_cast<char>(number >> 8 * byte & 255);
  };
  // Spreads values over 2 bytes. Returns what 0 and what 1 stand for.
  const auto add_spread = [&add](const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const double step = std::max(*high - *low, 1e-300) / 65535;
    for(double x : values)
      add(std::lround((x - *low) / step), 2);
    return std::pair(*low, step);
  };

  for(const auto* points : {&mesh.points(), &input.sphere})
    for(std::size_t k = 0; k < 3; ++k) {
      std::vector<double> coordinates;
      for(const Point& p : *points)
        coordinates.push_back(p[k]);
      header["coordinates"].push_back(add_spread(coordinates));
    }
  std::vector<double> values(mesh.number_of_faces());
  const auto of_faces = as_map<Mesh::Face_index>(values);
  const auto add_measure = [&](const char* name, const auto& measure) {
    on_host(input, [&](const auto& policy) {
      measure(policy);
      return 0;
    });
    header[name] = add_spread(values);
  };
  add_measure("stretch", [&](const auto& policy) { SP::face_log_area_stretch(policy, mesh, sphere, of_faces); });
  add_measure("angle", [&](const auto& policy) { SP::face_angle_distortion(policy, mesh, sphere, of_faces); });
  add_measure("segments", [&](const auto& policy) {
    const SP::Segmentation_result result = SP::segmentation_via_area_stretch(policy, mesh, sphere, of_faces);
    if(!result)
      throw Refusal(result.error, options.input, get_error_message(result.error), result.detail);
  });
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.triangle(f))
      add(v, bytes_of_vertex);
  Report report;
  report.distortion = on_host(input, [&](const auto& policy) { return SP::distortion_summary(policy, mesh, sphere); });
  header["report"] = report_json(options, input, report);

  const std::string text = header.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  out << view_page_before_header() << boost::replace_all_copy(text, "<", "\\u003c") // no end of the element
      << view_page_before_data() << to_base64(bytes) << view_page_after_data();
}

void view(const View_options& options)
{
  Mapped_mesh input;
  read_input(options, input);
  check_size_of_page(options.input, input.mesh().number_of_vertices());
  Atomic_files files;
  std::ostream& page = files.open(options.output);
  map_input(options, input);
  write_page(page, options, input);
  files.commit(options.input);
  std::cout << "written: " << options.output << "; open it in a browser" << std::endl;
}

} // namespace

void check_size_of_page(const std::string& input, std::size_t number_of_vertices)
{
  constexpr std::size_t most = std::size_t(1) << 8 * bytes_of_vertex;
  if(number_of_vertices > most)
    throw Refusal(Error_code::TOO_LARGE, input,
                  "has " + std::to_string(number_of_vertices) + " vertices, and a page holds " + std::to_string(most),
                  "simplify the mesh");
}

void add_view_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("view", "Write a page to look at: a mesh and its sphere, in one HTML file");
  const auto options = std::make_shared<View_options>();
  add_input_option(*command, *options);
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  add_file_option(*command, "-o,--output", options->output,
                  "Output file: .html [IN with that extension, in this folder]");
  add_footer(*command, "view bunny.ply -o bunny.html", "the file was written", "it was not (stderr says why)");
  command->callback([options, &exit_code] {
    if(options->output.empty())
      options->output = std::filesystem::path(options->input).filename().replace_extension(".html").string();
    require_extension("--output", options->output, {".html"});
    check_files(input_files(*options), {{"--output", options->output}});
    check_mapping_options(*options);
    exit_code = exit_code_of(guarded(options->input, [&] { view(*options); }));
  });
}

} // namespace tool
