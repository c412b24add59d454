// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_READ_SPHERE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_READ_SPHERE_H

#include <string>

namespace tool {

struct Mapped_mesh;

/// Takes the map of `input.mesh`, which was read from `mesh_file`, from a file as `map` writes it, and certifies it
/// again. Throws a `Refusal` if the file has not the same vertices and faces in the same order, or a point that is no
/// direction; flipped faces are left to `input.result`.
void read_sphere(const std::string& file, const std::string& mesh_file, Mapped_mesh& input);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_READ_SPHERE_H
