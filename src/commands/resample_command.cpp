// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"
#include "commands/mesh_command.h"

#include "mapping/mapped_mesh.h"
#include "preparation/surface_distance.h"
#include "options/mesh_output.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/resample.h>

#include <CLI/CLI.hpp>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;

/// What may be lost without a word, of the diagonal and of a side of the bounding box.
constexpr double largest_distance = 0.01, largest_loss_of_box = 0.03;

struct Resample_options : Mesh_options {
  std::string output_sphere;
  int level = 6;
};

std::vector<File_option> resample_inputs(const Resample_options& options) { return input_files(options); }

std::vector<File_option> resample_outputs(const Resample_options& options)
{
  return {{"--output", options.output}, {"--output-sphere", options.output_sphere}};
}

void check_resample_options(const Resample_options& options)
{
  output_format(options);
  if(!options.output_sphere.empty())
    output_format_of_name("--output-sphere", options.output_sphere, options.ascii);
  check_mapping_options(options);
}

/// The point of the shape that is mapped to the direction.
Point point_at(const SP::Spherical_locator<Mesh>& shape, const Point& direction)
{
  const auto place = shape.locate(direction);
  Point point;
  for(std::size_t k = 0; k < 3; ++k)
    point[k] = SP::interpolate(shape.mesh(), place,
                               boost::make_function_property_map<Mesh::Vertex_index>([&](Mesh::Vertex_index v) {
                                 return shape.mesh().points()[static_cast<std::size_t>(v.idx())][k];
                               }));
  return point;
}

void resample(const Resample_options& options, Outcome& outcome)
{
  Mapped_mesh input;
  read_input(options, input);
  Atomic_file file(options.output);
  const auto sphere_file =
    options.output_sphere.empty() ? nullptr : std::make_unique<Atomic_file>(options.output_sphere);
  map_input(options, input);

  const SP::internal::Icosphere icosphere(options.level);
  const Mesh out(icosphere.points, icosphere.triangles);
  const SP::Spherical_locator<Mesh> shape(input.mesh(), as_map(input.sphere));
  std::vector<Point> points;
  for(const Point& direction : out.points())
    points.push_back(point_at(shape, direction));
  write_mesh(file.stream(), output_format(options), out, points, Surface::SHAPE, input.file->annotations);
  if(sphere_file)
    write_mesh(sphere_file->stream(), output_format_of_name("--output-sphere", options.output_sphere, options.ascii),
               out, out.points(), Surface::SPHERE, input.file->annotations);
  const Sampling_loss loss = sampling_loss(input.mesh(), out, points);
  stop_if_interrupted(options.input);
  Atomic_file::commit_all({sphere_file.get(), &file});
  std::ostringstream line;
  line.precision(2);
  line << out.number_of_vertices() << " vertices, " << out.number_of_faces() << " faces; " << input.result.method
       << (input.result.method.empty() ? "" : " map; ") << "99 % of the shape is within " << 100 * loss.distance
       << " % of its diagonal, the bounding box has lost " << 100 * loss.bounding_box << " %";
  if(loss.distance > largest_distance || loss.bounding_box > largest_loss_of_box)
    line << "; part of the shape is lost, where the map is small: try --method isometric, --area-exponent 30 or a "
            "larger --level";
  outcome.line = line.str();
  outcome.text = shown(options.output, "standard output") + ": " + outcome.line;
}

const Mesh_command<Resample_options> resample_command = {
  ".ply", {&Resample_options::output_sphere}, check_resample_options, resample_inputs, resample_outputs, resample};

} // namespace

void add_resample_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("resample", "Sample a shape at the vertices of an icosphere");
  const auto options = std::make_shared<Resample_options>();
  options->method = "isometric"; // which loses no limb
  add_collection_options(*command, *options);
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  add_mesh_output(*command, *options, "Output file of the new mesh; of several IN a folder");
  command
    ->add_option("--output-sphere", options->output_sphere,
                 "Write the icosphere as well: it is the map of the new mesh")
    ->type_name("FILE");
  command->add_option("--level", options->level, "The new mesh has 10 * 4^LEVEL + 2 vertices")
    ->check(CLI::Range(0, SP::largest_icosphere_level))
    ->capture_default_str();
  command->footer("Example: spherical-parameterization resample bunny.ply -o icosphere.off --level 7\n"
                  "Exit code: 0 the mesh was written, 1 nothing was written (stderr says why), 2 wrong usage,\n"
                  "130 interrupted.");
  command->callback(
    [options, command, &exit_code] { exit_code = run_mesh_command(*command, resample_command, *options); });
}

} // namespace tool
