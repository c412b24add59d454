// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_PLY_STRUCTURE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_PLY_STRUCTURE_H

#include <cstddef>
#include <string>

namespace tool {

struct Ply_counts {
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

/// Walks through all of a PLY file, text or binary, and throws a `Refusal` at the first thing that CGAL's reader would
/// fail on, misunderstand, or take too much memory for.
Ply_counts check_ply_structure(const std::string& file);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_PLY_STRUCTURE_H
