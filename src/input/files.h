// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_FILES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_FILES_H

#include <string>
#include <vector>

namespace tool {

/// Throws a `Refusal` if the file does not exist, is not a regular file, is empty or cannot be opened.
void check_readable(const std::string& file);

/// All bytes of a file. Throws a `Refusal`.
std::string read_file(const std::string& file);

/// As in ".off".
std::string lower_case_extension(const std::string& file);

/// Whether the extension is one of those that `read_mesh()` reads.
bool is_mesh_file(const std::string& file);

/// The extensions, for messages.
inline const char* const mesh_extensions = ".off, .obj, .ply and .stl";

/// The mesh files that the user means, each once, in an order that depends on the names alone: `inputs` in their order,
/// folders replaced by all mesh files in them and in their subfolders, sorted by name; then the lines of `list`, if it
/// is not empty, in the same way. Files that do not exist stay in the list. Throws a `Refusal`.
std::vector<std::string> list_meshes(const std::vector<std::string>& inputs, const std::string& list);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_FILES_H
