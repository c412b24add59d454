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

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SURFACE_DISTANCE_H
