// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_PROBLEM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_PROBLEM_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/surface/Spring_lengths.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <optional>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// What is to be mapped: a checked mesh as arrays, and what the caller asked for. From here on nothing depends on the
/// type of the mesh, and nothing changes it.
struct Problem : Surface {
  Host_array<double> density; ///< of every face, the largest is 1, see `face_density_map`; empty: all equal
  Shared_graph graph; ///< the springs, in ascending order; the weights, with the diagonal of free vertices; or null
  std::optional<Spring_lengths> spring_lengths; ///< of conformal springs; others are edges of the faces
  std::string missing_weights;       ///< why there are no weights though the method could use them; else empty
  double weight_unit = 1;            ///< what a weight of 1 in the graph is to the caller
  std::vector<char> is_fixed;        ///< empty: no fixed vertex
  Host_array<vec3> given;            ///< unit vectors the caller's map held on entry, where they are needed; else empty
  vec3 (*as_stored)(vec3) = nullptr; ///< what the caller's map makes of a position; null: it keeps every double
  double rounding = 0;               ///< ... and by how much, relative; 0: by nothing

  /// Whether the springs are those of the intrinsic triangulation, and not the edges of the faces.
  bool is_intrinsic() const { return spring_lengths.has_value(); }
  bool has_fixed() const { return !is_fixed.empty(); }
  /// Where the caller's map has a fixed vertex.
  vec3 place_of_fixed(int i) const { return as_stored ? as_stored(given[i]) : given[i]; }
  int size() const { return number_of_vertices; }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_PROBLEM_H
