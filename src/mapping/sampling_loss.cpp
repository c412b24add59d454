// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/sampling_loss.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tool {
namespace {

typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::vector<Kernel::Triangle_3> Triangles;
typedef CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator> Primitive;
typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;

/// In a unit in which the squares of all numbers are numbers.
Triangles triangles(const Mesh& mesh, const std::vector<Point>& points, double unit)
{
  Triangles result;
  result.reserve(mesh.number_of_faces());
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto corner = [&](std::size_t k) {
      const Point& p = points[static_cast<std::size_t>(mesh.triangle(f)[k])];
      return Kernel::Point_3(p[0] / unit, p[1] / unit, p[2] / unit);
    };
    result.emplace_back(corner(0), corner(1), corner(2));
  }
  return result;
}

CGAL::Bbox_3 box_of(const Triangles& triangles)
{
  CGAL::Bbox_3 box;
  for(const auto& t : triangles)
    box += t.bbox();
  return box;
}

} // namespace

Sampling_loss sampling_loss(const Mesh& mesh, const Mesh& sampled, const std::vector<Point>& points)
{
  constexpr std::size_t most_queries = 100000;
  constexpr double share = 0.99;
  double unit = 0;
  for(const Point& p : mesh.points())
    unit = std::max({unit, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  if(unit == 0)
    return {};
  const Triangles shape = triangles(mesh, mesh.points(), unit), samples = triangles(sampled, points, unit);

  Sampling_loss loss;
  const CGAL::Bbox_3 before = box_of(shape), after = box_of(samples);
  double diagonal = 0;
  for(int k = 0; k < 3; ++k) {
    const double side = before.max(k) - before.min(k);
    if(side > 0)
      loss.bounding_box = std::max(loss.bounding_box, 1 - (after.max(k) - after.min(k)) / side);
    diagonal = std::hypot(diagonal, side);
  }

  // The distances of the centres of faces, which count as much as their areas.
  Tree tree(samples.begin(), samples.end());
  std::vector<std::pair<double, double>> distances;
  double whole = 0;
  for(std::size_t f = 0; f < shape.size(); f += 1 + shape.size() / most_queries) {
    const double area = std::sqrt(shape[f].squared_area());
    distances.emplace_back(std::sqrt(tree.squared_distance(CGAL::centroid(shape[f]))), area);
    whole += area;
  }
  std::sort(distances.begin(), distances.end());
  double area = 0;
  for(const auto& [distance, of_face] : distances) {
    loss.distance = diagonal > 0 ? distance / diagonal : 0;
    area += of_face;
    if(area >= share * whole)
      break;
  }
  return loss;
}

} // namespace tool
