// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_REGISTRATION_H
#define SPHERICAL_PARAMETERIZATION_TOOL_REGISTRATION_H

#include "input/mesh.h"

#include <CGAL/Spherical_parameterization/register_maps.h>

#include <string>

namespace tool {

/// Moves `sphere`, the map of `mesh`, which was read from `file`, to where places that correspond have the same images
/// as in the map of another mesh: `register_maps()`, on one core. Throws a `Refusal`, with the map as it was or moved.
CGAL::Spherical_parameterization::Registration_result
register_map(const std::string& file, const Mesh& mesh, Sphere& sphere, const Mesh& to_mesh, const Sphere& to_sphere);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_REGISTRATION_H
