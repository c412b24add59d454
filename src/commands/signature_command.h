// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_COMMAND_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_COMMAND_H

namespace CLI {
class App;
}

namespace tool {

/// Adds `signature`: mesh files in, an index of their signatures out. `exit_code` is set when the command runs.
void add_signature_command(CLI::App& app, int& exit_code);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SIGNATURE_COMMAND_H
