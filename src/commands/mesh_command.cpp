// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "commands/mesh_command.h"

#include <filesystem>
#include <system_error>

namespace tool {

std::string settings_text(const CLI::App& command, const std::set<std::string>& left_out)
{
  static const std::set<std::string> others = {"IN", "--list", "--jobs", "--output"};
  std::string text = command.get_name();
  for(const CLI::Option* option : command.get_options())
    if(option->count() > 0 && others.count(option->get_name()) == 0 && left_out.count(option->get_name()) == 0)
      text += ' ' + option->get_name() + '=' + CLI::detail::join(option->results(), ",");
  return text;
}

void check_output_folder(const std::string& folder)
{
  std::error_code none;
  const bool is_folder = std::filesystem::is_directory(folder, none);
  require(is_folder || !std::filesystem::exists(folder, none), "--output",
          "'" + folder + "' is a file; the output of several meshes is a folder");
  require(is_folder || !is_mesh_file(folder), "--output",
          "'" + folder + "' has the extension of a mesh; the output of several meshes is a folder");
}

} // namespace tool
