// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_PREPARE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_PREPARE_H

#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/preparation/glued_surface.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {

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

/// \cond SKIP_IN_MANUAL
/// `go_on` is called now and then, and may throw.
Preparation prepare(const Triangle_soup& soup, const Preparation_settings& settings,
                    const std::function<void()>& go_on);
/// \endcond

/// Mends a mesh with any defects until it is what `parameterize()` takes, or as far as the settings say.
///
/// Faces are glued along their sides, neighbours turned to the same side, non-manifold parts cut from each other, holes
/// filled (P. Liepa, "Filling holes in meshes", 2003) and handles cut along shortest loops (J. Erickson and S.
/// Har-Peled, "Optimally cutting a surface into a disk", 2004). Vertices and faces that are left keep their order; a
/// mesh without defects is not changed.
///
/// Complexity: O(n log n), but for holes (`m^2` for one of m edges, up to 500) and handles (in most cases n times the
/// vertices of the shortest loops).
/// \param soup      points and triangles: `{points, triangles}` of two vectors
/// \param settings  what is done
/// \param np        optional named parameters: `callback` and `maximum_running_time`, as in `parameterize()`
/// \return the mended mesh, and what was done
/// \throws Error if there is no face that can be used (`EMPTY_MESH`), or it was interrupted (`INTERRUPTED`)
template <class NamedParameters = parameters::Default_named_parameters>
Preparation prepare(const Triangle_soup& soup, const Preparation_settings& settings = {},
                    const NamedParameters& np = parameters::default_values())
{
  internal::Monitor monitor = internal::make_monitor(np);
  return prepare(soup, settings, std::function<void()>([&monitor] { monitor.advance_or_throw(); }));
}

/// The diagonal of the bounding box of the finite vertices that have faces.
double diagonal(const Triangle_soup& soup);

/// Of the area of all components, what is kept.
double share_of_area_kept(const Preparation& preparation);

/// What was wrong and what was done about it, one sentence each: "filled 3 holes (longest: 80 edges, length 0.5, at
/// vertex 17)". Empty if nothing was wrong.
std::vector<std::string> sentences(const Preparation& preparation);

} // namespace CGAL::Spherical_parameterization::preparation

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_PREPARE_H
