// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_PREPARE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_PREPARE_H

#include "input/mesh_readers.h"
#include "preparation/glue.h"
#include "preparation/glued_surface.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tool {

/// How far a mesh is mended. The default is all that stands between it and a closed sphere.
struct Preparation_settings {
  double merge_distance = 0; ///< up to which vertices at boundaries are merged
  bool only_harmless =
    false; ///< what does not change the shape: gluing and turning; components, holes and handles stay
  bool keeps_all_components = false; ///< or only the one of largest area
  bool fills_holes = true;
  bool cuts_handles = true; ///< of components without holes
  struct Wrap {
    std::optional<double> alpha, offset; ///< by default a 50th and a 1500th of the diagonal of the bounding box
  };
  std::optional<Wrap> wrap; ///< a surface around everything takes the place of the mesh
};

/// A closed path of edges: the boundary of a hole, or round a handle.
struct Loop {
  std::size_t edges = 0;
  double length = 0;
  int vertex = -1; ///< one of its vertices, by the number in the file; -1 if all are new
};

struct Piece {
  Component size;
  int vertex = -1; ///< one of its vertices, by the number in the file
  bool is_kept = true;
};

/// What was wrong with a mesh, what was done, and what has come out.
struct Preparation {
  std::vector<Glued_surface>
    parts; ///< one, unless all components are kept and mended: then one for each, the largest first
  Gluing_defects defects;
  std::vector<Piece> pieces;      ///< the components of the mesh, the largest first
  std::vector<int> piece_of_face; ///< by face of the file, its number in `pieces`; -1 if it was removed, or all wrapped
  std::vector<Loop> holes;        ///< of what is kept, the longest first
  std::vector<Loop> handles;      ///< of what is kept, each of them the shortest on what the ones before have left
  bool is_filled = false;         ///< the holes are closed
  bool is_cut = false;            ///< the handles are cut
  bool is_turned_outwards = false;                ///< all faces were turned round
  std::size_t split_edges = 0;                    ///< those that had the same ends as others
  std::optional<Preparation_settings::Wrap> wrap; ///< what was used

  /// Whether the mesh is as it was, its vertices and faces in their order.
  bool is_unchanged() const;
};

/// Mends a mesh; `file` is what it was read from. Throws a `Refusal` if it has no face that can be used, and at an
/// interruption.
Preparation prepare(const std::string& file, const Soup& soup, const Preparation_settings& settings);

/// What was wrong and what was done about it, one sentence each: "filled 3 holes (longest: 80 edges, length 0.5, at
/// vertex 17)". Empty if nothing was wrong.
std::vector<std::string> sentences(const Preparation& preparation);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_PREPARE_H
