// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_PREPARATION_GLUE_H
#define SPHERICAL_PARAMETERIZATION_PREPARATION_GLUE_H

#include <CGAL/Spherical_parameterization/preparation/prepare.h>

#include <functional>
#include <optional>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {

/// Glues the triangles of a file along their sides. Where two faces, and no more, have an edge in common by its
/// vertices, they are neighbours. All other sides are compared by the places of their ends, as far as `merge_distance`
/// apart (or by their vertices again, if there is none); of more than two sides at a place those are glued that
/// continue each other best: with opposite directions if there are such, and with the flattest angle, as in A. Guéziec
/// et al., "Cutting and stitching" (2001), where nothing more is opened than needed. With a merge distance, slits along
/// a side on which other faces have vertices are closed by triangles on that line. Then neighbours are turned to the
/// same side, most faces of a component as they were; where that cannot be done, the surface is cut.
///
/// Vertices and faces keep their order. A mesh without defects is not changed. `go_on` is called between steps that
/// take up to 0.8 s for 1.3 million vertices, and may throw. Complexity: O(n log n).
Glued_surface glue(const Triangle_soup& soup, std::optional<double> merge_distance, Gluing_defects& defects,
                   const std::function<void()>& go_on);

/// Turns the marked faces round, with the sides where they are glued.
void turn_round(Glued_surface& surface, const std::vector<bool>& is_turned);

} // namespace CGAL::Spherical_parameterization::preparation

#endif // SPHERICAL_PARAMETERIZATION_PREPARATION_GLUE_H
