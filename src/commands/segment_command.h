// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SEGMENT_COMMAND_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SEGMENT_COMMAND_H

namespace CLI {
class App;
}

namespace tool {

/// Adds `segment`: a mesh file in, the mesh coloured by segments out, and one label per face.
void add_segment_command(CLI::App& app, int& exit_code);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SEGMENT_COMMAND_H
