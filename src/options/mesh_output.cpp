// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/mesh_output.h"

#include "options/usage.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace tool {
namespace {

std::vector<std::string> names_of_formats()
{
  std::vector<std::string> names;
  for(const auto& [name, format] : output_formats())
    names.push_back(name);
  return names;
}

} // namespace

void add_mesh_output(CLI::App& command, Mesh_output& options, const std::string& what)
{
  command
    .add_option("-o,--output", options.output,
                what +
                  ": .off, .obj, .ply, .gii, .glb, .gltf or lh.NAME (FreeSurfer), also with .gz, .xz, .zst or .bz2 "
                  "behind; - is the standard output")
    ->required()
    ->type_name("FILE");
  command.add_option("--format", options.format, "Format of the output [by its name; in a folder: ply]")
    ->check(CLI::IsMember(names_of_formats()));
  add_ascii_option(command, options.ascii);
}

void add_ascii_option(CLI::App& command, bool& ascii)
{
  command.add_flag("--ascii", ascii, "Write PLY files as text instead of little-endian binary");
}

Output_format output_format(const Mesh_output& options)
{
  if(options.format.empty()) {
    require(options.output != standard_stream, "--format", "is required for the standard output");
    return output_format_of_name("--output", options.output, options.ascii);
  }
  const auto& formats = output_formats();
  const auto found =
    std::find_if(formats.begin(), formats.end(), [&](const auto& entry) { return entry.first == options.format; });
  return {found->second, options.ascii};
}

Output_format output_format_of_name(const std::string& option, const std::string& file, bool ascii)
{
  const auto format = format_of_name(file);
  require(format && *format != Mesh_format::STL, option,
          "'" + file + "' must have the extension .off, .obj, .ply, .gii, .glb or .gltf, or begin with lh. or rh.");
  return {*format, ascii};
}

} // namespace tool
