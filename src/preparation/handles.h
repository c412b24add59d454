// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_HANDLES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_HANDLES_H

#include "preparation/glued_surface.h"

#include <functional>
#include <vector>

namespace tool {

/// A shortest closed path along edges of a closed, connected surface that does not cut it in two: round a handle or
/// through it. Sides, one after the other; empty on a sphere. `go_on` is called now and then, and may throw.
///
/// The homology of a path modulo 2 tells whether it cuts the surface in two (J. Erickson and K. Whittlesey, "Greedy
/// optimal homotopy and homology generators", 2005). All such paths meet the cut graph that a tree of shortest paths
/// and a tree of the dual graph leave over (J. Erickson and S. Har-Peled, "Optimally cutting a surface into a disk",
/// 2004), so that one search from each of its vertices is enough, as far as half of the shortest path that is known. At
/// most O(g n^(3/2) log n) for a surface of genus g whose trees are O(n^(1/2)) deep, and much less where handles are
/// thin.
std::vector<int> shortest_handle_loop(const Glued_surface& surface, const std::function<void()>& go_on);

/// Unglues the sides of a loop: two boundaries are left, and a handle less once they are closed.
void cut_along(Glued_surface& surface, const std::vector<int>& loop);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_HANDLES_H
