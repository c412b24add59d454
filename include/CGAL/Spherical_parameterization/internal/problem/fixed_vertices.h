// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_FIXED_VERTICES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_FIXED_VERTICES_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/base/text.h>
#include <CGAL/Spherical_parameterization/internal/mesh/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Marks the constrained vertices; empty if there are none. One or two would leave a boost free, along which the map
/// collapses.
template <class Vertex, class ConstrainedMap>
std::vector<char> fixed_vertices(const std::vector<Vertex>& vertices, ConstrainedMap is_constrained)
{
  std::vector<char> is_fixed(vertices.size());
  std::transform(vertices.begin(), vertices.end(), is_fixed.begin(),
                 [&](const Vertex& v) { return get(is_constrained, v) ? 1 : 0; });
  const auto count = std::count(is_fixed.begin(), is_fixed.end(), 1);
  if(count == 0)
    return {};
  if(count < 3)
    throw Input_error(Error_code::BAD_CONSTRAINTS,
                      "only " + counted(count, "vertex is", "vertices are") + " fixed; fix three or more, or none");
  return is_fixed;
}

/// The directions that the sphere map holds at the fixed vertices, or at all of them; others are left zero. Vectors of
/// length 1 up to rounding are kept to the last bit. Throws Error.
template <class Vertex, class VertexSphereMap>
Host_array<vec3> given_positions(const std::vector<Vertex>& vertices, const Host_array<int>& position,
                                 VertexSphereMap sphere_map, const std::vector<char>& is_fixed, bool all,
                                 double rounding)
{
  typedef typename boost::property_traits<VertexSphereMap>::category Category;
  if constexpr(std::is_convertible_v<Category, boost::readable_property_map_tag>) {
    Host_array<vec3> given(vertices.size(), vec3{0, 0, 0});
    std::vector<std::tuple<double, double, double, int>> fixed;
    for(std::size_t i = 0; i < vertices.size(); ++i) {
      const bool is_fixed_vertex = !is_fixed.empty() && is_fixed[i];
      if(!all && !is_fixed_vertex)
        continue;
      vec3 p = coordinates(get(sphere_map, vertices[i]));
      const vec3 box = scaled_to_unit_box(p);
      if(!is_finite(p) || inner(box, box) == 0)
        throw Input_error(Error_code::BAD_CONSTRAINTS,
                          "the position given for vertex " + std::to_string(position[i]) + " is not a direction");
      if(!(std::abs(inner(p, p) - 1) <= rounding))
        p = unit(box);
      given[i] = p;
      if(is_fixed_vertex)
        fixed.emplace_back(p.x, p.y, p.z, position[i]);
    }
    std::sort(fixed.begin(), fixed.end());
    for(std::size_t k = 1; k < fixed.size(); ++k) {
      const auto& [ax, ay, az, a] = fixed[k - 1];
      const auto& [bx, by, bz, b] = fixed[k];
      if(ax == bx && ay == by && az == bz)
        throw Input_error(Error_code::BAD_CONSTRAINTS, "the fixed vertices " + std::to_string(a) + " and " +
                                                         std::to_string(b) + " are at the same position");
    }
    return given;
  } else
    throw Input_error(Error_code::BAD_CONSTRAINTS,
                      "the sphere map is not readable, and holds no positions to start from");
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_FIXED_VERTICES_H
