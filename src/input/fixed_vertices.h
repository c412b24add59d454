// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_FIXED_VERTICES_H
#define SPHERICAL_PARAMETERIZATION_TOOL_FIXED_VERTICES_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace tool {

struct Fixed_vertex {
  std::size_t index;
  std::array<double, 3> position; ///< on the unit sphere
};

/// Reads lines `index x y z`: the number of a vertex, from 0 on, and the direction it is to have on the sphere.
/// Throws a `Refusal` that names the first line that does not fit a mesh of so many vertices.
std::vector<Fixed_vertex> read_fixed_vertices(const std::string& file, std::size_t number_of_vertices);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_FIXED_VERTICES_H
