// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_EXTENSIONS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_EXTENSIONS_H

#include <string>

namespace tool {

/// As in ".off".
std::string lower_case_extension(const std::string& file);

/// Whether the extension is one of those that `read_mesh()` reads.
bool is_mesh_file(const std::string& file);

/// The extensions, for messages.
inline const char* const mesh_extensions = ".off, .obj, .ply and .stl";

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_EXTENSIONS_H
