// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "runner/step.h"

#include <CGAL/Spherical_parameterization/segmentation.h>

#include <cstdint>
#include <memory>
#include <optional>

namespace tool {
namespace {

/// How harmonic maps shrink limbs is what tells them. Where these have no answer, any other map will do.
void segment(std::optional<std::int64_t> number, Run& run)
{
  Mapped_mesh& input = run.input;
  run.options.falls_back = !run.has("--method");
  run.read();
  run.map(Map_quality::CONVERGED);

  std::vector<std::size_t> segments(input.mesh().number_of_faces());
  SP::Majority_vote method;
  method.number_of_segments = static_cast<std::size_t>(number.value_or(0));
  const SP::Segmentation_result result =
    SP::segmentation_via_area_stretch(input.mesh(), as_map(input.sphere), as_map<Mesh::Face_index>(segments), method);
  if(!result)
    throw Refusal(result.error, run.options.input, get_error_message(result.error), result.detail);

  std::size_t number_of_segments = result.number_of_segments;
  if(input.prepared) {
    segments = labels_of_file(*input.prepared, segments, number_of_segments);
    run.data = input.prepared->soup.data;
  }
  on_mesh_of_file(input, [&](const Mesh& mesh) {
    write_segments_ply(*run.out(), run.ascii, mesh, segments, number_of_segments, run.data);
  });
  if(std::ostream* const labels = run.out("--labels"))
    for(const std::size_t segment : segments)
      *labels << segment << '\n';
  run.details["segments"] = number_of_segments;
  run.commit();
  const std::string name_of_input = run.name_of_input();
  run.line = std::to_string(number_of_segments) + " segments";
  run.text = preparation_text(name_of_input, input.prepared) + name_of_input + ": " + run.line;
  if(!input.result.fallback_reason.empty()) {
    run.line += ", " + input.result.method;
    run.text += "\nautomatic: " + input.result.fallback_reason;
  }
}

Work segment_work()
{
  const auto number = std::make_shared<std::optional<std::int64_t>>();
  Work work = {[number](Run& run) { segment(*number, run); }};
  work.options.add("--segments", *number, "Largest number of segments [as many as the shape has]").in("[1,inf)");
  return work;
}

} // namespace

Step segment_step()
{
  return {"segment",
          "Segment a shape into body and limbs",
          {Takes::EACH, "balanced", "clamped", Takes::OPTION, Prepare::ALL}, // as tuned
          {{"-o,--output",
            "Output file: .ply, IN with a colour per segment; - is the standard output",
            {".ply"},
            Output::FILE,
            Output::REQUIRED},
           {"--labels", "Write the segment number of each face, counted from 0, one per line"}},
          segment_work,
          "segment bunny.ply -o segments.ply --labels labels.txt"};
}

} // namespace tool
