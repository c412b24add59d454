// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/files.h"

#include "input/compression.h"
#include "input/mesh_format.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <system_error>

namespace tool {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> meshes_in(const std::string& folder)
{
  std::vector<std::string> files;
  std::error_code error;
  std::string last = folder; // looked at: if there is an error, it is the folder that cannot be read
  fs::recursive_directory_iterator it(folder, error), end;
  for(; !error && it != end; it.increment(error)) {
    last = it->path().string();
    const bool is_hidden = it->path().filename().string().front() == '.'; // as what macOS leaves beside a file
    if(is_hidden)
      it.disable_recursion_pending();
    std::error_code none;
    const bool leads_nowhere = it->is_symlink(none) && !it->exists(none); // will be refused: it is missing
    if(!is_hidden && (it->is_regular_file(none) || leads_nowhere) && is_mesh_file(it->path().string()))
      files.push_back(it->path().string());
  }
  if(error)
    refuse_file(last, "cannot be read (" + error.message() + ")", "check its permissions");
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

fs::path place_of(const fs::path& file)
{
  std::error_code error;
  // weakly_canonical() leaves names relative of which no part exists
  const fs::path from_root = fs::absolute(file.empty() ? "." : file, error);
  if(error) // the current folder has been removed
    return file.lexically_normal();
  const fs::path canonical = fs::weakly_canonical(from_root, error);
  const fs::path place = error ? from_root.lexically_normal() : canonical;
  return place.has_filename() ? place : place.parent_path(); // no slash at the end
}

void check_readable(const std::string& file)
{
  if(file == standard_stream)
    return;
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if(status.type() == fs::file_type::none)
    refuse_file(file, "cannot be read (" + error.message() + ")", "check its permissions and those of its folder");
  if(status.type() == fs::file_type::not_found)
    refuse_file(file, "does not exist", "check the name");
  if(status.type() == fs::file_type::directory)
    refuse_file(file, "is a directory", "name a file in it");
  if(status.type() != fs::file_type::regular)
    refuse_file(file, "is not a regular file", "save the data to a file first, or pipe it into '-'");
  if(fs::file_size(file) == 0)
    refuse_file(file, "is empty", "export it again");
  if(!std::ifstream(file))
    refuse_file(file, "cannot be opened", "check that it may be read");
}

std::string read_file(const std::string& file)
{
  check_readable(file);
  if(file == standard_stream) {
    std::string bytes(std::istreambuf_iterator<char>(std::cin), {});
    if(bytes.empty())
      refuse_file(file, "is empty", "pipe a mesh into it");
    return bytes;
  }
  std::string bytes(fs::file_size(file), '\0');
  std::ifstream in(file, std::ios::binary);
  if(!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
    refuse_file(file, "could not be read completely", "check the disk");
  return bytes;
}

std::string read_beginning(const std::string& file, std::size_t size)
{
  check_readable(file);
  std::string bytes(size, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

bool is_numbered(const std::string& file, const std::string& beginning, const std::string& end)
{
  const std::string name = fs::path(file).lexically_normal().string();
  const std::string before = fs::path(beginning).lexically_normal().string();
  return name.size() > before.size() + end.size() && name.compare(0, before.size(), before) == 0 &&
         name.compare(name.size() - end.size(), end.size(), end) == 0 &&
         std::all_of(name.begin() + static_cast<std::ptrdiff_t>(before.size()),
                     name.end() - static_cast<std::ptrdiff_t>(end.size()), [](char c) { return c >= '0' && c <= '9'; });
}

std::vector<std::string> numbered_files(const std::string& beginning, const std::string& end)
{
  std::vector<std::string> files;
  const fs::path folder = fs::path(beginning).parent_path();
  std::error_code none; // of a folder that is not there
  for(const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, none))
    if(const std::string file = (folder / entry.path().filename()).string(); is_numbered(file, beginning, end))
      files.push_back(file);
  return files;
}

std::string lower_case_extension(const std::string& file) { return lower_case(fs::path(file).extension().string()); }

bool is_mesh_file(const std::string& file)
{
  const auto format = format_of_name(file);
  const std::string filename = fs::path(without_compression(file)).filename().string();
  if(format == Mesh_format::FREESURFER) {
    const std::string surface = filename.substr(3); // behind "lh." or "rh."
    const auto begins = [&](const std::string& known) { return surface.compare(0, known.size(), known) == 0; };
    constexpr const char* surfaces[] = {"white",  "pial",     "orig",         "smoothwm",
                                        "sphere", "inflated", "midthickness", "graymid"};
    return std::any_of(std::begin(surfaces), std::end(surfaces), begins);
  }
  if(format == Mesh_format::GIFTI) {
    const std::string kind = lower_case(fs::path(filename).stem().extension().string());
    return kind != ".func" && kind != ".shape" && kind != ".label" && kind != ".time";
  }
  return format.has_value();
}

std::vector<std::string> named_inputs(const std::vector<std::string>& inputs, const std::string& list)
{
  std::vector<std::string> names = inputs;
  if(list.empty())
    return names;
  std::ifstream in(list);
  if(!in)
    refuse_file(list, "cannot be read", "check the name");
  for(std::string line; std::getline(in, line);) {
    if(names.size() == inputs.size())
      line.erase(0, line.size() - without_mark(line).size());
    if(line.find('\0') != std::string::npos)
      refuse_file(list, "has a zero byte, so it is no text", "write the names as UTF-8, one in a line");
    if(!line.empty() && line.back() == '\r')
      line.pop_back();
    if(!line.empty())
      names.push_back(line);
  }
  return names;
}

std::vector<std::string> list_meshes(const std::vector<std::string>& names)
{
  std::vector<std::string> files;
  std::set<std::string> known;
  for(const std::string& name : names) {
    std::error_code none;
    for(const std::string& file : fs::is_directory(name, none) ? meshes_in(name) : std::vector<std::string>{name}) {
      if(file.find_first_of("\n\r") != std::string::npos)
        refuse_file(file, "has a line break in its name", "rename it");
      if(known.insert(file).second)
        files.push_back(file);
    }
  }
  return files;
}

} // namespace tool
