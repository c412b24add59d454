// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SURFACE_DISTANCE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SURFACE_DISTANCE_H

#include "input/mesh.h"

#include <vector>

namespace tool {

/// The Hausdorff distance of two surfaces with the same faces over different points, sampled at the vertices: the
/// largest distance of a vertex of one from the other surface. O(n log n), on all cores if `on_all_cores`.
double hausdorff_distance(const Mesh& mesh, const std::vector<Point>& a, const std::vector<Point>& b,
                          bool on_all_cores);

/// What of a shape is not in a mesh that was sampled from it.
struct Sampling_loss {
  double bounding_box = 0; ///< of its side that has lost most, in [0, 1]
  double distance = 0;     ///< from the shape to the samples, that 99 % of the area keep; of the diagonal of the box
};

/// Compares `mesh` with the same shape sampled at the vertices of `sampled`.
/// \param points  by vertex of `sampled`
Sampling_loss sampling_loss(const Mesh& mesh, const Mesh& sampled, const std::vector<Point>& points);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SURFACE_DISTANCE_H
