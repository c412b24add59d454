// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/usage.h"

#include "input/mesh_extensions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace tool {
namespace {

namespace fs = std::filesystem;

bool is_same_file(const std::string& a, const std::string& b)
{
  std::error_code error; // of files that do not exist: then their names decide
  return fs::equivalent(a, b, error) || fs::weakly_canonical(a, error) == fs::weakly_canonical(b, error);
}

bool can_be_replaced(const std::string& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  return status.type() == fs::file_type::not_found || status.type() == fs::file_type::regular;
}

} // namespace

void require(bool condition, const std::string& option, const std::string& rule)
{
  if(!condition)
    throw CLI::ValidationError(option, rule);
}

void require_extension(const std::string& option, const std::string& file, const std::vector<std::string>& extensions)
{
  const auto found = std::find(extensions.begin(), extensions.end(), lower_case_extension(file));
  require(found != extensions.end(), option,
          "'" + file + "' must have the extension " + CLI::detail::join(extensions, " or "));
}

void check_files(const std::vector<File_option>& inputs, const std::vector<File_option>& outputs)
{
  std::vector<File_option> files = inputs;
  for(const auto& [option, file] : outputs) {
    if(file.empty())
      continue;
    require(can_be_replaced(file), option, "'" + file + "' exists and is not a regular file");
    for(const auto& [other_option, other_file] : files)
      require(other_file.empty() || !is_same_file(file, other_file), option, "is the same file as " + other_option);
    files.emplace_back(option, file);
  }
}

} // namespace tool
