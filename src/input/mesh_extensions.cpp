// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/mesh_extensions.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace tool {

std::string lower_case_extension(const std::string& file)
{
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

bool is_mesh_file(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  return extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl";
}

} // namespace tool
