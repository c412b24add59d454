// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H

#include "input/mesh.h"

#include <ostream>
#include <string>

namespace tool {

enum class Mesh_format { OFF, OBJ, PLY, UNKNOWN };

/// The format that the extension of an output file asks for.
Mesh_format output_format(const std::string& file);

/// Writes the faces of `mesh` over the points of `sphere`, with 17 significant digits.
void write_mesh(std::ostream& out, Mesh_format format, const Mesh& mesh, Sphere_map sphere);

/// Writes one line per face, as in OFF and text PLY files.
void write_faces(std::ostream& out, const Mesh& mesh);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H
