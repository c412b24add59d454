// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SAMPLING_LOSS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SAMPLING_LOSS_H

#include "input/mesh.h"

#include <vector>

namespace tool {

/// What of a shape is not in a mesh that was sampled from it.
struct Sampling_loss {
  double bounding_box = 0; ///< of its side that has lost most, in [0, 1]
  double distance = 0;     ///< from the shape to the samples, that 99 % of the area keep; of the diagonal of the box
};

/// Compares `mesh` with the same shape sampled at the vertices of `sampled`.
/// \param points  by vertex of `sampled`
Sampling_loss sampling_loss(const Mesh& mesh, const Mesh& sampled, const std::vector<Point>& points);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SAMPLING_LOSS_H
