// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/write_mesh.h"

#include "input/mesh_extensions.h"

#include <limits>

namespace tool {

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
