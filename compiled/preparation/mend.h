// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#pragma once

#include <CGAL/Spherical_parameterization/preparation/prepare.h>

#include <array>
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

/// Closes a hole, given by its boundary, with a disk: the triangulation of least angles and area (P. Liepa, "Filling
/// holes in meshes", 2003; CGAL's triangulate_hole_polyline), refined until its triangles are as large as those around
/// it (CGAL's refine), but into about 20,000 at most, or as many as the surface has. A cone to the centre where there
/// is none. The vertices have to be derived anew afterwards.
///
/// Of holes of more than 500 edges corners are cut off first, the smallest first, until 500 are left; until 200, if the
/// Delaunay triangulation of the boundary has no filling.
///
/// Complexity: O(m^2) in most cases for a hole of m edges up to 500, and at most O(m^3) up to 200; beyond that
/// O(m log m) more. The refinement makes O(m^2) triangles where it may.
void fill_hole(Glued_surface& surface, const std::vector<int>& boundary);

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

/// Makes a sphere of a closed, connected surface with any number of handles: opens edges until it is a sphere with
/// holes, and fills them (`fill_hole()`). The loops are not the shortest; they are about where the part that grows from
/// face 0 meets itself on the far side of a handle.
///
/// A face after the other is added to the part, in the order of their distance in steps. Two sides of an edge are glued
/// if they are in the same cycle of the boundary, which cuts it in two; if they were in two cycles that would make a
/// handle, and they stay open for good, since cycles are never joined. Complexity: O(n log n) for all cuts together.
/// `go_on` is called now and then, and may throw.
/// \pre the vertices are derived
void cut_handles_at_once(Glued_surface& surface, const std::function<void()>& go_on);

/// The faces whose corners are on a line, exactly.
std::vector<int> degenerate_faces(const Glued_surface& surface);

/// Collapses edges of length 0, and flips the longest edges of other faces without area until there are no such faces,
/// by CGAL's remove_degenerate_faces. Faces and vertices that are left keep their order; a face whose corners have
/// changed is new. Returns false, and changes nothing, where that would change holes, handles or components, as on a
/// surface all in a line.
/// \pre no two edges have the same ends (`split_parallel_edges()`)
bool remove_degenerate_faces(Glued_surface& surface);

struct Wrapping {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
};

/// A closed surface around triangles of any kind, at a distance of `offset`; what a ball of radius `alpha` cannot enter
/// is filled (C. Portaneri, M. Rouxel-Labbe, M. Hemmer, D. Cohen-Steiner, P. Alliez, "Alpha wrapping with an offset",
/// 2022; CGAL's alpha_wrap_3). `go_on` is called again and again, and ends it by an exception.
Wrapping wrap(const Triangle_soup& soup, double alpha, double offset, const std::function<void()>& go_on);

} // namespace CGAL::Spherical_parameterization::preparation
