// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_TEXTURE_COMMAND_H
#define SPHERICAL_PARAMETERIZATION_TOOL_TEXTURE_COMMAND_H

namespace CLI {
class App;
}

namespace tool {

/// Adds `texture`: a mesh file in, the mesh with texture coordinates, material and a checker image out.
void add_texture_command(CLI::App& app, int& exit_code);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_TEXTURE_COMMAND_H
