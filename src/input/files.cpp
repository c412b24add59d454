// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/files.h"

#include "input/text_lines.h"
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

} // namespace

void check_readable(const std::string& file)
{
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  const auto refuse = [&file](const std::string& wrong, const std::string& remedy) {
    throw Refusal(unreadable_file, file, wrong, remedy);
  };
  if(status.type() == fs::file_type::none)
    refuse("cannot be read (" + error.message() + ")", "check its permissions and those of its folder");
  if(status.type() == fs::file_type::not_found)
    refuse("does not exist", "check the name");
  if(status.type() == fs::file_type::directory)
    refuse("is a directory", "name a file in it");
  if(status.type() != fs::file_type::regular)
    refuse("is not a regular file", "save the data to a file first");
  if(fs::file_size(file) == 0)
    refuse("is empty", "export it again");
  if(!std::ifstream(file))
    refuse("cannot be opened", "check that it may be read");
}

std::string read_file(const std::string& file)
{
  check_readable(file);
  std::string bytes(fs::file_size(file), '\0');
  std::ifstream in(file, std::ios::binary);
  if(!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    throw Refusal(unreadable_file, file, "could not be read completely", "check the disk");
  return bytes;
}

std::string lower_case_extension(const std::string& file) { return lower_case(fs::path(file).extension().string()); }

bool is_mesh_file(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  return extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl";
}

std::vector<std::string> list_meshes(const std::vector<std::string>& inputs, const std::string& list)
{
  std::vector<std::string> names = inputs;
  if(!list.empty()) {
    std::ifstream in(list);
    if(!in)
      throw Refusal(unreadable_file, list, "cannot be read", "check the name");
    for(std::string line; std::getline(in, line);) {
      if(!line.empty() && line.back() == '\r')
        line.pop_back();
      if(!line.empty())
        names.push_back(line);
    }
  }
  std::vector<std::string> files;
  std::set<std::string> known;
  for(const std::string& name : names) {
    std::error_code none;
    for(const std::string& file : fs::is_directory(name, none) ? meshes_in(name) : std::vector<std::string>{name}) {
      if(file.find_first_of("\n\r") != std::string::npos)
        throw Refusal(unreadable_file, file, "has a line break in its name", "rename it");
      if(known.insert(file).second)
        files.push_back(file);
    }
  }
  return files;
}

} // namespace tool
