// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H

#include "input/mesh.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

/// Writes the faces of `mesh` over other points, in the format that the extension of `file` asks for: OFF, OBJ or PLY.
void write_mesh(std::ostream& out, const std::string& file, const Mesh& mesh, const std::vector<Point>& points);

/// Writes the mesh (not the sphere) as a PLY file with the log area stretch of every vertex, and coloured by it:
/// white where areas keep their share, red where the map shrinks them, blue where it enlarges them.
void write_stretch_ply(std::ostream& out, const Mesh& mesh, const Sphere& sphere);

/// Writes the mesh as PLY with the segment of every face, and faces coloured by it. Segment i has the same colour in
/// every file.
void write_segments_ply(std::ostream& out, const Mesh& mesh, const std::vector<std::size_t>& segments,
                        std::size_t number_of_segments);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H
