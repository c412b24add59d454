// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_PREPARE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_PREPARE_H

#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/preparation/glued_surface.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {

/// \addtogroup PkgSphericalParameterizationPreparation
/// @{

/// A kind of defect: how often it was found, and where first.
struct Defect {
  std::size_t count = 0; ///< number of defects
  int first = -1;        ///< the index of a vertex or face in the file; -1: all of them are new

  /// \cond SKIP_IN_MANUAL
  void add(int where)
  {
    ++count;
    if(first < 0)
      first = where;
  }
  /// \endcond
};

/// The defects of triangles that were repaired to make a surface of them. These repairs do not change the shape, except
/// the removal of non-finite vertices and, with a distance, merging.
struct Gluing_defects {
  Defect non_finite_vertices;   ///< removed, with their faces
  Defect isolated_vertices;     ///< without a face that is left; removed
  Defect repeated_corners;      ///< faces with a vertex twice, removed
  Defect repeated_faces;        ///< faces with the same vertices as another, removed
  Defect merged_vertices;       ///< boundary vertices at the position of another one
  Defect non_manifold_edges;    ///< of more than two faces, which were glued in pairs
  Defect crowded_edges;         ///< of so many faces that not every pair of them was compared
  Defect non_manifold_vertices; ///< copied, so that every part of the surface has its own copy
  Defect slits;                 ///< along a side on which other faces have vertices (T-junctions), closed
  Defect reversed_faces;        ///< reversed, so that neighbours agree
  Defect cut_edges;             ///< edges along which a one-sided surface was cut; `first` is a vertex
};

/// The repairs to make. By default, all that are needed to get a closed surface of genus 0. In any case invalid faces
/// are removed, faces with common vertices glued, neighbours oriented consistently, and non-manifold vertices copied.
struct Preparation_settings {
  /// What becomes of several components.
  enum class Components {
    LARGEST,  ///< only the one of largest area is kept
    TOGETHER, ///< all are kept in one surface
    SPLIT     ///< each is a part by itself
  };

  std::optional<double> merge_distance = 0;    ///< up to which boundary vertices are merged; empty: no merging
  Components components = Components::LARGEST; ///< what becomes of several components
  bool fills_holes = true;                     ///< whether holes are filled
  bool cuts_handles = true;                    ///< whether handles of components without holes are cut
  bool removes_degenerate_faces = false;       ///< whether faces of area 0 are removed
  /// Options of a wrap.
  struct Wrap {
    std::optional<double>
      alpha; ///< cavities that a ball of this radius cannot enter are filled; default: diagonal / 50
    std::optional<double> offset; ///< distance of the wrap from the mesh; default: diagonal of the bounding box / 1500
  };
  std::optional<Wrap> wrap; ///< if given, a surface around the mesh replaces it

  /// \return settings for the repairs that do not change the shape
  static Preparation_settings harmless()
  {
    Preparation_settings settings;
    settings.components = Components::TOGETHER;
    settings.fills_holes = settings.cuts_handles = false;
    return settings;
  }
};

/// A closed path of edges: the boundary of a hole, or a loop around a handle.
struct Loop {
  std::size_t edges = 0; ///< number of edges
  double length = 0;     ///< length
  int vertex = -1;       ///< index in the file of one of its vertices; -1 if all are new
};

/// A component of the mesh.
struct Piece {
  Component size;           ///< its size
  double share_of_area = 1; ///< its share of the whole area
  int vertex = -1;          ///< index in the file of one of its vertices
  bool is_kept = true;      ///< whether it is kept
};

/// The defects of a mesh, what was done about them, and the repaired mesh.
struct Preparation {
  /// The repaired mesh: one part, or one for each component, the largest first, if components are split or handles of
  /// several are cut.
  std::vector<Glued_surface> parts;
  Gluing_defects defects;         ///< defects of the triangles
  double merge_distance = 0;      ///< up to which boundary vertices were merged
  std::vector<Piece> pieces;      ///< the components of the mesh, the largest first
  std::vector<int> piece_of_face; ///< by face of the file: its index in `pieces`; -1 if it was removed, or all wrapped
  std::vector<Loop> holes;        ///< holes of the kept components, the longest first
  std::vector<Loop> handles;      ///< loops around handles of the kept components, in the order of cutting
  int handles_cut_at_once = 0;    ///< number of further handles, too many for shortest loops, which were cut at once
  bool is_filled = false;         ///< whether the holes were filled
  bool is_cut = false;            ///< whether the handles were cut
  Defect degenerate_faces;        ///< faces of area 0, if they were to be removed
  bool has_degenerate_faces = false; ///< whether some were not removed, since less than a surface would be left
  std::size_t turned_parts = 0;      ///< number of parts all of whose faces were reversed
  std::size_t split_edges = 0;       ///< number of edges that were split, since others had the same end points
  std::optional<Preparation_settings::Wrap> wrap; ///< the options of the wrap that was made
};

/// \cond SKIP_IN_MANUAL
/// `go_on` is called now and then, and may throw.
Preparation prepare(const Triangle_soup& soup, const Preparation_settings& settings,
                    const std::function<void()>& go_on);
/// \endcond

/// Repairs a mesh with any defects so that `parameterize()` accepts it, or as far as the settings say.
///
/// Faces are glued along their sides, neighbours oriented consistently, non-manifold parts cut from each other, holes
/// filled (P. Liepa, "Filling holes in meshes", 2003) and handles cut along shortest loops (J. Erickson and S.
/// Har-Peled, "Optimally cutting a surface into a disk", 2004). The remaining vertices and faces keep their order; a
/// mesh without defects is not changed.
///
/// Complexity: O(n log n), except for holes (`m^2` for a hole of m edges, up to 500, and for the triangles that fill
/// it, up to 20,000 or the number of faces) and handles (in most cases n times the vertices of the shortest loops).
///
/// \param soup      points and triangles: `{points, triangles}` of two vectors
/// \param settings  the repairs to make
/// \param np        optional named parameters: `callback` and `maximum_running_time`, as in `parameterize()`
/// \pre corners are indices of points, `merge_distance` is not negative, and `alpha` and `offset` are positive
/// \return the repaired mesh, and what was done
/// \throws Error if there is no valid face (`EMPTY_MESH`), there are too many, or squares of the sizes of a wrap are no
/// numbers (`TOO_LARGE`), or it was interrupted (`INTERRUPTED`)
template <class NamedParameters = parameters::Default_named_parameters>
Preparation prepare(const Triangle_soup& soup, const Preparation_settings& settings = {},
                    const NamedParameters& np = parameters::default_values())
{
  constexpr std::size_t most = (std::numeric_limits<int>::max)() / 3;
  if(soup.points.size() > most || soup.triangles.size() > most)
    throw internal::Input_error(Error_code::TOO_LARGE, "2^31 / 3 points or triangles at most", "simplify the mesh");
  const int points = static_cast<int>(soup.points.size());
  CGAL_SP_PRECONDITION(std::all_of(soup.triangles.begin(), soup.triangles.end(),
                                   [points](const auto& t) {
                                     return std::all_of(t.begin(), t.end(),
                                                        [points](int v) { return v >= 0 && v < points; });
                                   }),
                       "corners of triangles are indices of points");
  CGAL_SP_PRECONDITION(settings.merge_distance.value_or(0) >= 0, "the distance of merging must not be negative");
  if(settings.wrap) {
    CGAL_SP_PRECONDITION(settings.wrap->alpha.value_or(1) > 0, "the radius alpha of a wrap is positive");
    CGAL_SP_PRECONDITION(settings.wrap->offset.value_or(1) > 0, "the offset of a wrap is positive");
  }
  internal::Monitor monitor = internal::make_monitor(np);
  return prepare(soup, settings, std::function<void()>([&monitor] { monitor.go_on_if(monitor.may_loop_go_on()); }));
}

/// \param soup  points and triangles
/// \return the diagonal of the bounding box of the finite vertices that have faces
double diagonal(const Triangle_soup& soup);

/// \param preparation  a result of `prepare()`
/// \return the share of the area of all components that is kept
double share_of_area_kept(const Preparation& preparation);

/// Describes defects and repairs, one sentence each: "filled 3 holes (longest: 80 edges, length 0.5, at vertex 17)".
/// \param preparation  a result of `prepare()`
/// \return the sentences; none if there were no defects
std::vector<std::string> sentences(const Preparation& preparation);

/// @}

} // namespace CGAL::Spherical_parameterization::preparation

#endif // CGAL_SPHERICAL_PARAMETERIZATION_PREPARATION_PREPARE_H
