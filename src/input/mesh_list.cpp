// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/mesh_list.h"

#include "input/mesh_extensions.h"
#include "system/refusal.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

namespace tool {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> meshes_in(const std::string& folder)
{
  std::vector<std::string> files;
  std::error_code error;
  fs::recursive_directory_iterator it(folder, error), end;
  for(; !error && it != end; it.increment(error)) {
    std::error_code none; // of a link to nowhere: no regular file
    if(it->is_regular_file(none) && is_mesh_file(it->path().string()))
      files.push_back(it->path().string());
  }
  if(error)
    throw Refusal(unreadable_file, folder, "cannot be read (" + error.message() + ")", "check its permissions");
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> lines_of(const std::string& list)
{
  std::ifstream in(list);
  if(!in)
    throw Refusal(unreadable_file, list, "cannot be read", "check the name");
  std::vector<std::string> lines;
  for(std::string line; std::getline(in, line);) {
    if(!line.empty() && line.back() == '\r')
      line.pop_back();
    if(!line.empty())
      lines.push_back(line);
  }
  return lines;
}

} // namespace

std::vector<std::string> list_meshes(const std::vector<std::string>& inputs, const std::string& list)
{
  std::vector<std::string> names = inputs;
  if(!list.empty()) {
    const std::vector<std::string> lines = lines_of(list);
    names.insert(names.end(), lines.begin(), lines.end());
  }
  std::vector<std::string> files;
  std::set<std::string> known;
  const auto add = [&](const std::string& file) {
    if(file.find_first_of("\n\r") != std::string::npos)
      throw Refusal(unreadable_file, file, "has a line break in its name", "rename it");
    if(known.insert(file).second)
      files.push_back(file);
  };
  for(const std::string& name : names) {
    std::error_code none;
    if(!fs::is_directory(name, none)) {
      add(name);
      continue;
    }
    for(const std::string& file : meshes_in(name))
      add(file);
  }
  return files;
}

} // namespace tool
