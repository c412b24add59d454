// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/soup_checks.h"

#include "system/error_code_names.h"
#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/internal/mesh/check_soup.h>

#include <algorithm>
#include <cstddef>

namespace tool {
namespace {

namespace SP = CGAL::Spherical_parameterization;

/// Throws the `Refusal` of polygons that are no triangles.
void check_triangles(const std::string& file, const Polygon_soup& soup)
{
  const auto is_polygon = [](const Polygon& p) { return p.size() > 3; };
  const auto first = std::find_if(soup.polygons.begin(), soup.polygons.end(), is_polygon);
  if(first == soup.polygons.end())
    return;
  const auto count = std::count_if(first, soup.polygons.end(), is_polygon);
  throw Refusal(name(SP::Error_code::NOT_TRIANGULAR), file,
                "has " + std::to_string(count) +
                  (count == 1 ? " face that is no triangle" : " faces that are no triangles") + " (first: face " +
                  std::to_string(first - soup.polygons.begin()) + " with " + std::to_string(first->size()) +
                  " vertices)",
                "triangulate the mesh, or use --triangulate");
}

std::size_t number_of_different_points(std::vector<Point> points)
{
  std::sort(points.begin(), points.end());
  return static_cast<std::size_t>(std::unique(points.begin(), points.end()) - points.begin());
}

} // namespace

void check_triangulated_sphere(const std::string& file, const Polygon_soup& soup)
{
  check_triangles(file, soup);
  SP::internal::Corner_table table;
  table.face.reserve(soup.polygons.size());
  for(const Polygon& p : soup.polygons)
    table.face.push_back({static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2])});
  SP::internal::Host_array<int> last_corner;
  const SP::internal::Soup_trouble trouble =
    SP::internal::check_soup(SP::internal::Host_loop(true), table, static_cast<int>(soup.points.size()), last_corner,
                             [&] { return number_of_different_points(soup.points); });
  if(trouble.code != SP::Error_code::OK)
    throw Refusal(name(trouble.code), file, "has " + trouble.wrong, trouble.remedy);
}

} // namespace tool
