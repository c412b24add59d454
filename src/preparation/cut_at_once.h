// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_CUT_AT_ONCE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_CUT_AT_ONCE_H

#include "preparation/glued_surface.h"

namespace tool {

/// Makes a sphere of a closed, connected surface with any number of handles: opens edges until it is a sphere with
/// holes, and fills them (`fill_hole()`). The loops are not the shortest; they are about where the part that grows from
/// face 0 meets itself on the far side of a handle.
///
/// A face after the other is added to the part, in the order of their distance in steps. Two sides of an edge are glued
/// if they are in the same cycle of the boundary, which cuts it in two; if they were in two cycles that would make a
/// handle, and they stay open for good, since cycles are never joined. Complexity: O(n log n) for all cuts together.
/// \pre the vertices are derived
void cut_handles_at_once(Glued_surface& surface);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_CUT_AT_ONCE_H
