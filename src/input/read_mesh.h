// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_READ_MESH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_READ_MESH_H

#include "input/mesh.h"
#include "input/mesh_readers.h"

#include <cstddef>
#include <string>

namespace tool {

/// What to do with faces of more than three vertices.
enum class Polygons { REFUSE, TRIANGULATE };

/// Reads the bytes of a mesh file whose name is `file`. Nothing is known then about how the faces fit together.
Soup read_soup(const std::string& file, std::string bytes, Polygons polygons = Polygons::REFUSE);

struct Input_mesh {
  Mesh mesh;
  std::size_t triangulated_polygons = 0; ///< if there are any, the faces are not those of the file
};

/// Reads a triangulated sphere from an OFF, OBJ, PLY or STL file. Vertex `i` of the file is vertex `i` of the mesh, and
/// the same for faces (of STL files: in the order in which they appear first). Anything else throws a `Refusal`.
///
/// The extension has to be one of the four; a PLY or OFF file under one of the other three is read as what it is.
Input_mesh read_mesh(const std::string& file, Polygons polygons = Polygons::REFUSE);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_READ_MESH_H
