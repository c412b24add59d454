// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "read_soup.h"

#include "input/mesh_extensions.h"
#include "input/mesh_readers.h"
#include "input/readable_file.h"
#include "system/refusal.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace page {
namespace {

/// The file system in memory that emscripten has: the readers of the tool read files.
class File {
public:
  File(const std::string& name, const std::string& bytes) : name_(name)
  {
    std::ofstream(name, std::ios::binary) << bytes;
  }
  ~File() { std::remove(name_.c_str()); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

private:
  std::string name_;
};

tool::Polygon_soup read_polygons(const std::string& name, const std::string& bytes)
{
  const std::string extension = tool::lower_case_extension(name);
  if(!tool::is_mesh_file(name))
    throw tool::Refusal(tool::unreadable_file, name,
                        extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
                        std::string("meshes are read from ") + tool::mesh_extensions + " files");
  const File file(name, bytes);
  tool::check_readable(name);
  const std::string word = bytes.substr(0, std::min(bytes.find_first_of("\r\n"), std::string::size_type(16)));
  for(const char* off : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"})
    if(word == off)
      return tool::read_off(name);
  if(word == "ply" || extension == ".ply")
    return tool::read_ply(name);
  if(extension == ".off")
    return tool::read_off(name);
  return extension == ".obj" ? tool::read_obj(name) : tool::read_stl(name);
}

} // namespace

Soup read_soup(const std::string& name, const std::string& bytes, bool triangulate)
{
  const tool::Polygon_soup read = read_polygons(name, bytes);
  Soup soup;
  for(const tool::Point& p : read.points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  const auto is_polygon = [](const tool::Polygon& p) { return p.size() > 3; };
  const auto first = std::find_if(read.polygons.begin(), read.polygons.end(), is_polygon);
  const auto count = std::count_if(first, read.polygons.end(), is_polygon);
  if(count > 0 && !triangulate)
    throw tool::Refusal("NOT_TRIANGULAR", name,
                        "has " + std::to_string(count) +
                          (count == 1 ? " face that is no triangle" : " faces that are no triangles") +
                          " (first: face " + std::to_string(first - read.polygons.begin()) + " with " +
                          std::to_string(first->size()) + " vertices)",
                        "triangulate the mesh, or use --triangulate");
  for(const tool::Polygon& p : read.polygons)
    for(std::size_t i = 2; i < p.size(); ++i)
      soup.triangles.push_back({int(p[0]), int(p[i - 1]), int(p[i])});
  return soup;
}

} // namespace page
