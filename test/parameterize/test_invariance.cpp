// SPDX-License-Identifier: GPL-3.0-or-later
// Where the mesh lies, how large it is and how it is numbered changes nothing.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <catch2/catch.hpp>

using namespace test;

namespace {

Soup fixture(int i) { return i == 0 ? bumpy_sphere(3) : i == 1 ? dumbbell(3) : spiky_star(3, 1.5); }

} // namespace

TEST_CASE("rotating, scaling and translating the mesh changes nothing", "[invariance]")
{
  const double tolerance = 1e-7;
  const Soup soup = fixture(GENERATE(0, 1, 2));
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED, Weights::CONFORMAL);
  settings.method = SP::Balanced{GENERATE(2., 3.)};
  const Sphere sphere = solve_or_throw(soup, settings);

  const auto rotation = random_rotation(1);
  const Soup rotated = transformed(soup, [&](const Point& p) { return apply(rotation, p); });
  CHECK(distance_up_to_rotation(sphere, solve_or_throw(rotated, settings)) < tolerance);
  for(double s : {1e-6, 1e6}) {
    const Soup scaled = transformed(soup, [=](const Point& p) { return Point(s * p.x(), s * p.y(), s * p.z()); });
    CHECK(distance_up_to_rotation(sphere, solve_or_throw(scaled, settings)) < tolerance);
  }
  const Soup moved = transformed(soup, [](const Point& p) { return Point(p.x() + 10, p.y() - 20, p.z() + 5); });
  CHECK(distance_up_to_rotation(sphere, solve_or_throw(moved, settings)) < tolerance);
}

TEST_CASE("meshes as large or small as doubles allow are mapped", "[invariance]")
{
  const double s = GENERATE(1e-300, 1e-150, 1e150, 1e300);
  const Soup scaled =
    transformed(bumpy_sphere(2), [=](const Point& p) { return Point(s * p.x(), s * p.y(), s * p.z()); });
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED, Weights::CONFORMAL);
  CHECK(distance_up_to_rotation(solve_or_throw(bumpy_sphere(2), settings), solve_or_throw(scaled, settings)) < 1e-6);
}

TEST_CASE("renumbering vertices and faces permutes the result", "[invariance]")
{
  const auto [exponent, tolerance] = GENERATE(std::pair(2., 1e-8), std::pair(3., 1e-7));
  const Soup soup = fixture(GENERATE(0, 1, 2));
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED, Weights::CONFORMAL);
  settings.method = SP::Balanced{exponent};
  const Sphere sphere = solve_or_throw(soup, settings);
  for(unsigned seed : {1, 2}) {
    std::vector<std::size_t> order;
    const Soup other = renumbered(soup, seed, order);
    Sphere permuted;
    for(std::size_t i : order)
      permuted.push_back(sphere[i]);
    CHECK(distance_up_to_rotation(permuted, solve_or_throw(other, settings)) < tolerance);
  }
}

TEST_CASE("the same call gives the same bits", "[invariance][each_policy]")
{
  const Soup soup = fixture(2);
  Settings settings;
  settings.method = GENERATE(decltype(settings.method)(SP::Balanced()), SP::Saddle_point(), SP::Isometric());
  settings.number_of_iterations = 5;
  Sphere first, second;
  const Result result = solve(soup, first, settings);
  CHECK(solve(soup, second, settings).residual == result.residual);
  CHECK(first == second);
}
