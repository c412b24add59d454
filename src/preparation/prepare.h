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

/// How far a mesh is mended. The default is all that stands between it and a closed sphere. In any case faces that are
/// none are left out, faces with common vertices glued, neighbours oriented alike, and non-manifold vertices copied.
struct Preparation_settings {
  enum class Components {
    LARGEST, ///< only the one of largest area is kept
    TOGETHER,
    SPLIT ///< each is a part by itself
  };

  std::optional<double> merge_distance = 0; ///< up to which vertices at boundaries are merged; none: they are not
  Components components = Components::LARGEST;
  bool fills_holes = true;
  bool cuts_handles = true; ///< of components without holes
  bool removes_degenerate_faces = false;
  struct Wrap {
    std::optional<double> alpha, offset; ///< by default a 50th and a 1500th of the diagonal of the bounding box
  };
  std::optional<Wrap> wrap; ///< a surface around everything takes the place of the mesh

  /// What does not change the shape.
  static Preparation_settings harmless()
  {
    Preparation_settings settings;
    settings.components = Components::TOGETHER;
    settings.fills_holes = settings.cuts_handles = false;
    return settings;
  }
};

/// A closed path of edges: the boundary of a hole, or round a handle.
struct Loop {
  std::size_t edges = 0;
  double length = 0;
  int vertex = -1; ///< one of its vertices, by the number in the file; -1 if all are new
};

struct Piece {
  Component size;
  double share_of_area = 1;
  int vertex = -1; ///< one of its vertices, by the number in the file
  bool is_kept = true;
};

/// What was wrong with a mesh, what was done, and what has come out.
struct Preparation {
  std::vector<Glued_surface>
    parts; ///< one; or one for each component, the largest first, if they are split or handles of several are cut
  Gluing_defects defects;
  std::vector<Piece> pieces;      ///< the components of the mesh, the largest first
  std::vector<int> piece_of_face; ///< by face of the file, its number in `pieces`; -1 if it was removed, or all wrapped
  std::vector<Loop> holes;        ///< of what is kept, the longest first
  std::vector<Loop> handles;      ///< of what is kept, each of them the shortest on what the ones before have left
  int handles_cut_at_once = 0;    ///< and those after them, of too many to look for the shortest loops of all
  bool is_filled = false;         ///< the holes are closed
  bool is_cut = false;            ///< the handles are cut
  Defect degenerate_faces;        ///< those that were removed, or were to be
  bool has_degenerate_faces = false; ///< they are still there, since nothing would be left, or less than a surface
  bool is_turned_outwards = false;   ///< all faces were turned round
  std::size_t split_edges = 0;       ///< those that had the same ends as others
  std::optional<Preparation_settings::Wrap> wrap; ///< what was used
};

/// Mends a mesh; `file` is what it was read from. Throws a `Refusal` if it has no face that can be used, and at an
/// interruption.
Preparation prepare(const std::string& file, const Soup& soup, const Preparation_settings& settings);

/// Of the area of all components, what is kept.
double share_of_area_kept(const Preparation& preparation);

/// What was wrong and what was done about it, one sentence each: "filled 3 holes (longest: 80 edges, length 0.5, at
/// vertex 17)". Empty if nothing was wrong.
std::vector<std::string> sentences(const Preparation& preparation);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_PREPARE_H
