// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MORPH_PAGE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MORPH_PAGE_H

#include "input/mesh.h"

#include <ostream>
#include <string>
#include <vector>

namespace tool {

/// Writes one HTML file that shows a mesh moving from the first frame to the last one and back, drawn by WebGL 2.
/// Nothing is loaded from elsewhere.
void write_morph_page(std::ostream& out, const std::string& title, const Mesh& mesh,
                      const std::vector<std::vector<Point>>& frames);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MORPH_PAGE_H
