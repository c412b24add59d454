// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "runner/step.h"

#include "input/binary.h"
#include "output/page.h"
#include "view_page.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/segmentation.h>

#include <algorithm>
#include <cmath>

namespace tool {
namespace {

/// Fills the page with a header in JSON and with the arrays of web/src/view_page.ts, the lowest bytes first.
void write_page(std::ostream& out, Run& run)
{
  const Mapped_mesh& input = run.input;
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
      throw Refusal(result.error, run.options.input, get_error_message(result.error), result.detail);
  });
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.triangle(f))
      add(v, bytes_of_vertex);
  run.figures.distortion =
    on_host(input, [&](const auto& policy) { return SP::distortion_summary(policy, mesh, sphere); });
  header["report"] = report_json(run.options, input, run.figures);

  out << view_page_before_header() << inside_of_page(header) << view_page_before_data() << to_base64(bytes)
      << view_page_after_data();
}

void view(Run& run)
{
  run.read();
  check_size_of_page(run.options.input, run.mesh().number_of_vertices());
  run.map();
  write_page(*run.out(), run);
  run.commit();
  run.line = std::to_string(run.mesh().number_of_vertices()) + " vertices";
  run.text = preparation_text(run.name_of_input(), run.input.prepared) + "written: " + run.name_of_output() +
             "; open it in a browser";
}

} // namespace

Step view_step()
{
  Takes takes = {Takes::EACH, "automatic", "conformal", Takes::OPTION, Prepare::ALL};
  takes.prepared = "the page shows the repaired mesh";
  return {"view",
          "Write a web page that shows a mesh and its sphere, as one HTML file",
          takes,
          {{"-o,--output",
            "Output file: .html [IN with that extension, in this folder]",
            {".html"},
            Output::FILE,
            Output::ALWAYS}},
          [] { return Work{view}; },
          "view bunny.ply -o bunny.html"};
}

} // namespace tool
