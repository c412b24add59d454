// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_OUTPUT_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_OUTPUT_H

#include "output/write_mesh.h"

#include <string>

namespace CLI {
class App;
}

namespace tool {

/// A mesh that is written, and how.
struct Mesh_output {
  std::string output;
  std::string format; ///< empty: the name says it
  bool ascii = false;
};

/// --output, --format and --ascii. `what` is written, and begins the description.
void add_mesh_output(CLI::App& command, Mesh_output& options, const std::string& what);

/// --ascii alone, for commands that write PLY only.
void add_ascii_option(CLI::App& command, bool& ascii);

/// The format of --output. Throws a `CLI::ValidationError` if neither --format nor the name says it.
Output_format output_format(const Mesh_output& options);

/// The format that a name given to `option` says. Throws a `CLI::ValidationError`.
Output_format output_format_of_name(const std::string& option, const std::string& file, bool ascii);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_OUTPUT_H
