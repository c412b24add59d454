// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "mapping/surface_distance.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;

Kernel::Point_3 point_of(const Point& p) { return {p[0], p[1], p[2]}; }

/// The largest squared distance of one of the points from the surface.
double largest_square(const Mesh& mesh, const std::vector<Point>& surface, const std::vector<Point>& points,
                      const SP::internal::Host_loop& loop)
{
  typedef std::vector<Kernel::Triangle_3> Triangles;
  typedef CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator> Primitive;
  Triangles triangles;
  for(const auto f : faces(mesh)) {
    const auto h = halfedge(f, mesh);
    const auto corner = [&](auto v) { return point_of(surface[static_cast<std::size_t>(v.idx())]); };
    triangles.emplace_back(corner(source(h, mesh)), corner(target(h, mesh)), corner(target(next(h, mesh), mesh)));
  }
  CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>> tree(triangles.begin(), triangles.end());
  tree.build();
  tree.accelerate_distance_queries();
  const auto squares =
    SP::internal::results_of_parts<1024>(loop, static_cast<int>(points.size()), [&](int begin, int end) {
      double largest = 0;
      for(int i = begin; i < end; ++i)
        largest = (std::max)(largest, tree.squared_distance(point_of(points[static_cast<std::size_t>(i)])));
      return largest;
    });
  return *std::max_element(squares.begin(), squares.end());
}

} // namespace

double hausdorff_distance(const Mesh& mesh, const std::vector<Point>& a, const std::vector<Point>& b, bool on_all_cores)
{
  const SP::internal::Host_loop loop(on_all_cores);
  return std::sqrt((std::max)(largest_square(mesh, a, b, loop), largest_square(mesh, b, a, loop)));
}

} // namespace tool
