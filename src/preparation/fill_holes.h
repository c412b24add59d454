// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_FILL_HOLES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_FILL_HOLES_H

#include "preparation/glued_surface.h"

#include <vector>

namespace tool {

/// Closes a hole, given by its boundary, with a disk: the triangulation of least angles and area (P. Liepa, "Filling
/// holes in meshes", 2003; CGAL's triangulate_hole_polyline), refined until its triangles are as large as those around
/// it (CGAL's refine). A cone to the centre where there is none. The vertices have to be derived anew afterwards.
///
/// Of holes of more than 500 edges corners are cut off first, the smallest first, until 500 are left; until 200, if the
/// Delaunay triangulation of the boundary has no filling.
///
/// Complexity: O(m^2) in most cases for a hole of m edges up to 500, and at most O(m^3) up to 200; beyond that
/// O(m log m) more.
void fill_hole(Glued_surface& surface, const std::vector<int>& boundary);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_FILL_HOLES_H
