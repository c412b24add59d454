// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "preparation/mend.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::preparation {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Wrap_mesh = CGAL::Surface_mesh<Kernel::Point_3>;

} // namespace

Wrapping wrap(const Triangle_soup& soup, double alpha, double offset)
{
  std::vector<Kernel::Point_3> points;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const auto& t : soup.triangles) {
    std::array<std::size_t, 3> corners;
    bool is_finite = true;
    for(std::size_t k = 0; k < 3; ++k) {
      corners[k] = static_cast<std::size_t>(t[k]);
      for(const double x : soup.points[corners[k]])
        is_finite = is_finite && std::isfinite(x);
    }
    if(is_finite)
      triangles.push_back(corners);
  }
  Wrap_mesh mesh;
  CGAL::alpha_wrap_3(points, triangles, alpha, offset, mesh);
  Wrapping result;
  for(const auto v : mesh.vertices()) {
    const Kernel::Point_3& p = mesh.point(v);
    result.points.push_back({p.x(), p.y(), p.z()});
  }
  for(const auto f : mesh.faces()) {
    std::array<int, 3>& corners = result.triangles.emplace_back();
    std::size_t k = 0;
    for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      corners[k++] = static_cast<int>(v.idx());
  }
  return result;
}

} // namespace CGAL::Spherical_parameterization::preparation
