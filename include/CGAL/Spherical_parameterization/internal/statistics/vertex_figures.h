// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_VERTEX_FIGURES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_VERTEX_FIGURES_H

#include <CGAL/Spherical_parameterization/values/Shape_statistics.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The sum of the variances of the three coordinates, by vertex.
template <class Loop>
std::vector<double> variances_of_vertices(const Loop& loop, const std::vector<Shape_points>& shapes)
{
  const double n = static_cast<double>(shapes.size());
  std::vector<double> variance(shapes[0].size(), 0);
  for_each_index(loop, static_cast<int>(variance.size()), [&](int j) {
    for(std::size_t c = 0; c < 3; ++c) {
      double mean = 0;
      for(const Shape_points& shape : shapes)
        mean += shape[j][c] / n;
      for(const Shape_points& shape : shapes)
        variance[j] += (shape[j][c] - mean) * (shape[j][c] - mean) / (std::max)(n - 1, 1.);
    }
  });
  return variance;
}

/// A third of the areas of its faces, mean over the shapes, by vertex.
template <class Loop>
std::vector<double> mean_areas_of_vertices(const Loop& loop, const Host_array<std::array<int, 3>>& face,
                                           const std::vector<Shape_points>& shapes)
{
  Host_array<double> area(face.size());
  for_each_index(loop, static_cast<int>(face.size()), [&](int f) {
    area[f] = 0;
    for(const Shape_points& shape : shapes) {
      const auto at = [&](int corner) { return coordinates(shape[face[f][corner]]); };
      area[f] += norm(outer(sub(at(1), at(0)), sub(at(2), at(0)))) / 2;
    }
  });
  std::vector<double> result(shapes[0].size(), 0);
  for(std::size_t f = 0; f < face.size(); ++f)
    for(int v : face[f])
      result[v] += area[f] / 3 / static_cast<double>(shapes.size());
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_STATISTICS_VERTEX_FIGURES_H
