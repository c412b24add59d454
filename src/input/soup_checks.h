// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_SOUP_CHECKS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_SOUP_CHECKS_H

#include "input/polygon_soup.h"

#include <string>

namespace tool {

/// Throws a `Refusal` that says all that keeps the soup from being a triangulated sphere: faces that are no triangles,
/// faces with a repeated vertex, isolated vertices, edges with more than two faces, neighbouring faces of opposite
/// orientation, boundary edges, non-manifold vertices, several components, and handles.
///
/// \pre what `mesh_readers.h` promises
void check_triangulated_sphere(const std::string& file, const Polygon_soup& soup);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_SOUP_CHECKS_H
