// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_H

#include "input/polygon_soup.h"

#include <CGAL/Surface_mesh.h>

namespace tool {

using Mesh = CGAL::Surface_mesh<Point>;

/// The place of every vertex on the unit sphere.
using Sphere_map = Mesh::Property_map<Mesh::Vertex_index, Point>;

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_H
