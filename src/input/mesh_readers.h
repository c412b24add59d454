// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_READERS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_READERS_H

#include "input/polygon_soup.h"

#include <string>

namespace tool {

/// \name Readers, one per file format
/// CGAL parses; these check what CGAL does not, so that a broken file is refused in one sentence before it costs memory
/// or yields a wrong mesh: header counts against the size of the file, numbers that are none, NaN, indices out of
/// range, files that are cut short, and dialects of the format. Vertices and faces keep the order of the file.
///
/// On return all coordinates are finite, all indices in range, and every polygon has at least three of them.
/// Everything else throws a `Refusal`.
/// @{
Polygon_soup read_off(const std::string& file);
Polygon_soup read_obj(const std::string& file);
Polygon_soup read_ply(const std::string& file);
Polygon_soup read_stl(const std::string& file); ///< corners at the same place become one vertex
/// @}

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_READERS_H
