// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_TEXTURED_OBJ_H
#define SPHERICAL_PARAMETERIZATION_TOOL_TEXTURED_OBJ_H

#include "input/mesh.h"

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

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

#endif // SPHERICAL_PARAMETERIZATION_TOOL_TEXTURED_OBJ_H
