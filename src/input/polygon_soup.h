// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_POLYGON_SOUP_H
#define SPHERICAL_PARAMETERIZATION_TOOL_POLYGON_SOUP_H

#include <CGAL/Simple_cartesian.h>

#include <boost/container/small_vector.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tool {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;

/// The vertices of one face. Triangles, nearly all there is, need no allocation of their own.
using Polygon = boost::container::small_vector<std::uint32_t, 3>;

/// A mesh as a file has it: nothing is known yet about how the polygons fit together.
struct Polygon_soup {
  std::vector<Point> points;
  std::vector<Polygon> polygons;
};

/// Above this, the 32-bit indices of `CGAL::Surface_mesh` could not number all half-edges.
constexpr std::size_t largest_count = 700'000'000;

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_POLYGON_SOUP_H
