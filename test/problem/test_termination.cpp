// SPDX-License-Identifier: GPL-3.0-or-later
// Why a method ended is said beside the verdict, and only of the map that is stored.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <catch2/catch.hpp>

#include <cstddef>
#include <sstream>

using namespace test;
using SP::Termination;

namespace {

Settings isometric(std::size_t iterations, double accuracy)
{
  Settings settings;
  settings.method = SP::Isometric();
  settings.number_of_iterations = iterations;
  settings.accuracy = accuracy;
  return settings;
}

} // namespace

TEST_CASE("an isometric map has converged if one more step promises less than the accuracy", "[termination]")
{
  const Soup soup = spiky_star(3, 1.5);
  Sphere sphere;
  double before = 1;
  for(const std::size_t iterations : {0, 1, 2}) {
    const Result result = solve(soup, sphere, isometric(iterations, 1e-12));
    CAPTURE(iterations, result);
    CHECK(result.error == Error_code::NOT_CONVERGED);
    CHECK(result.termination == Termination::ITERATIONS);
    CHECK(result.iterations == iterations);
    CHECK(result.residual > 1e-12);
    CHECK(result.residual < before);
    before = result.residual;
    CHECK(count_flipped_faces(soup, sphere) == 0);
  }
  const Result result = solve(soup, sphere, isometric(20, SP::Isometric::default_accuracy));
  CHECK(result.error == Error_code::OK);
  CHECK(result.termination == Termination::CONVERGED);
  CHECK(result.residual <= SP::Isometric::default_accuracy);
}

TEST_CASE("the accuracy of an isometric map is the one that was asked for", "[termination]")
{
  const Soup soup = spiky_star(3, 1.5);
  Sphere rough, fine;
  const Result of_rough = solve(soup, rough, isometric(200, 1e-2));
  const Result of_fine = solve(soup, fine, isometric(200, 1e-9));
  CHECK(of_rough.termination == Termination::CONVERGED);
  CHECK(of_fine.termination == Termination::CONVERGED);
  CHECK(of_fine.residual <= 1e-9);
  CHECK(of_fine.iterations > of_rough.iterations);
  CHECK(of_fine.energy < of_rough.energy * (1 + 1e-6)); // of metrics with six digits
}

TEST_CASE("limits and refusals have their own reasons", "[termination]")
{
  const Soup soup = bumpy_sphere(3);
  Settings settings;
  Sphere sphere;
  SECTION("converged")
  {
    const Result result = solve(soup, sphere, settings);
    CHECK(result.termination == Termination::CONVERGED);
    REQUIRE(result.attempts.size() == 1);
    CHECK(result.attempts[0].termination == Termination::CONVERGED);
  }
  SECTION("iterations")
  {
    settings.number_of_iterations = 1;
    const Result result = solve(soup, sphere, settings);
    CHECK(result.error == Error_code::NOT_CONVERGED);
    CHECK(result.termination == Termination::ITERATIONS);
  }
  SECTION("callback")
  {
    settings.callback = [](double fraction) { return fraction < 0.5; };
    const Result result = solve(soup, sphere, settings);
    CHECK(result.error == Error_code::INTERRUPTED);
    CHECK(result.termination == Termination::CALLBACK);
  }
  SECTION("before there is a map")
  {
    const int last = GENERATE(1, 2); // of weights or levels, not yet of the solver
    int calls = 0;
    settings.callback = [&](double) { return ++calls < last; };
    const Result result = solve(soup, sphere, settings);
    CHECK(result.error == Error_code::INTERRUPTED);
    CHECK(result.termination == Termination::CALLBACK);
    CHECK(result.detail == "stopped by the callback before there was a map");
    CHECK(calls == last);
  }
  SECTION("no time at all")
  {
    settings.maximum_running_time = 0;
    const Result result = solve(soup, sphere, settings);
    CHECK(result.error == Error_code::INTERRUPTED);
    CHECK(result.termination == Termination::TIME);
    CHECK(result.iterations == 0);
  }
  SECTION("stalled")
  {
    settings.accuracy = 1e-30;
    const Result result = solve(soup, sphere, settings);
    CHECK(result.error == Error_code::NOT_CONVERGED);
    CHECK(result.termination == Termination::STALLED);
  }
  SECTION("refused")
  {
    const Result result = solve(torus(8, 8), sphere, settings);
    CHECK(result.error == Error_code::WRONG_GENUS);
    CHECK_FALSE(result.termination.has_value());
  }
}

TEST_CASE("what reads a result is told of a valid map that is not what was asked for", "[termination]")
{
  Result result;
  result.degree = 1;
  result.number_of_vertices = 100;
  const auto line = [&] {
    std::ostringstream out;
    out << result;
    return out.str();
  };
  CHECK(line().find("(100 vertices") != std::string::npos);
  result.degree = 0;
  CHECK(line().find("vertices") == std::string::npos); // there is no map
  result.termination = Termination::CONVERGED;
  CHECK(line().find("(100 vertices, 0 flipped faces, degree 0") != std::string::npos); // one that has collapsed
  result.degree = 1;
  CHECK(line().find("valid spherical map (100 vertices, 0 flipped") == 0);
  result.termination = Termination::STALLED;
  result.moved_vertices = 3;
  CHECK(line().find("3 vertices were moved off the solution so that their faces are valid") != std::string::npos);
  result.termination = Termination::ITERATIONS;
  result.moved_vertices = 0;
  CHECK(line().find("the accuracy was not reached when all iterations were made") != std::string::npos);
}
