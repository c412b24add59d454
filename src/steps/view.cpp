// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/page.h"
#include "runner/step.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>
#include <CGAL/Spherical_parameterization/segmentation.h>

namespace tool {
namespace {

void write_page(std::ostream& out, Run& run)
{
  const Mapped_mesh& input = run.input;
  const Mesh& mesh = input.mesh();
  const auto sphere = as_map(input.sphere);
  const Stopwatch measuring;
  Page page;
  page.add(mesh.points());
  page.add(input.sphere);
  std::vector<double> values(mesh.number_of_faces());
  const auto of_faces = as_map<Mesh::Face_index>(values);
  const auto add_measure = [&](const char* name, const auto& measure) {
    on_host(input, measure);
    page.header[name] = page.add(values);
  };
  add_measure("stretch", [&](const auto& policy) { SP::face_log_area_stretch(policy, mesh, sphere, of_faces); });
  add_measure("angle", [&](const auto& policy) { SP::face_angle_distortion(policy, mesh, sphere, of_faces); });
  add_measure("segments", [&](const auto& policy) {
    const SP::Segmentation_result result = SP::segmentation_via_area_stretch(
      policy, mesh, sphere, of_faces, SP::Majority_vote(), stopped_as_map(run.options, input));
    check_answer(run.options, result.error, result.detail);
  });
  page.add(mesh);
  run.figures.distortion =
    on_host(input, [&](const auto& policy) { return SP::distortion_summary(policy, mesh, sphere); });
  run.figures.seconds_measure = measuring.seconds();
  nlohmann::json report = report_json(run.options, input, run.figures);
  for(const char* later : {"write", "total"})
    report["seconds"].erase(later);
  page.header["report"] = std::move(report);
  page.write(out);
}

void view(Run& run)
{
  run.read();
  Page::check_size(run.options.input, run.mesh().number_of_vertices());
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
  return {"view",
          "Write a web page that shows a mesh and its sphere, as one HTML file",
          {Takes::EACH, "automatic", "conformal", Takes::OPTION, Prepare::ALL, "the page shows the repaired mesh"},
          {{"-o,--output",
            "Output file: .html [IN with that extension, in this folder]",
            {".html"},
            Output::FILE,
            Output::ALWAYS}},
          [] { return Work{view}; },
          "view bunny.ply -o bunny.html"};
}

} // namespace tool
