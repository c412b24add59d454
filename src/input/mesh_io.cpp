// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/mesh_io.h"

#include "input/mesh_readers.h"
#include "input/refusal.h"
#include "input/soup_checks.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <system_error>

namespace tool {
namespace {

namespace fs = std::filesystem;

void check_file(const std::string& file)
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
    refuse("is no regular file", "save the mesh to a file first");
  if(fs::file_size(file) == 0)
    refuse("is empty", "export it again");
  if(!std::ifstream(file))
    refuse("cannot be opened", "check that it may be read");
}

Polygon_soup read_soup(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  if(extension == ".off")
    return read_off(file);
  if(extension == ".obj")
    return read_obj(file);
  if(extension == ".ply")
    return read_ply(file);
  if(extension == ".stl")
    return read_stl(file);
  throw Refusal(unreadable_file, file,
                extension.empty() ? "has no extension" : "has the unknown extension '" + extension + "'",
                "meshes are read from .off, .obj, .ply and .stl files");
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
      throw Refusal("NON_MANIFOLD", file, "is no 2-manifold", "repair the mesh");
  return mesh;
}

} // namespace

std::string lower_case_extension(const std::string& file)
{
  std::string extension = fs::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Input_mesh read_mesh(const std::string& file, Polygons polygons)
{
  check_file(file);
  Polygon_soup soup = read_soup(file);
  Input_mesh input;
  if(polygons == Polygons::TRIANGULATE)
    input.triangulated_polygons = triangulate(soup);
  check_triangulated_sphere(file, soup);
  input.mesh = build_mesh(file, soup);
  return input;
}

bool is_mesh_file(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  return extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl";
}

Mesh_format output_format(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  return extension == ".off"   ? Mesh_format::OFF
         : extension == ".obj" ? Mesh_format::OBJ
         : extension == ".ply" ? Mesh_format::PLY
                               : Mesh_format::UNKNOWN;
}

void write_faces(std::ostream& out, const Mesh& mesh)
{
  for(const Mesh::Face_index f : mesh.faces()) {
    out << '3';
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << ' ' << v.idx();
    out << '\n';
  }
}

void write_mesh(std::ostream& out, Mesh_format format, const Mesh& mesh, Sphere_map sphere)
{
  out.precision(std::numeric_limits<double>::max_digits10);
  if(format == Mesh_format::OFF)
    out << "OFF\n" << mesh.number_of_vertices() << ' ' << mesh.number_of_faces() << " 0\n";
  else if(format == Mesh_format::PLY)
    out << "ply\nformat ascii 1.0\nelement vertex " << mesh.number_of_vertices()
        << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.number_of_faces()
        << "\nproperty list uchar int vertex_indices\nend_header\n";

  const char* vertex = format == Mesh_format::OBJ ? "v " : "";
  for(const Mesh::Vertex_index v : mesh.vertices())
    out << vertex << sphere[v].x() << ' ' << sphere[v].y() << ' ' << sphere[v].z() << '\n';

  if(format != Mesh_format::OBJ) {
    write_faces(out, mesh);
    return;
  }
  for(const Mesh::Face_index f : mesh.faces()) {
    out << 'f';
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << ' ' << v.idx() + 1;
    out << '\n';
  }
}

} // namespace tool
