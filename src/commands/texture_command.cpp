// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/mesh_command.h"

#include <CGAL/Spherical_parameterization/texture_coordinates.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <optional>
#include <sstream>

namespace tool {
namespace {

namespace fs = std::filesystem;

struct Texture_command_options : Mesh_options {
  std::string chart = "latitude-longitude";
  std::optional<std::array<double, 3>> north;
  std::string image;
};

/// The file next to the output with another extension.
std::string beside(const std::string& output, const char* extension)
{
  return fs::path(output).replace_extension(extension).string();
}

/// Whether material and image are files of their own; glTF has them inside.
bool is_obj(const Texture_command_options& options) { return output_format(options).format == Mesh_format::OBJ; }

std::vector<File_option> texture_inputs(const Texture_command_options& options) { return {{"--image", options.image}}; }

std::vector<File_option> texture_outputs(const Texture_command_options& options)
{
  if(!is_obj(options))
    return {};
  return {{"the material", beside(options.output, ".mtl")},
          {"the image", options.image.empty() ? beside(options.output, ".png") : ""}};
}

void check_texture_options(const Texture_command_options& options)
{
  if(options.format.empty())
    require_extension("--output", options.output, {".obj", ".glb", ".gltf"});
  if(options.north) {
    const auto& n = *options.north;
    const double length = std::hypot(n[0], n[1], n[2]);
    require(std::isfinite(length) && length > 0, "--north", "must not be the zero vector");
  }
  check_mapping_options(options);
}

SP::Texture_options texture_options(const Texture_command_options& options)
{
  SP::Texture_options result;
  if(options.chart == "octahedral")
    result.chart = SP::Texture_chart::OCTAHEDRAL;
  if(options.north) {
    // longitude 0 at the coordinate axis that is farthest from the pole
    SP::Texture_axes axes = {*options.north, {0, 0, 0}};
    std::size_t least = 0;
    for(std::size_t i = 1; i < 3; ++i)
      if(std::abs(axes.north[i]) < std::abs(axes.north[least]))
        least = i;
    axes.meridian[least] = 1;
    result.axes = axes;
  }
  result.bits = 23; // viewers read floats
  return result;
}

void say(const Texture_command_options& options, const Mapped_mesh& input, const SP::Texture_report& report,
         Outcome& outcome)
{
  std::ostringstream line, more;
  line.precision(3);
  more.precision(3);
  const auto& north = report.axes.north;
  line << "every face has a place in the texture; north pole at " << north[0] << ' ' << north[1] << ' ' << north[2]
       << ", " << report.seam_faces << " faces across the seam";
  if(report.moved_faces > 0)
    more << '\n'
         << report.moved_faces << " faces have a moved corner, at most " << report.largest_move
         << " away from that of their neighbours: " << report.unresolved_faces
         << " are smaller than the resolution of floats, " << report.moved_faces - report.unresolved_faces
         << " are too long and thin for the chart";
  outcome.line = line.str();
  if(report.moved_faces > 0)
    outcome.line += ", " + std::to_string(report.moved_faces) + " faces with a moved corner";
  outcome.text = preparation_text(options.input, input.prepared) + options.output + ": " + line.str() + more.str();
}

int checker_rows(const Texture_command_options& options) { return options.chart == "octahedral" ? 32 : 16; }

/// The texture coordinates, one per halfedge, of the mesh of the file.
std::pair<std::vector<Uv>, SP::Texture_report> coordinates(const Texture_command_options& options,
                                                           const Mapped_mesh& input)
{
  std::vector<Uv> uv(3 * input.mesh().number_of_faces());
  const SP::Texture_report report = SP::texture_coordinates(input.mesh(), as_map(input.sphere),
                                                            as_map<Mesh::Halfedge_index>(uv), texture_options(options));
  if(input.prepared)
    uv = coordinates_of_file(*input.prepared, uv);
  return {uv, report};
}

/// Mesh, material and image as three files.
void texture_obj(const Texture_command_options& options, Mapped_mesh& input, Outcome& outcome)
{
  Atomic_files files;
  std::ostream &obj = files.open(options.output), &mtl = files.open(beside(options.output, ".mtl"));
  const std::string image = options.image.empty() ? beside(options.output, ".png") : options.image;
  std::ostream* const png = options.image.empty() ? &files.open(image) : nullptr;
  map_input(options, input);
  const auto [uv, report] = coordinates(options, input);

  const fs::path folder = fs::absolute(options.output).parent_path();
  const std::string material = fs::path(beside(options.output, ".mtl")).filename().string();
  on_mesh_of_file(input, [&, &uv = uv](const Mesh& mesh) { write_textured_obj(obj, mesh, uv, material); });
  write_material(mtl, fs::absolute(image).lexically_relative(folder).string());
  if(png)
    write_checker(*png, 32, checker_rows(options));
  files.commit(options.input);
  say(options, input, report, outcome);
}

/// The image for glTF, which has it inside.
std::string image_of(const Texture_command_options& options)
{
  if(options.image.empty()) {
    std::ostringstream png;
    write_checker(png, 32, checker_rows(options));
    return png.str();
  }
  std::string image = read_file(options.image);
  if(type_of_image(image).empty())
    throw Refusal(unreadable_file, options.image, "is neither PNG nor JPEG, which is what glTF files can hold",
                  "convert it, or write .obj");
  return image;
}

void texture_gltf(const Texture_command_options& options, Mapped_mesh& input, Outcome& outcome)
{
  Atomic_files files;
  std::ostream& file = files.open(options.output);
  const std::string image = image_of(options);
  map_input(options, input);
  const auto [uv, report] = coordinates(options, input);
  on_mesh_of_file(input, [&, &uv = uv](const Mesh& mesh) {
    write_textured_gltf(file, output_format(options).format, mesh, uv, image);
  });
  files.commit(options.input);
  say(options, input, report, outcome);
}

void texture(const Texture_command_options& options, Outcome& outcome)
{
  if(!options.image.empty())
    check_readable(options.image);
  Mapped_mesh input;
  read_input(options, input);
  (is_obj(options) ? texture_obj : texture_gltf)(options, input, outcome);
}

const Mesh_command<Texture_command_options> texture_command = {".obj", check_texture_options, texture,
                                                               {},     texture_inputs,        texture_outputs};

} // namespace

void add_texture_command(CLI::App& app, int& exit_code)
{
  CLI::App* command =
    app.add_subcommand("texture", "Give a mesh texture coordinates, without flipped or degenerate faces");
  const auto options = add_mesh_command(*command, texture_command, exit_code);
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  add_prepare_option(*command, *options, Prepare::ALL);
  add_file_option(*command, "-o,--output", options->output,
                  "Output file of the textured mesh: .glb or .gltf with the image inside, or .obj, with the material "
                  "and a checker next to it as .mtl and .png. Of several IN: a folder")
    ->required();
  command->add_option("--format", options->format, "Format of the output [by its name; of several IN: obj]")
    ->check(CLI::IsMember({"obj", "glb", "gltf"}));
  add_checked_option(*command, "--chart", options->chart, "Parameterization of the sphere over the plane",
                     CLI::IsMember({"latitude-longitude", "octahedral"}));
  command->add_option("--north", options->north, "North pole on the sphere [where the texture has least distortion]")
    ->type_name("X Y Z");
  add_file_option(*command, "--image", options->image,
                  "Image of the material, instead of a checker; PNG or JPEG for .glb and .gltf");
  add_footer(*command, "texture bunny.ply -o textured.obj --chart octahedral");
}

} // namespace tool
