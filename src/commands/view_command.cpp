// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "input/binary.h"
#include "mapping/mapped_mesh.h"
#include "mapping/report.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "system/guarded.h"
#include "system/interruption.h"
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

namespace SP = CGAL::Spherical_parameterization;

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
  SP::face_log_area_stretch(mesh, sphere, of_faces);
  header["stretch"] = add_spread(values);
  SP::face_angle_distortion(mesh, sphere, of_faces);
  header["angle"] = add_spread(values);
  SP::segmentation_via_area_stretch(mesh, sphere, of_faces);
  header["segments"] = add_spread(values);
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.triangle(f))
      add(v, 3);
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
  Atomic_file page(options.output);
  map_input(options, input);
  write_page(page.stream(), options, input);
  stop_if_interrupted(options.input);
  page.commit();
  std::cout << "written: " << options.output << "; open it in a browser" << std::endl;
}

} // namespace

void add_view_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("view", "Write a page to look at: a mesh and its sphere, in one HTML file");
  const auto options = std::make_shared<View_options>();
  add_input_option(*command, *options);
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  command->add_option("-o,--output", options->output, "Output file: .html [IN with that extension, in this folder]")
    ->type_name("FILE");
  command->footer("Example: spherical-parameterization view bunny.ply -o bunny.html\n"
                  "Exit code: 0 the file was written, 1 it was not (stderr says why), 2 wrong usage, 130 interrupted.");
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
