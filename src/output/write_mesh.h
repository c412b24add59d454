// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H

#include "input/mesh.h"

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
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

/// A position in the texture.
using Uv = std::pair<double, double>;

/// Writes the mesh as OBJ with one `vt` for every position that a vertex has in the texture; `uv` has those at the
/// targets of the halfedges. No digit is left out: with less, slivers may flip when the file is read.
void write_textured_obj(std::ostream& out, const Mesh& mesh, const std::vector<Uv>& uv,
                        const std::string& material_file);

/// The material `texture`: white, with the image.
void write_material(std::ostream& out, const std::string& image_file);

/// Writes a PNG of a checker, whose squares are white and of a hue that goes once round with u. The number of squares
/// is even in both directions, so that it repeats whether shifted or turned by 180 degrees. Throws a
/// `std::runtime_error`.
void write_checker(std::ostream& out, int columns, int rows);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_WRITE_MESH_H
