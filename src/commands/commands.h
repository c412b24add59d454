// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_COMMANDS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_COMMANDS_H

#include <cstddef>
#include <string>

namespace CLI {
class App;
}

namespace tool {

/// \name Commands
/// Each function adds a command of its name. `exit_code` is set when the command runs.
/// @{
void add_map_command(CLI::App& app, int& exit_code);       ///< a mesh file in, a certified spherical map out
void add_segment_command(CLI::App& app, int& exit_code);   ///< the mesh coloured by segments, and one label per face
void add_texture_command(CLI::App& app, int& exit_code);   ///< the mesh with texture coordinates, material, a checker
void add_resample_command(CLI::App& app, int& exit_code);  ///< the mesh sampled at an icosphere
void add_harmonics_command(CLI::App& app, int& exit_code); ///< the shape in spherical harmonics
void add_atlas_command(CLI::App& app, int& exit_code);     ///< mesh files in, their mean and principal components out
void add_register_command(CLI::App& app, int& exit_code);  ///< one mesh in the shape of another one
void add_morph_command(CLI::App& app, int& exit_code);     ///< meshes that lead from one shape to another one
void add_signature_command(CLI::App& app, int& exit_code); ///< mesh files in, an index of their signatures out
void add_search_command(CLI::App& app, int& exit_code);    ///< the meshes of an index that are most similar to one
void add_prepare_command(CLI::App& app, int& exit_code);   ///< a mesh with any defects in, one that can be mapped out
void add_certify_command(CLI::App& app, int& exit_code);   ///< exact certificate and distortion of any program's sphere
void add_view_command(CLI::App& app, int& exit_code);      ///< the mesh and its sphere as a page to look at
void add_devices_command(CLI::App& app, int& exit_code);   ///< the execution policies, and their devices
/// @}

/// Throws a `Refusal` of a mesh with more vertices than the page of `view` has numbers for.
void check_size_of_page(const std::string& input, std::size_t number_of_vertices);

/// The program: parses the command line, and runs its command. Returns the exit code: 0, 1 for a failure, 2 for wrong
/// usage. Throws what is thrown outside of a command.
int run(int argc, char** argv);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_COMMANDS_H
