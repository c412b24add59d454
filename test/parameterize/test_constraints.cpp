// SPDX-License-Identifier: GPL-3.0-or-later
// Fixed vertices.

#include "helpers/check.h"
#include "helpers/meshes.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>
#include <string>

using namespace test;

namespace {

/// Near `p`, on the sphere.
Point nudged(const Point& p, const Vector& by)
{
  const Vector v = p - CGAL::ORIGIN + by;
  return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
}

} // namespace

TEST_CASE("fixed vertices stay where they are, and eq. (2) holds at all others", "[constraints][each_policy]")
{
  // The more a mesh is drawn in, the more vertices it takes to hold a valid map: on the dumbbell, those of level 1.
  const bool is_dumbbell = GENERATE(false, true);
  const Soup soup = is_dumbbell ? dumbbell(3) : bumpy_sphere(3);
  std::vector<std::size_t> vertices = {4, 5, 6, 7};
  if(is_dumbbell) {
    vertices.resize(icosphere(1).points.size());
    std::iota(vertices.begin(), vertices.end(), 0);
  }
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED);
  const Sphere natural = solve_or_throw(soup, settings);
  for(std::size_t vertex : vertices)
    settings.fixed[vertex] = nudged(natural[vertex], Vector(0.002, -0.001, 0.001 * double(vertex % 3)));

  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  REQUIRE(result);
  std::vector<std::size_t> fixed;
  for(const auto& [vertex, position] : settings.fixed) {
    CHECK(sphere[vertex] == position);
    fixed.push_back(vertex);
  }
  CHECK(residual(make_springs(soup, settings.weights), sphere, fixed) <= 1e-8);
  CHECK(residual(make_springs(soup, settings.weights), sphere) > 1e-5); // the fixed ones are held against a force
  check_certificate(result, soup, sphere, settings);
}

TEST_CASE("an icosphere with some vertices fixed where they are is the icosphere", "[constraints]")
{
  // Enough of them, and far enough apart, that the symmetric solution is a minimum of the energy, not a saddle: on
  // level 0 that takes six, on level 1 three (but not the three corners of a face).
  const int level = GENERATE(0, 1);
  const Soup soup = icosphere(level);
  const auto rotation = random_rotation(3);
  const Sphere rotated = transformed(soup, [&](const Point& p) { return apply(rotation, p); }).points;
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED);
  for(std::size_t vertex : level == 0 ? std::vector<std::size_t>{4, 5, 6, 7, 8, 9} : std::vector<std::size_t>{0, 4, 8})
    settings.fixed[vertex] = rotated[vertex];
  CHECK(distance(rotated, solve_or_throw(soup, settings)) < 1e-8);
}

TEST_CASE("all vertices fixed: nothing is left to do but to certify", "[constraints]")
{
  const Soup soup = icosphere(1);
  Settings settings;
  for(std::size_t i = 0; i < soup.points.size(); ++i)
    settings.fixed[i] = soup.points[i];
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(result);
  CHECK(sphere == soup.points);
  check_certificate(result, soup, sphere, settings);
}

TEST_CASE("all vertices fixed on a map that winds twice: no face is flipped, and yet it is no bijection",
          "[constraints]")
{
  const Soup soup = bipyramid(11);
  Settings settings;
  for(std::size_t i = 0; i < soup.points.size(); ++i) {
    const Point& p = soup.points[i];
    const double r = std::hypot(p.x(), p.y()), angle = 2 * std::atan2(p.y(), p.x());
    settings.fixed[i] = Point(r * std::cos(angle), r * std::sin(angle), p.z());
  }
  SECTION("springs: the map is that one, and the reason is its degree")
  {
    settings.method = GENERATE(decltype(settings.method)(SP::Balanced()), SP::Balanced{3}, SP::Saddle_point());
    Sphere sphere;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(result);
    CHECK(count_flipped_faces(soup, sphere) == 0);
    CHECK(degree(soup, sphere) == 2);
    CHECK((result.flipped_faces == 0 && result.degree == 2));
    CHECK(result.error == Error_code::NOT_BIJECTIVE);
    CHECK(result.detail.find("degree is 2") != std::string::npos);
  }
  SECTION("no method calls it valid")
  {
    settings.method = GENERATE(decltype(settings.method)(SP::Isometric()), SP::Automatic());
    Sphere sphere;
    CHECK_FALSE(solve(soup, sphere, settings));
  }
}

TEST_CASE("vertices fixed at mirrored positions do not pass for a valid map", "[constraints]")
{
  const Soup soup = icosphere(2);
  Settings settings;
  for(std::size_t vertex : {0, 1, 5, 7, 9})
    settings.fixed[vertex] = Point(-soup.points[vertex].x(), soup.points[vertex].y(), soup.points[vertex].z());
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CHECK_FALSE(result);
  CHECK(count_flipped_faces(soup, sphere) > 0);
  check_certificate(result, soup, sphere, settings);
}

TEST_CASE("fixed positions give directions: their length does not matter", "[constraints]")
{
  const Soup soup = icosphere(1);
  Settings settings;
  for(std::size_t vertex : {0, 4, 8})
    settings.fixed[vertex] = soup.points[vertex];
  const Sphere expected = solve_or_throw(soup, settings);
  for(auto& [vertex, position] : settings.fixed)
    position = CGAL::ORIGIN + double(2 + vertex) * (position - CGAL::ORIGIN);
  CHECK(distance(expected, solve_or_throw(soup, settings)) < 1e-9);
}
