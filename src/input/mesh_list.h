// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_LIST_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_LIST_H

#include <string>
#include <vector>

namespace tool {

/// The mesh files that the user means, each once, in an order that depends on the names alone: `inputs` in their order,
/// folders replaced by all mesh files in them and in their subfolders, sorted by name; then the lines of `list`, if it
/// is not empty, in the same way. Files that do not exist stay in the list. Throws a `Refusal`.
std::vector<std::string> list_meshes(const std::vector<std::string>& inputs, const std::string& list);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_LIST_H
