// SPDX-License-Identifier: GPL-3.0-or-later
// Whole maps on every parallel backend: those of one core to the last bit, and interruptions.

#include "helpers/check.h"
#include "helpers/meshes.h"

#include <catch2/catch.hpp>

#include <thread>

using namespace test;

namespace {

void check_same_as_sequential(const Policy& policy, const Soup& soup, Settings settings)
{
  Sphere expected, sphere;
  const Result reference = solve(soup, expected, settings);
  settings.policy = policy;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(reference, result);
  CHECK(result.error == reference.error);
  CHECK(result.iterations == reference.iterations);
  CHECK(result.residual == reference.residual);
  CHECK(sphere == expected); // exactly
  check_certificate(result, soup, sphere, settings);
}

} // namespace

TEMPLATE_LIST_TEST_CASE("maps are those of one core, bit by bit", "[policies]", Parallel_policies)
{
  const auto policy = some_policy<TestType>();
  if(!policy)
    return;
  Settings settings;
  SECTION("conformal weights") { check_same_as_sequential(*policy, bumpy_sphere(4), settings); }
  SECTION("barycentric weights")
  {
    settings.weights = Weights::BARYCENTRIC;
    check_same_as_sequential(*policy, dumbbell(4), settings);
  }
  SECTION("a mesh smaller than a work-group") { check_same_as_sequential(*policy, tetrahedron(), settings); }
  SECTION("fixed vertices")
  {
    const Soup soup = bumpy_sphere(3);
    settings.fixed = {{0, Point(1, 0, 0)}, {100, Point(0, 1, 0)}, {200, Point(0, 0, 1)}};
    check_same_as_sequential(*policy, soup, settings);
  }
  SECTION("the published method, Jacobi")
  {
    SP::Saddle_point method;
    method.check_interval = 50;
    settings.method = method;
    settings.number_of_iterations = 5;
    check_same_as_sequential(*policy, bumpy_sphere(2), settings);
  }
  SECTION("the published method, Gauss-Seidel")
  {
    SP::Saddle_point method;
    method.splitting = Splitting::GAUSS_SEIDEL;
    method.relaxation = 1.5;
    method.check_interval = 10;
    settings.method = method;
    settings.number_of_iterations = 5;
    check_same_as_sequential(*policy, bumpy_sphere(2), settings);
  }
}

TEMPLATE_LIST_TEST_CASE("a spring exponent above 2 gives the same bits on every backend", "[policies]",
                        Parallel_policies)
{
  const auto policy = some_policy<TestType>();
  if(!policy)
    return;
  Settings settings;
  settings.method = SP::Balanced{GENERATE(2.3, 2.5, 3.)};
  check_same_as_sequential(*policy, dumbbell(3), settings);
}

TEMPLATE_LIST_TEST_CASE("callback and time limit interrupt every backend", "[policies]", Parallel_policies)
{
  const auto policy = some_policy<TestType>();
  if(!policy)
    return;
  const Soup soup = dumbbell(3);
  Settings settings;
  settings.policy = *policy;
  SP::Saddle_point published;
  published.check_interval = 10;
  settings.method = GENERATE_COPY(decltype(settings.method)(SP::Balanced()), published);
  bool has_map = false;
  SECTION("callback")
  {
    settings.callback = [](double fraction) { return !(fraction > 0); };
    has_map = true;
  }
  SECTION("time limit") { settings.maximum_running_time = 0; }
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CHECK(result.error == Error_code::INTERRUPTED);
  if(has_map)
    check_certificate(result, soup, sphere, settings);
  else
    CHECK(result.detail.find("before there was a map") != std::string::npos);
}

TEMPLATE_LIST_TEST_CASE("several threads may share a policy", "[policies]", Parallel_policies)
{
  const auto policy = some_policy<TestType>();
  if(!policy)
    return;
  Settings settings;
  const std::vector<Soup> soups = {bumpy_sphere(3), dumbbell(3), icosphere(3), spiky_star(3, 2)};
  std::vector<Sphere> expected, spheres(soups.size());
  for(const Soup& soup : soups)
    expected.push_back(solve_or_throw(soup, settings));
  settings.policy = *policy;
  std::vector<std::thread> threads;
  for(std::size_t k = 0; k < soups.size(); ++k)
    threads.emplace_back([&, k] { solve(soups[k], spheres[k], settings); });
  for(std::thread& thread : threads)
    thread.join();
  CHECK(spheres == expected);
}
