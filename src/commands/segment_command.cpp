// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/mesh_command.h"

#include "system/standard_output.h"

#include <CGAL/Spherical_parameterization/segmentation.h>

#include <cstdint>
#include <optional>

namespace tool {
namespace {

struct Segment_options : Mesh_options {
  std::string labels;
  std::optional<std::int64_t> segments;
};

void check_segment_options(const Segment_options& options)
{
  if(options.output != standard_stream)
    require_extension("--output", options.output, {".ply"});
  require(options.segments.value_or(1) > 0, "--segments", "must be positive");
  check_mapping_options(options);
}

void segment(const Segment_options& options, Outcome& outcome)
{
  Mapped_mesh input;
  read_input(options, input);
  Atomic_files files;
  std::ostream& ply = files.open(options.output);
  std::ostream* const labels = files.open_if_named(options.labels);
  map_input(options, input, Map_quality::CONVERGED);

  std::vector<std::size_t> segments(input.mesh().number_of_faces());
  SP::Majority_vote method;
  method.number_of_segments = static_cast<std::size_t>(options.segments.value_or(0));
  const SP::Segmentation_result result =
    SP::segmentation_via_area_stretch(input.mesh(), as_map(input.sphere), as_map<Mesh::Face_index>(segments), method);
  if(!result)
    throw Refusal(result.error, options.input, get_error_message(result.error), result.detail);

  std::size_t number_of_segments = result.number_of_segments;
  if(input.prepared)
    segments = labels_of_file(*input.prepared, segments, number_of_segments);
  on_mesh_of_file(
    input, [&](const Mesh& mesh) { write_segments_ply(ply, options.ascii, mesh, segments, number_of_segments); });
  if(labels)
    for(const std::size_t segment : segments)
      *labels << segment << '\n';
  files.commit(options.input);
  const std::string name_of_input = shown(options.input, "standard input");
  outcome.line = std::to_string(number_of_segments) + " segments";
  outcome.text = preparation_text(name_of_input, input.prepared) + name_of_input + ": " + outcome.line;
  if(!input.result.fallback_reason.empty()) {
    outcome.line += ", " + input.result.method;
    outcome.text += "\nautomatic: " + input.result.fallback_reason;
  }
}

const Mesh_command<Segment_options> segment_command = {
  ".ply", check_segment_options, segment, {{"--labels", &Segment_options::labels}}};

} // namespace

void add_segment_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("segment", "Segment a shape into body and limbs");
  const auto options = std::make_shared<Segment_options>();
  options->method = "balanced"; // how harmonic maps shrink limbs is what tells them
  options->weights = "clamped"; // as tuned
  add_collection_options(*command, *options);
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  add_prepare_option(*command, *options, Prepare::ALL);
  add_file_option(*command, "-o,--output", options->output,
                  "Output file: .ply, IN with a colour per segment; - is the standard output. Of several IN: a folder")
    ->required();
  add_file_option(*command, "--labels", options->labels,
                  "Write the segment number of each face, counted from 0, one per line");
  add_ascii_option(*command, options->ascii);
  command->add_option("--segments", options->segments,
                      "Number of segments; fewer if the shape has fewer [all that the shape has]");
  add_footer(*command, "segment bunny.ply -o segments.ply --labels labels.txt");
  command->callback([options, command, &exit_code] {
    options->falls_back = command->count("--method") == 0;
    exit_code = run_mesh_command(*command, segment_command, *options);
  });
}

} // namespace tool
