// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/mesh_readers.h"

#include <CGAL/Spherical_parameterization/Indexed_triangle_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace tool {

using Mesh = SP::Indexed_triangle_mesh;
using Point = Mesh::Point;

/// The place of every vertex on the unit sphere.
using Sphere = std::vector<Point>;

/// The value at an index. No lambda, which std::optional<function_property_map> of clang++ does not take: it could not
/// be made by default.
template <class Values>
struct Value_at {
  Values* values;
  template <class Key>
  auto& operator()(Key key) const
  {
    return (*values)[static_cast<std::size_t>(key.idx())];
  }
};

/// A vector of values as a property map. `Key` is the index of vertices, faces or halfedges.
template <class Key, class Values>
auto as_map(Values& values)
{
  return boost::make_function_property_map<Key>(Value_at<Values>{&values});
}

/// The places as a property map of the vertices.
inline auto as_map(Sphere& sphere) { return as_map<Mesh::Vertex_index>(sphere); }
inline auto as_map(const Sphere& sphere) { return as_map<Mesh::Vertex_index>(sphere); }

/// What to do with faces of more than three vertices.
enum class Polygons { REFUSE, TRIANGULATE };

struct Input_mesh {
  Mesh mesh;
  std::size_t triangulated_polygons = 0; ///< if there are any, the faces are not those of the file
  Annotations annotations = {};
  Vertex_data data = {}; ///< at the vertices of `mesh`
};

/// Reads a triangulated sphere from a file of one of the formats of `Mesh_format`, or from the standard input, "-".
/// Vertex `i` of the file is vertex `i` of the mesh, and the same for faces (of STL and glTF files: in the order in
/// which they appear first). Anything else throws a `Refusal`, which says `how_to_mend` a surface that is no sphere,
/// and `how_to_cut` polygons.
///
/// What the file contains decides about its format, and its name only if that leaves it open.
Input_mesh read_mesh(const std::string& file, Polygons polygons = Polygons::REFUSE,
                     const std::string& how_to_mend = "the command 'prepare' does it",
                     const std::string& how_to_cut = "triangulate the mesh, or use --triangulate");

} // namespace tool
