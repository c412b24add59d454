// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "mapping/mapped_mesh.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"
#include "system/error_code_names.h"
#include "system/guarded.h"
#include "system/interruption.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/segmentation.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;

struct Segment_options : Mapping_options {
  std::string output;
  std::string labels;
  std::optional<std::int64_t> segments;
};

void check(const Segment_options& options)
{
  require_extension("--output", options.output, {".ply"});
  check_files(input_files(options), {{"--output", options.output}, {"--labels", options.labels}});
  require(options.segments.value_or(1) > 0, "--segments", "must be positive");
  check_mapping_options(options);
}

void segment(const Segment_options& options)
{
  Mapped_mesh input;
  read_input(options, input);
  Atomic_file ply(options.output);
  const auto labels = options.labels.empty() ? nullptr : std::make_unique<Atomic_file>(options.labels);
  map_input(options, input, Map_quality::CONVERGED);

  std::vector<std::size_t> segments(input.mesh().number_of_faces());
  SP::Majority_vote method;
  method.number_of_segments = static_cast<std::size_t>(options.segments.value_or(0));
  const SP::Segmentation_result result =
    SP::segmentation_via_area_stretch(input.mesh(), as_map(input.sphere), as_map<Mesh::Face_index>(segments), method);
  if(!result)
    throw Refusal(name(result.error), options.input, get_error_message(result.error), result.detail);

  write_segments_ply(ply.stream(), input.mesh(), segments, result.number_of_segments);
  if(labels)
    for(const std::size_t segment : segments)
      labels->stream() << segment << '\n';
  stop_if_interrupted(options.input);
  Atomic_file::commit_all({labels.get(), &ply});
  std::cout << options.input << ": " << result.number_of_segments << " segments" << std::endl;
}

} // namespace

void add_segment_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("segment", "Segment a shape into body and limbs");
  const auto options = std::make_shared<Segment_options>();
  options->method = "balanced"; // how harmonic maps shrink limbs is what tells them
  options->weights = "clamped"; // as tuned
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  command->add_option("-o,--output", options->output, "Output file: .ply, IN with a colour per segment")
    ->required()
    ->type_name("FILE");
  command
    ->add_option("--labels", options->labels, "Write the segment number of each face, counted from 0, one per line")
    ->type_name("FILE");
  command->add_option("--segments", options->segments,
                      "Number of segments; fewer if the shape has fewer [all that the shape has]");
  command->footer("Example: spherical-parameterization segment bunny.ply -o segments.ply --labels labels.txt\n"
                  "Exit code: 0 the files were written, 1 nothing was written (stderr says why), 2 wrong usage,\n"
                  "130 interrupted.");
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = exit_code_of(guarded(options->input, [&] { segment(*options); }));
  });
}

} // namespace tool
