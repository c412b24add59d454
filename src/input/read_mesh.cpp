// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/read_mesh.h"

#include "input/mesh_extensions.h"
#include "input/mesh_readers.h"
#include "input/readable_file.h"
#include "input/soup_checks.h"
#include "system/refusal.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>

namespace tool {
namespace {

/// The format that the first line of a file names, as an extension; empty if it names none. STL and OBJ files have no
/// line of that kind.
std::string format_of_content(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  std::string start(16, '\0'); // more than the longest of the words
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(in.gcount()));
  const std::size_t end = start.find_first_of("\r\n");
  const std::string word = start.substr(0, end == std::string::npos ? 0 : end);
  for(const char* off : {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"})
    if(word == off)
      return ".off";
  return word == "ply" ? ".ply" : "";
}

Polygon_soup read_soup(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  if(!is_mesh_file(file))
    throw Refusal(unreadable_file, file,
                  extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
                  std::string("meshes are read from ") + mesh_extensions + " files");
  const std::string content = format_of_content(file);
  const std::string& format = content.empty() ? extension : content;
  if(format == ".off")
    return read_off(file);
  if(format == ".obj")
    return read_obj(file);
  if(format == ".ply")
    return read_ply(file);
  return read_stl(file);
}

/// Cuts polygons into fans, which is right for convex ones. Returns how many there were.
std::size_t triangulate(Polygon_soup& soup)
{
  const auto is_polygon = [](const Polygon& p) { return p.size() > 3; };
  const auto polygons = std::count_if(soup.polygons.begin(), soup.polygons.end(), is_polygon);
  if(polygons > 0) {
    std::vector<Polygon> triangles;
    triangles.reserve(soup.polygons.size() + 2 * static_cast<std::size_t>(polygons));
    for(const Polygon& p : soup.polygons)
      for(std::size_t i = 2; i < p.size(); ++i) {
        const std::uint32_t corners[] = {p[0], p[i - 1], p[i]};
        triangles.emplace_back(std::begin(corners), std::end(corners));
      }
    soup.polygons.swap(triangles);
  }
  return static_cast<std::size_t>(polygons);
}

/// \pre `check_triangulated_sphere()` has passed
Mesh build_mesh(const std::string& file, const Polygon_soup& soup)
{
  using Size = Mesh::size_type;
  const auto vertices = static_cast<Size>(soup.points.size());
  const auto faces = static_cast<Size>(soup.polygons.size());
  Mesh mesh;
  mesh.reserve(vertices, faces / 2 * 3, faces);
  for(const Point& p : soup.points)
    mesh.add_vertex(p);
  for(const Polygon& p : soup.polygons)
    if(mesh.add_face(Mesh::Vertex_index(p[0]), Mesh::Vertex_index(p[1]), Mesh::Vertex_index(p[2])) == Mesh::null_face())
      throw Refusal("NON_MANIFOLD", file, "is not a 2-manifold", "repair the mesh");
  return mesh;
}

} // namespace

Input_mesh read_mesh(const std::string& file, Polygons polygons)
{
  check_readable(file);
  Polygon_soup soup = read_soup(file);
  Input_mesh input;
  if(polygons == Polygons::TRIANGULATE)
    input.triangulated_polygons = triangulate(soup);
  check_triangulated_sphere(file, soup);
  input.mesh = build_mesh(file, soup);
  return input;
}

} // namespace tool
