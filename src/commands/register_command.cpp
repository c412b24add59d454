// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "mapping/registered_pair.h"
#include "options/mesh_output.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "output/text_writer.h"
#include "output/write_json.h"
#include "output/write_mesh.h"
#include "system/refusal.h"

#include <CLI/CLI.hpp>

#include <cstddef>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace tool {
namespace {

struct Register_options : Registration_options, Mesh_output {
  std::string output_sphere;
  std::string correspondence;
  std::string report;
};

void write_correspondence(std::ostream& out, const std::vector<Place>& places)
{
  Text_writer write(out);
  write("vertex,face,w0,w1,w2\n");
  for(std::size_t v = 0; v < places.size(); ++v) {
    const auto& [face, weights] = places[v];
    write(v, ',', face, ',', weights[0], ',', weights[1], ',', weights[2], '\n');
  }
}

void register_meshes(const Register_options& options)
{
  Registered_pair pair;
  read_pair(options, pair);
  Atomic_files files;
  std::ostream* const file = files.open_if_named(options.output);
  std::ostream* const sphere_file = files.open_if_named(options.output_sphere);
  std::ostream* const correspondence_file = files.open_if_named(options.correspondence);
  std::ostream* const report_file = files.open_if_named(options.report);
  register_pair(options, pair);

  if(file)
    write_mesh(*file, output_format(options), pair.a.mesh(), pair.points_on_b, Surface::SHAPE,
               pair.a.file->annotations);
  if(sphere_file) {
    const Output_format format = output_format_of_name("--output-sphere", options.output_sphere, options.ascii);
    certify_as_stored(options.output_sphere, format.format, pair.a, pair.registered);
    write_mesh(*sphere_file, format, pair.a.mesh(), pair.registered, Surface::SPHERE, pair.a.file->annotations);
  }
  if(correspondence_file)
    write_correspondence(*correspondence_file, places_by_files(pair));
  if(report_file)
    write_json(*report_file, registration_json(options, pair));
  files.commit(options.input);
  std::cout.precision(3);
  std::cout << preparation_text(options, pair) << (file ? options.output : options.correspondence) << ": "
            << options.input << " in the shape of " << options.other << ", " << pair.a.mesh().number_of_vertices()
            << " vertices\n"
            << "registered map: " << pair.result.flipped_faces << " flipped faces, degree " << pair.result.degree
            << "; start by " << pair.result.start;
  if(options.motion == "deformation")
    std::cout << ", then deformed: mismatch of features from " << pair.result.mismatch_before << " to "
              << pair.result.mismatch << ", mean distortion " << pair.result.distortion << " (4: none)";
  if(!options.landmarks.empty())
    std::cout << "\nlandmarks: at most " << pair.result.largest_landmark_distance << " radians from their places";
  std::cout << '\n'
            << trust_text(pair.result) << pair.result.seconds.total << " s, and "
            << pair.a.result.seconds.total + pair.b.result.seconds.total << " s for the maps" << std::endl;
}

} // namespace

void add_register_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("register", "Find corresponding points of two shapes: A in the shape of B");
  const auto options = std::make_shared<Register_options>();
  add_registration_options(*command, *options);
  add_mesh_output(*command, *options, "Output file: the mesh A, its vertices at the corresponding points of B");
  command->get_option("--output")->required(false);
  add_file_option(*command, "--correspondence", options->correspondence,
                  "Write the place on B of every vertex of A: a .csv file of lines 'vertex,face,w0,w1,w2', a face of B "
                  "and the weights of its corners; then --output may be left out");
  add_file_option(*command, "--output-sphere", options->output_sphere,
                  "Write the registered sphere of A: equal points of it and of the sphere of B correspond");
  add_file_option(*command, "--report", options->report, "Write certificate, figures and times as JSON");
  add_footer(*command, "register lion1.obj lion2.obj -o lion1_as_2.ply");
  command->callback([options, &exit_code] {
    require(!options->output.empty() || !options->correspondence.empty(), "--output",
            "is required, or --correspondence");
    if(!options->output.empty())
      output_format(*options);
    if(!options->correspondence.empty())
      require_extension("--correspondence", options->correspondence, {".csv"});
    if(!options->output_sphere.empty())
      output_format_of_name("--output-sphere", options->output_sphere, options->ascii);
    check_registration_options(*options);
    check_files(registration_inputs(*options), {{"--output", options->output},
                                                {"--output-sphere", options->output_sphere},
                                                {"--correspondence", options->correspondence},
                                                {"--report", options->report}});
    exit_code = exit_code_of(guarded(options->input, [&] { register_meshes(*options); }));
  });
}

} // namespace tool
