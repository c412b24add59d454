// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_MESH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_MESH_H

#include <CGAL/Spherical_parameterization/Indexed_triangle_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <vector>

namespace tool {

using Mesh = CGAL::Spherical_parameterization::Indexed_triangle_mesh;
using Point = Mesh::Point;

/// The place of every vertex on the unit sphere.
using Sphere = std::vector<Point>;

/// A vector of values as a property map. `Key` is the index of vertices, faces or halfedges.
template <class Key, class Values>
auto as_map(Values& values)
{
  return boost::make_function_property_map<Key>([&values](Key key) -> auto& {
    return values[static_cast<std::size_t>(key.idx())];
  });
}

/// The places as a property map of the vertices.
inline auto as_map(Sphere& sphere) { return as_map<Mesh::Vertex_index>(sphere); }
inline auto as_map(const Sphere& sphere) { return as_map<Mesh::Vertex_index>(sphere); }

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_MESH_H
