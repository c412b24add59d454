// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/hard_maps.h"

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace test {
namespace {

Mapped_soup checked(Mapped_soup map)
{
  if(count_flipped_faces(map.soup, map.sphere) != 0 || degree(map.soup, map.sphere) != 1)
    throw std::logic_error("the map '" + map.name + "' is not valid");
  return map;
}

Mapped_soup solved(const std::string& name, const Soup& soup, Weights weights = Weights::BARYCENTRIC)
{
  Settings settings;
  settings.weights = weights;
  return checked({name, soup, solve_or_throw(soup, settings)});
}

Mapped_soup identity(const std::string& name, const Soup& soup) { return checked({name, soup, soup.points}); }

} // namespace

Mapped_soup needles(int n, double half_width, unsigned seed)
{
  const auto rotation = random_rotation(seed);
  const double pi = std::acos(-1.);
  Mapped_soup map;
  map.name = "needles " + std::to_string(half_width);
  std::vector<std::vector<std::size_t>>& faces = map.soup.faces;
  const std::size_t m = std::size_t(n), north = 2 * m, south = north + 1;
  for(std::size_t side = 0; side < 2; ++side)
    for(std::size_t i = 0; i < m; ++i) {
      const double angle = 2 * pi * (double(i) + double(side) / 2) / n, z = side == 0 ? half_width : -half_width;
      map.sphere.push_back(test::apply(rotation, Point(std::cos(angle), std::sin(angle), z)));
    }
  map.sphere.push_back(test::apply(rotation, Point(0, 0, 1)));
  map.sphere.push_back(test::apply(rotation, Point(0, 0, -1)));
  for(std::size_t i = 0; i < m; ++i) {
    const std::size_t j = (i + 1) % m;
    faces.push_back({i, j, north});
    faces.push_back({m + j, m + i, south});
    faces.push_back({i, m + i, j});
    faces.push_back({m + i, m + j, j});
  }
  map.soup.points = map.sphere;
  return checked(map);
}

Mapped_soup small_star(double scale, unsigned seed)
{
  const auto rotation = random_rotation(seed);
  const Soup soup = transformed(icosphere(2), [&](const Point& p) { return test::apply(rotation, p); });
  Mapped_soup map = {"small star " + std::to_string(scale), soup, soup.points};
  for(const auto& f : soup.faces)
    if(std::find(f.begin(), f.end(), 0) != f.end())
      for(std::size_t i : f)
        map.sphere[i] = soup.points[0] + scale * (soup.points[i] - soup.points[0]);
  return checked(map);
}

std::vector<Mapped_soup> hard_maps()
{
  return {identity("tetrahedron", transformed(tetrahedron(),
                                              [](const Point& p) {
                                                const double length = std::sqrt((p - CGAL::ORIGIN).squared_length());
                                                return Point(p.x() / length, p.y() / length, p.z() / length);
                                              })),
          identity("icosahedron", icosphere(0)),
          solved("octahedron", flat_octahedron(0)),
          solved("fine octahedron", flat_octahedron(3)),
          solved("cross", cross()),
          solved("dumbbell", dumbbell(3), Weights::CLAMPED),
          solved("star", spiky_star(4, 2), Weights::CLAMPED),
          solved("capsule", capsule(5, 24), Weights::CLAMPED),
          needles(12, 1e-3, 1),
          needles(12, 1e-6, 2),
          needles(5, 1e-9, 3),
          needles(40, 1e-12, 4),
          small_star(1e-5, 5),
          small_star(1e-9, 6),
          small_star(1e-12, 7)};
}

} // namespace test
