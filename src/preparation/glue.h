// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_GLUE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_GLUE_H

#include "input/mesh_readers.h"
#include "preparation/glued_surface.h"

#include <cstddef>
#include <optional>

namespace tool {

/// A kind of defect: how often it is there, and where first.
struct Defect {
  std::size_t count = 0;
  int first = -1; ///< the number of a vertex or face of the file

  void add(int where)
  {
    if(count++ == 0)
      first = where;
  }
};

/// What had to be done to triangles before they were a surface. None of it changes the shape but what becomes of
/// non-finite vertices and, with a distance, of merged ones.
struct Gluing_defects {
  Defect non_finite_vertices;   ///< left out, with their faces
  Defect isolated_vertices;     ///< left out
  Defect repeated_corners;      ///< faces with a vertex twice, left out
  Defect repeated_faces;        ///< faces with the same vertices as another, left out
  Defect merged_vertices;       ///< at boundaries, at the same place as another
  Defect non_manifold_edges;    ///< of more than two faces, which were glued in pairs
  Defect crowded_edges;         ///< of so many faces that not every pair of them was compared
  Defect non_manifold_vertices; ///< copied, so that every part of the surface has its own
  Defect slits;                 ///< along a side on which other faces have vertices (T-junctions), closed
  Defect reversed_faces;        ///< turned round, so that neighbours agree
  Defect cut_edges;             ///< at which a surface with one side only was cut; the place is a vertex
};

/// Glues the triangles of a file along their sides. Where two faces, and no more, have an edge in common by its
/// vertices, they are neighbours. All other sides are compared by the places of their ends, as far as `merge_distance`
/// apart (or by their vertices again, if there is none); of more than two sides at a place those are glued that
/// continue each other best: with opposite directions if there are such, and with the flattest angle, as in A. Guéziec
/// et al., "Cutting and stitching" (2001), where nothing more is opened than needed. With a merge distance, slits along
/// a side on which other faces have vertices are closed by triangles on that line. Then neighbours are turned to the
/// same side, most faces of a component as they were; where that cannot be done, the surface is cut.
///
/// Vertices and faces keep their order. A mesh without defects is not changed. Complexity: O(n log n).
Glued_surface glue(const Soup& soup, std::optional<double> merge_distance, Gluing_defects& defects);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_GLUE_H
