// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/commands.h"

#include "input/files.h"
#include "mapping/mapped_mesh.h"
#include "options/usage.h"
#include "output/atomic_file.h"
#include "output/write_mesh.h"
#include "system/guarded.h"
#include "system/interruption.h"

#include <CGAL/Spherical_parameterization/texture_coordinates.h>

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;
namespace fs = std::filesystem;

struct Texture_command_options : Mapping_options {
  std::string output;
  std::string chart = "latitude-longitude";
  std::optional<std::array<double, 3>> north;
  std::string image;
};

/// The file next to the output with another extension.
std::string beside(const std::string& output, const char* extension)
{
  return fs::path(output).replace_extension(extension).string();
}

void check(const Texture_command_options& options)
{
  require_extension("--output", options.output, {".obj"});
  std::vector<File_option> inputs = input_files(options),
                           outputs = {{"--output", options.output}, {"the material", beside(options.output, ".mtl")}};
  if(options.image.empty())
    outputs.emplace_back("the image", beside(options.output, ".png"));
  else
    inputs.emplace_back("--image", options.image);
  check_files(inputs, outputs);
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

void print(const Texture_command_options& options, const SP::Texture_report& report)
{
  std::cout.precision(3);
  const auto& north = report.axes.north;
  std::cout << options.output << ": every face has a place in the texture; north pole at " << north[0] << ' '
            << north[1] << ' ' << north[2] << ", " << report.seam_faces << " faces across the seam";
  if(report.moved_faces > 0)
    std::cout << '\n'
              << report.moved_faces << " faces have a moved corner, at most " << report.largest_move
              << " away from that of their neighbours: " << report.unresolved_faces
              << " are smaller than the resolution of floats, " << report.moved_faces - report.unresolved_faces
              << " are too long and thin for the chart";
  std::cout << std::endl;
}

void texture(const Texture_command_options& options)
{
  if(!options.image.empty())
    check_readable(options.image);
  Mapped_mesh input;
  read_input(options, input);
  Atomic_file obj(options.output), mtl(beside(options.output, ".mtl"));
  const std::string image = options.image.empty() ? beside(options.output, ".png") : options.image;
  const auto png = options.image.empty() ? std::make_unique<Atomic_file>(image) : nullptr;
  map_input(options, input);

  std::vector<Uv> uv(3 * input.mesh().number_of_faces());
  const SP::Texture_report report = SP::texture_coordinates(input.mesh(), as_map(input.sphere),
                                                            as_map<Mesh::Halfedge_index>(uv), texture_options(options));

  const fs::path folder = fs::absolute(options.output).parent_path();
  write_textured_obj(obj.stream(), input.mesh(), uv, fs::path(beside(options.output, ".mtl")).filename().string());
  write_material(mtl.stream(), fs::absolute(image).lexically_relative(folder).string());
  if(png)
    write_checker(png->stream(), 32, options.chart == "octahedral" ? 32 : 16);
  stop_if_interrupted(options.input);
  Atomic_file::commit_all({png.get(), &mtl, &obj});
  print(options, report);
}

} // namespace

void add_texture_command(CLI::App& app, int& exit_code)
{
  CLI::App* command =
    app.add_subcommand("texture", "Give a mesh texture coordinates, without flipped or degenerate faces");
  const auto options = std::make_shared<Texture_command_options>();
  add_mapping_options(*command, *options);
  add_sphere_option(*command, *options);
  command
    ->add_option(
      "-o,--output", options->output,
      "Output file of the textured mesh: .obj. The material is written to .mtl and a checker to .png, next to it")
    ->required()
    ->type_name("FILE");
  command->add_option("--chart", options->chart, "Parameterization of the sphere over the plane")
    ->check(CLI::IsMember({"latitude-longitude", "octahedral"}))
    ->capture_default_str();
  command->add_option("--north", options->north, "North pole on the sphere [where the texture has least distortion]")
    ->type_name("X Y Z");
  command->add_option("--image", options->image, "Image of the material, instead of a checker")->type_name("FILE");
  command->footer("Example: spherical-parameterization texture bunny.ply -o textured.obj --chart octahedral\n"
                  "Exit code: 0 the files were written, 1 nothing was written (stderr says why), 2 wrong usage,\n"
                  "130 interrupted.");
  command->callback([options, &exit_code] {
    check(*options);
    exit_code = exit_code_of(guarded(options->input, [&] { texture(*options); }));
  });
}

} // namespace tool
