// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_READ_SPHERE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_READ_SPHERE_H

#include "input/mesh.h"

#include <CGAL/Spherical_parameterization/Result.h>

#include <string>

namespace tool {

/// Reads the map of `mesh`, which was read from `mesh_file`, from a file as `map` writes it, and certifies it again.
/// Returns sizes and certificate: flipped faces are an error of the result. Throws a `Refusal` if the file has not the
/// same vertices and faces in the same order, or a point that is not on the unit sphere.
CGAL::Spherical_parameterization::Result read_sphere(const std::string& file, const std::string& mesh_file,
                                                     const Mesh& mesh, Sphere& sphere);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_READ_SPHERE_H
