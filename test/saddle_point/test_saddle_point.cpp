// SPDX-License-Identifier: GPL-3.0-or-later
// The published method.

#include "helpers/check.h"
#include "helpers/meshes.h"

#include <catch2/catch.hpp>

using namespace test;

namespace {

SP::Saddle_point published(Splitting splitting, double relaxation)
{
  SP::Saddle_point method;
  method.splitting = splitting;
  method.relaxation = relaxation;
  method.check_interval = 50;
  return method;
}

Settings three_fixed(const Soup& soup)
{
  const Sphere natural = solve_or_throw(soup);
  Settings settings;
  for(std::size_t vertex : {0, 4, 8})
    settings.fixed[vertex] = natural[vertex];
  return settings;
}

} // namespace

TEST_CASE("with three fixed vertices both methods find the same map", "[saddle_point][each_policy]")
{
  const Soup soup = bumpy_sphere(2);
  Settings settings = three_fixed(soup);
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED);
  const Sphere expected = solve_or_throw(soup, settings);

  settings.method = GENERATE(published(Splitting::JACOBI, 0.5), published(Splitting::JACOBI, 0.95),
                             published(Splitting::GAUSS_SEIDEL, 0.9), published(Splitting::GAUSS_SEIDEL, 1.7));
  settings.accuracy = 1e-9;
  settings.number_of_iterations = 1000;
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(result);
  CHECK(distance(expected, sphere) < 1e-6);
  CHECK(result.sweeps > 0);
  CHECK(result.iterations > 1);
  CHECK(result.iterations < 1000);
  check_certificate(result, soup, sphere, settings);
}

TEST_CASE("Gauss-Seidel needs fewer sweeps than Jacobi", "[saddle_point]")
{
  const Soup soup = bumpy_sphere(2);
  Settings settings = three_fixed(soup);
  settings.accuracy = 1e-7;
  settings.number_of_iterations = 1000;
  Sphere sphere;
  settings.method = published(Splitting::JACOBI, 0.95);
  const Result jacobi = solve(soup, sphere, settings);
  settings.method = published(Splitting::GAUSS_SEIDEL, 1.5);
  const Result gauss_seidel = solve(soup, sphere, settings);
  REQUIRE(jacobi);
  REQUIRE(gauss_seidel);
  CHECK(gauss_seidel.sweeps < jacobi.sweeps);
}

TEST_CASE("without fixed vertices a stalled residual is not called converged", "[saddle_point]")
{
  // no symmetry, so that the boosts are really free to drift
  const Soup soup = spiky_star(2, 1.5);
  Settings settings;
  settings.method = GENERATE(published(Splitting::JACOBI, 0.95), published(Splitting::GAUSS_SEIDEL, 1.5));
  settings.accuracy = 1e-7;
  settings.number_of_iterations = 20;
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(result.error == Error_code::NOT_CONVERGED);
  CHECK(residual(make_springs(soup, settings.weights), sphere) > settings.accuracy);
  check_certificate(result, soup, sphere, settings);
}

TEST_CASE("the published method can be stopped between two checks of the residual", "[saddle_point]")
{
  SP::Saddle_point method;
  method.check_interval = 1000000000; // which would take hours
  Settings settings;
  settings.method = method;
  int calls = 0;
  settings.callback = [&](double) { return ++calls < 20; };
  Sphere sphere;
  CHECK(solve(spiky_star(3, 1.5), sphere, settings).error == Error_code::INTERRUPTED);
}

TEST_CASE("the start of the published method can be given", "[saddle_point]")
{
  const Soup soup = bumpy_sphere(2);
  Settings settings = three_fixed(soup);
  const Sphere solution = solve_or_throw(soup, settings);
  auto method = published(Splitting::GAUSS_SEIDEL, 1.5);
  settings.accuracy = 1e-7;
  settings.number_of_iterations = 1000;
  std::map<SP::Saddle_point::Start, std::size_t> iterations;
  using Start = SP::Saddle_point::Start;
  for(Start start : {Start::CENTROID, Start::HARMONIC, Start::GIVEN}) {
    method.start = start;
    settings.method = method;
    Sphere sphere = solution;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(int(start), result);
    CHECK(result);
    CHECK(distance(solution, sphere) < 1e-5);
    iterations[start] = result.iterations;
  }
  CHECK(iterations[Start::GIVEN] <= 1); // there already
  CHECK(iterations[Start::CENTROID] > 2);
}
