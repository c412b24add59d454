// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/mend.h"
#include "preparation/points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <iterator>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {

Wrapping wrap(const Triangle_soup& soup, double alpha, double offset)
{
  using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point_3> points;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<Triangle_soup::Triangle> triangles;
  std::copy_if(soup.triangles.begin(), soup.triangles.end(), std::back_inserter(triangles),
               [&soup](const Triangle_soup::Triangle& t) { return has_finite_corners(soup, t); });
  CGAL::Surface_mesh<Point_3> mesh;
  CGAL::alpha_wrap_3(points, triangles, alpha, offset, mesh);
  Wrapping result;
  CGAL::Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, result.points, result.triangles);
  return result;
}

} // namespace CGAL::Spherical_parameterization::preparation
