// SPDX-License-Identifier: GPL-3.0-or-later
// Exponents above 2: no gauge, wider limbs.

#include "helpers/check.h"
#include "helpers/meshes.h"

#include <catch2/catch.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <cmath>

using namespace test;

namespace {

Settings with_exponent(double exponent)
{
  Settings settings;
  settings.method = SP::Balanced{exponent};
  return settings;
}

/// Standard deviation of log(source area / sphere area) over the faces.
double area_distortion(const Soup& soup, const Sphere& sphere)
{
  double sum = 0, squares = 0;
  for(const auto& f : soup.faces) {
    const double source = std::sqrt(CGAL::squared_area(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]));
    const double target = std::sqrt(CGAL::squared_area(sphere[f[0]], sphere[f[1]], sphere[f[2]]));
    const double x = std::log(source / target);
    sum += x;
    squares += x * x;
  }
  const double n = double(soup.faces.size());
  return std::sqrt(squares / n - sum * sum / (n * n));
}

} // namespace

TEST_CASE("a capsule that exponent 2 cannot map in doubles is valid with exponent 2.5", "[exponent][each_policy]")
{
  const Soup soup = capsule(12, 24);
  Settings settings = with_exponent(2.5);
  settings.weights = Weights::BARYCENTRIC;
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  REQUIRE(result);
  CHECK(residual(make_springs(soup, settings.weights), sphere, {}, 2.5) <= 1e-8);
  CHECK(count_flipped_faces(soup, sphere) == 0);
  check_certificate(result, soup, sphere, settings);
}

TEST_CASE("eq. (2) holds with the effective weights, without fixed vertices", "[exponent][each_policy]")
{
  const double exponent = GENERATE(2.5, 3., 4.);
  const Soup soup = spiky_star(3, 1.5);
  const Settings settings = with_exponent(exponent);
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(exponent, result);
  REQUIRE(result);
  CHECK(residual(make_springs(soup, settings.weights), sphere, {}, exponent) <= 1e-8);
  check_certificate(result, soup, sphere, settings);
}

TEST_CASE("a map without a step has its own energy", "[exponent]")
{
  const Soup soup = spiky_star(3, 1.5);
  Settings settings = with_exponent(GENERATE(2., 2.5, 3.));
  settings.accuracy = 1e3;
  Sphere sphere;
  const double energy = solve(soup, sphere, settings).energy;
  settings.accuracy = SP::Balanced::default_accuracy;
  settings.number_of_iterations = 0;
  CHECK(solve(soup, sphere, settings).energy == Approx(energy));
}

TEST_CASE("for exponents above 2, fixing vertices where the free map has them changes nothing", "[exponent]")
{
  // nothing balances the free map, so that it solves the constrained problem too
  const Soup soup = spiky_star(3, 1.5);
  Settings settings = with_exponent(3);
  const Sphere free_solution = solve_or_throw(soup, settings);
  for(std::size_t vertex : {1, 4, 9})
    settings.fixed[vertex] = free_solution[vertex];
  CHECK(distance(free_solution, solve_or_throw(soup, settings)) < 1e-7);
}

TEST_CASE("larger exponents make areas more equal", "[exponent]")
{
  const Soup soup = spiky_star(4, 2);
  double previous = 1e300;
  for(double exponent : {2., 3., 4.}) {
    const double distortion = area_distortion(soup, solve_or_throw(soup, with_exponent(exponent)));
    CAPTURE(exponent, distortion);
    CHECK(distortion < 0.98 * previous);
    previous = distortion;
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("maps of any exponent are the same bit by bit for any number of threads", "[exponent]")
{
  // Sums are taken in parts of 8192 vertices. It takes three parts that there is an order that could be wrong.
  const Soup soup = bumpy_sphere(6);
  Settings settings = with_exponent(GENERATE(2., 2.5, 4.));
  settings.number_of_iterations = 4; // of the same start: what differs at all differs soon
  settings.policy = CGAL::Sequential_tag();
  Sphere expected;
  const Result reference = solve(soup, expected, settings);
  settings.policy = CGAL::Parallel_tag();
  for(int threads : {2, 5}) {
    Sphere sphere;
    Result result;
    tbb::task_arena arena(threads);
    arena.execute([&] { result = solve(soup, sphere, settings); });
    CAPTURE(threads, reference, result);
    CHECK(result.iterations == reference.iterations);
    CHECK(result.residual == reference.residual);
    CHECK(result.energy == reference.energy);
    CHECK((sphere == expected)); // in brackets: no print-out of both
  }
}
#endif

TEST_CASE("an exponent whose springs are no doubles is named", "[exponent]")
{
  Sphere sphere;
  const Result result = solve(bumpy_sphere(3), sphere, with_exponent(900));
  CHECK(result.error == Error_code::BAD_WEIGHT);
  CHECK(result.detail.find("exponent 900 ") < std::string::npos);
}
