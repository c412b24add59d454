// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_GEOMETRY_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_GEOMETRY_H

#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/base/vec3.h>
#include <CGAL/Spherical_parameterization/internal/base/Bounding_box.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/mesh/point_coordinates.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Reads the points of the vertices, in their order. Throws Error where a coordinate is not finite.
template <class Vertex, class VertexPointMap, class Loop>
Host_array<vec3> read_points(const Loop& loop, const std::vector<Vertex>& vertex, const Host_array<int>& position,
                             VertexPointMap points)
{
  const int n = static_cast<int>(vertex.size());
  Host_array<vec3> point(n);
  const int bad = first_index(loop, n, [&](int i) {
    const vec3 p = point[i] = coordinates(get(points, vertex[i]));
    return !std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z);
  });
  if(bad < n)
    throw Input_error(Error_code::NON_FINITE_COORDINATE, "vertex " + std::to_string(position[bad]));
  return point;
}

/// Moves the bounding box to the origin and scales it to size 1. Lengths and areas are only ever compared with each
/// other: this keeps their squares and products far from overflow and underflow.
inline void scale_to_unit_box(Host_array<vec3>& point)
{
  const Bounding_box box(point);
  const vec3 low = box.low;
  const double divisor = box.half_size();
  for(vec3& p : point)
    p = {(p.x / 2 - low.x / 2) / divisor, (p.y / 2 - low.y / 2) / divisor, (p.z / 2 - low.z / 2) / divisor};
}

/// Every vertex's third of the areas of its faces.
template <class Loop>
Host_array<double> vertex_areas(const Loop& loop, const Host_array<std::array<int, 3>>& face,
                                const Host_array<vec3>& point)
{
  Host_array<double> twice_area(face.size());
  for_each_part(loop, static_cast<int>(face.size()), [&](int begin, int end) {
    for(int f = begin; f < end; ++f) {
      const auto [a, b, c] = face[f];
      const vec3 n = outer(sub(point[b], point[a]), sub(point[c], point[a]));
      twice_area[f] = std::sqrt(inner(n, n));
    }
  });
  Host_array<double> area(point.size(), 0.);
  for(std::size_t f = 0; f < face.size(); ++f)
    for(int i : face[f])
      area[i] += twice_area[f] / 6;
  return area;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_SOURCE_GEOMETRY_H
