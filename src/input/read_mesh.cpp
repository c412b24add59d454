// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/mesh.h"

#include "input/files.h"
#include "input/mesh_readers.h"
#include "system/error_code_names.h"
#include "system/refusal.h"

#include <CGAL/tags.h>

#include <string_view>
#include <utility>

namespace tool {
namespace {

/// The format that the first line of a file names, as an extension; empty if it names none. STL and OBJ files have no
/// line of that kind.
std::string format_of_content(std::string_view bytes)
{
  const std::size_t end = bytes.substr(0, 16).find_first_of("\r\n");
  const std::string_view word = bytes.substr(0, end == std::string_view::npos ? 0 : end);
  for(const std::string_view off : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"})
    if(word == off)
      return ".off";
  return word == "ply" ? ".ply" : "";
}

void check_extension(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  if(!is_mesh_file(file))
    throw Refusal(unreadable_file, file,
                  extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
                  std::string("meshes are read from ") + mesh_extensions + " files");
}

Soup read_format(const std::string& format, const std::string& file, std::string bytes)
{
  if(format == ".ply")
    return read_ply(file, bytes);
  return (format == ".off" ? read_off : format == ".obj" ? read_obj : read_stl)(file, std::move(bytes));
}

} // namespace

void check_triangles(const std::string& file, const Soup& soup)
{
  if(soup.polygons > 0)
    throw Refusal(name(Error_code::NOT_TRIANGULAR), file,
                  "has " + std::to_string(soup.polygons) +
                    (soup.polygons == 1 ? " face that is no triangle" : " faces that are no triangles") +
                    " (first: face " + std::to_string(soup.first_polygon) + " with " +
                    std::to_string(soup.size_of_first_polygon) + " vertices)",
                  "triangulate the mesh, or use --triangulate");
}

Soup read_soup(const std::string& file, std::string bytes)
{
  check_extension(file);
  const std::string content = format_of_content(bytes);
  return read_format(content.empty() ? lower_case_extension(file) : content, file, std::move(bytes));
}

Input_mesh read_mesh(const std::string& file, Polygons polygons)
{
  check_readable(file);
  check_extension(file); // before the file costs memory
  const Soup soup = read_soup(file, read_file(file));
  if(polygons == Polygons::REFUSE)
    check_triangles(file, soup);
  try {
    return {Mesh(CGAL::Parallel_if_available_tag(), soup.points, soup.triangles), soup.polygons};
  } catch(const CGAL::Spherical_parameterization::Error& error) {
    throw Refusal(name(error.code()), file, "has " + error.detail(), "");
  }
}

} // namespace tool
