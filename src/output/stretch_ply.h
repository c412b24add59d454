// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_STRETCH_PLY_H
#define SPHERICAL_PARAMETERIZATION_TOOL_STRETCH_PLY_H

#include "input/mesh.h"

#include <ostream>

namespace tool {

/// Writes the mesh (not the sphere) as a PLY file with the log area stretch of every vertex, and coloured by it:
/// white where areas keep their share, red where the map shrinks them, blue where it enlarges them.
void write_stretch_ply(std::ostream& out, const Mesh& mesh, Sphere_map sphere);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_STRETCH_PLY_H
