// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/mesh_command.h"

#include "preparation/prepare.h"
#include "system/standard_output.h"

#include <CGAL/Spherical_parameterization/resample.h>

#include <array>
#include <sstream>

namespace tool {
namespace {

/// What may be lost without a word, of the diagonal and of a side of the bounding box.
constexpr double largest_distance = 0.01, largest_loss_of_box = 0.03;

struct Resample_options : Mesh_options {
  std::string output_sphere;
  int level = 6;
};

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
  Atomic_files files;
  std::ostream& file = files.open(options.output);
  std::ostream* const sphere_file = files.open_if_named(options.output_sphere);
  map_input(options, input);

  std::vector<Point> directions;
  std::vector<std::array<int, 3>> triangles;
  SP::make_icosphere_soup(options.level, directions, triangles);
  const Mesh out(directions, triangles);
  const SP::Spherical_locator<Mesh> shape(input.mesh(), as_map(input.sphere));
  std::vector<Point> points;
  for(const Point& direction : out.points())
    points.push_back(point_at(shape, direction));
  write_mesh(file, output_format(options), out, points, Surface::SHAPE, input.file->annotations);
  if(sphere_file)
    write_mesh(*sphere_file, output_format_of_name("--output-sphere", options.output_sphere, options.ascii), out,
               out.points(), Surface::SPHERE, input.file->annotations);
  const Sampling_loss loss = sampling_loss(input.mesh(), out, points);
  files.commit(options.input);
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
  ".ply", check_resample_options, resample, {{"--output-sphere", &Resample_options::output_sphere}}};

} // namespace

void add_resample_command(CLI::App& app, int& exit_code)
{
  CLI::App* command = app.add_subcommand("resample", "Sample a shape at the vertices of an icosphere");
  const auto options = add_mesh_command(*command, resample_command, exit_code);
  options->method = "isometric"; // which loses no limb
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  add_mesh_output(*command, *options, "Output file of the new mesh; of several IN a folder");
  add_file_option(*command, "--output-sphere", options->output_sphere,
                  "Write the icosphere as well: it is the map of the new mesh");
  add_checked_option(*command, "--level", options->level, "The new mesh has 10 * 4^LEVEL + 2 vertices",
                     CLI::Range(0, SP::largest_icosphere_level));
  add_footer(*command, "resample bunny.ply -o icosphere.off --level 7", "the mesh was written");
}

} // namespace tool
