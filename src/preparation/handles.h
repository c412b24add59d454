// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_HANDLES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_HANDLES_H

#include "preparation/glued_surface.h"

#include <functional>
#include <vector>

namespace tool {

/// Makes a sphere of a closed, connected surface: cuts it along a shortest closed path of edges that does not cut it in
/// two, round a handle or through it, fills both holes (`fill_hole()`), and does so again until no handle is left.
/// `before_cut` is told each loop: its sides, one after the other. `go_on` is called now and then. Both may throw.
/// \pre the vertices are derived
///
/// The homology of a path modulo 2 tells whether it cuts the surface in two (J. Erickson and K. Whittlesey, "Greedy
/// optimal homotopy and homology generators", 2005). All paths that do not meet the cut graph that a tree of shortest
/// paths and a tree of the dual graph leave over (J. Erickson and S. Har-Peled, "Optimally cutting a surface into a
/// disk", 2004), or what was cut before, so that one search from each vertex of these is enough. What a search has
/// found is a lower bound for all that follow, since a cut makes no new paths but through its filling.
///
/// Complexity: in most cases O(m n log n) for m such vertices and searches that reach n: as far as half of the longest
/// of the loops; and O(g) words of memory for every 64 sides of a surface of genus g. Where hundreds of handles make
/// that too much, those that are left are cut by `cut_handles_at_once()`.
/// \return the number of handles that were cut at once
int cut_handles(Glued_surface& surface, const std::function<void(const std::vector<int>& loop)>& before_cut,
                const std::function<void()>& go_on);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_HANDLES_H
