// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SAMPLED_HAUSDORFF_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SAMPLED_HAUSDORFF_H

#include "input/mesh.h"

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <array>
#include <vector>

namespace tool {

/// The Hausdorff distance of a surface from others with the same faces over different points, sampled at the vertices:
/// the largest distance of a vertex of one from the other surface.
///
/// A vertex is not farther from the other surface than from itself there. So vertices are looked at in the order of
/// these bounds, until the next bound is not above the largest distance that is known, and the nearest face of a vertex
/// is searched for only until one is near enough. The search is in a hierarchy of boxes over the faces in the order of
/// a space-filling curve, which is the same for all surfaces: only the boxes are new. The result does not depend on the
/// number of threads. O(n log n) once, and about O(n) for every other surface.
class Sampled_hausdorff {
public:
  /// \param points  by vertex; finite. The vector has to stay where it is.
  Sampled_hausdorff(const Mesh& mesh, const std::vector<Point>& points, bool on_all_cores);

  /// \param others  by vertex; finite
  double distance(const std::vector<Point>& others) const;

private:
  CGAL::Spherical_parameterization::internal::Host_loop loop_;
  const std::vector<Point>& points_;
  std::vector<std::array<int, 3>> faces_; ///< in the order of the curve
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SAMPLED_HAUSDORFF_H
