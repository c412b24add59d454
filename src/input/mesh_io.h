// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_IO_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_IO_H

#include "input/polygon_soup.h"

#include <CGAL/Surface_mesh.h>

#include <cstddef>
#include <ostream>
#include <string>

namespace tool {

using Mesh = CGAL::Surface_mesh<Point>;
using Sphere_map = Mesh::Property_map<Mesh::Vertex_index, Point>;

/// \name Reading
/// @{

/// As in ".off".
std::string lower_case_extension(const std::string& file);

/// What to do with faces of more than three vertices.
enum class Polygons { REFUSE, TRIANGULATE };

struct Input_mesh {
  Mesh mesh;
  std::size_t triangulated_polygons = 0; ///< if there are any, the faces are not those of the file
};

/// Reads a triangulated sphere from an OFF, OBJ, PLY or STL file. Vertex `i` of the file is vertex `i` of the mesh, and
/// the same for faces (of STL files: in the order in which they appear first). Anything else throws a `Refusal`.
Input_mesh read_mesh(const std::string& file, Polygons polygons = Polygons::REFUSE);

/// Whether the extension is one of those that `read_mesh()` reads.
bool is_mesh_file(const std::string& file);

/// @}
/// \name Writing
/// @{

enum class Mesh_format { OFF, OBJ, PLY, UNKNOWN };

/// The format that the extension of an output file asks for.
Mesh_format output_format(const std::string& file);

/// Writes the faces of `mesh` over the points of `sphere`, with 17 significant digits.
void write_mesh(std::ostream& out, Mesh_format format, const Mesh& mesh, Sphere_map sphere);

/// Writes one line per face, as in OFF and text PLY files.
void write_faces(std::ostream& out, const Mesh& mesh);

/// @}

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_IO_H
