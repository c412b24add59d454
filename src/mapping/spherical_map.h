// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SPHERICAL_MAP_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SPHERICAL_MAP_H

#include "input/mesh.h"
#include "options/map_settings.h"

#include <CGAL/Spherical_parameterization/Result.h>

#include <functional>
#include <string>

namespace tool {

/// Calls `parameterize()` as `settings` say: the one place where it is instantiated, and where names and numbers
/// become types. `go_on` is told the fraction of the work done, and stops it by returning `false`.
/// `sphere` gets the size that it needs.
CGAL::Spherical_parameterization::Result map_to_sphere(const Mesh& mesh, Sphere& sphere, const Map_settings& settings,
                                                       const std::function<bool(double)>& go_on);

/// Reads the map of `mesh`, which was read from `mesh_file`, from a file as `map` writes it, and certifies it again.
/// Returns sizes and certificate: flipped faces are an error of the result. Throws a `Refusal` if the file has not the
/// same vertices and faces in the same order, or a point that is not on the unit sphere.
CGAL::Spherical_parameterization::Result read_sphere(const std::string& file, const std::string& mesh_file,
                                                     const Mesh& mesh, Sphere& sphere);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SPHERICAL_MAP_H
