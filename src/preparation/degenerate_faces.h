// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_DEGENERATE_FACES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_DEGENERATE_FACES_H

#include "preparation/glued_surface.h"

#include <vector>

namespace tool {

/// The faces whose corners are on a line, exactly.
std::vector<int> degenerate_faces(const Glued_surface& surface);

/// Collapses edges of length 0, and flips the longest edges of other faces without area until there are no such faces,
/// by CGAL's remove_degenerate_faces. Faces and vertices that are left keep their order; a face whose corners have
/// changed is new. Returns false, and changes nothing, where that would change holes, handles or components, as on a
/// surface all in a line.
/// \pre no two edges have the same ends (`split_parallel_edges()`)
bool remove_degenerate_faces(Glued_surface& surface);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_DEGENERATE_FACES_H
