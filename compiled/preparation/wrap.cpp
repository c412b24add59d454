// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/mend.h"
#include "preparation/points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_mesh_to_polygon_soup.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

/// Calls `go_on`, which may throw, again and again.
struct Stoppable : CGAL::Alpha_wraps_3::internal::Wrapping_default_visitor {
  const std::function<void()>& go_on;

  explicit Stoppable(const std::function<void()>& f) : go_on(f) {}

  template <class Wrapper, class Gate>
  void before_facet_treatment(const Wrapper&, const Gate&) const
  {
    go_on();
  }
};

} // namespace

Wrapping wrap(const Triangle_soup& soup, double alpha, double offset, const std::function<void()>& go_on)
{
  using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  std::vector<Point_3> points;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<Triangle_soup::Triangle> triangles;
  std::copy_if(soup.triangles.begin(), soup.triangles.end(), std::back_inserter(triangles),
               [&soup](const Triangle_soup::Triangle& t) { return is_face(soup, t); });
  CGAL::Surface_mesh<Point_3> mesh;
  Stoppable stoppable(go_on);
  const auto visited = CGAL::parameters::visitor(std::ref(stoppable));
  CGAL::alpha_wrap_3(points, triangles, alpha, offset, mesh, visited, visited); // CGAL 6 looks for it at the input
  Wrapping result;
  CGAL::Polygon_mesh_processing::polygon_mesh_to_polygon_soup(mesh, result.points, result.triangles);
  return result;
}

} // namespace CGAL::Spherical_parameterization::preparation
