// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SEARCH_COMMAND_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SEARCH_COMMAND_H

namespace CLI {
class App;
}

namespace tool {

/// Adds `search`: a mesh file in, the meshes of an index that have the most similar shapes out. `exit_code` is set when
/// the command runs.
void add_search_command(CLI::App& app, int& exit_code);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SEARCH_COMMAND_H
