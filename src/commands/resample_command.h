// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_RESAMPLE_COMMAND_H
#define SPHERICAL_PARAMETERIZATION_TOOL_RESAMPLE_COMMAND_H

namespace CLI {
class App;
}

namespace tool {

/// Adds `resample`: a mesh file in, the same shape with the vertices and faces of an icosphere out.
void add_resample_command(CLI::App& app, int& exit_code);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_RESAMPLE_COMMAND_H
