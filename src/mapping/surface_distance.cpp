// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/surface_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Bbox_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/centroid.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef std::vector<Kernel::Triangle_3> Triangles;
typedef CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator> Primitive;
typedef CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> Tree;

/// A unit in which the squares of all coordinates are numbers; 0 if there is none.
double largest_coordinate(const std::vector<Point>& points)
{
  double largest = 0;
  for(const Point& p : points)
    largest = std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  return largest;
}

Kernel::Point_3 point_of(const Point& p, double unit) { return {p[0] / unit, p[1] / unit, p[2] / unit}; }

/// The faces of `mesh` over `points`.
Triangles triangles_of(const Mesh& mesh, const std::vector<Point>& points, double unit)
{
  Triangles result;
  result.reserve(mesh.number_of_faces());
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto corner = [&](std::size_t k) {
      return point_of(points[static_cast<std::size_t>(mesh.triangle(f)[k])], unit);
    };
    result.emplace_back(corner(0), corner(1), corner(2));
  }
  return result;
}

/// The largest squared distance of one of the points from the surface.
double largest_square(const Triangles& surface, const std::vector<Point>& points, double unit,
                      const SP::internal::Host_loop& loop)
{
  Tree tree(surface.begin(), surface.end());
  tree.build();
  tree.accelerate_distance_queries();
  const auto squares =
    SP::internal::results_of_parts<1024>(loop, static_cast<int>(points.size()), [&](int begin, int end) {
      double largest = 0;
      for(int i = begin; i < end; ++i)
        largest = (std::max)(largest, tree.squared_distance(point_of(points[static_cast<std::size_t>(i)], unit)));
      return largest;
    });
  return *std::max_element(squares.begin(), squares.end());
}

CGAL::Bbox_3 box_of(const Triangles& triangles)
{
  CGAL::Bbox_3 box;
  for(const auto& t : triangles)
    box += t.bbox();
  return box;
}

} // namespace

double hausdorff_distance(const Mesh& mesh, const std::vector<Point>& a, const std::vector<Point>& b, bool on_all_cores)
{
  const SP::internal::Host_loop loop(on_all_cores);
  const double unit = (std::max)(largest_coordinate(a), largest_coordinate(b));
  if(unit == 0)
    return 0;
  return unit * std::sqrt((std::max)(largest_square(triangles_of(mesh, a, unit), b, unit, loop),
                                     largest_square(triangles_of(mesh, b, unit), a, unit, loop)));
}

Sampling_loss sampling_loss(const Mesh& mesh, const Mesh& sampled, const std::vector<Point>& points)
{
  constexpr std::size_t most_queries = 100000;
  constexpr double share = 0.99;
  const double unit = largest_coordinate(mesh.points());
  if(unit == 0)
    return {};
  const Triangles shape = triangles_of(mesh, mesh.points(), unit), samples = triangles_of(sampled, points, unit);

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
