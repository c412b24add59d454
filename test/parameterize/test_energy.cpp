// SPDX-License-Identifier: GPL-3.0-or-later
// The energy falls from one iteration to the next.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <catch2/catch.hpp>

using namespace test;

namespace {

/// Runs 1, 2, 3 ... iterations and checks that no one raises the energy by more than the factor 1 + `rise`, and that
/// all together lower it.
void check_energy_falls(const Soup& soup, Settings settings, std::size_t last_iteration, int rises = 0)
{
  constexpr double rounding = 1e-13;
  double first = 0, previous = 0;
  for(std::size_t k = 1; k <= last_iteration; ++k) {
    settings.number_of_iterations = k;
    Sphere sphere;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(k, result);
    REQUIRE((result.error == Error_code::NOT_CONVERGED || result.error == Error_code::OK));
    REQUIRE(result.energy > 0);
    if(k == 1)
      first = result.energy;
    else if(result.energy > previous * (1 + rounding)) {
      CHECK(rises > 0);
      CHECK(result.energy < 1.01 * previous);
      --rises;
    }
    previous = result.energy;
    if(result)
      break;
  }
  CHECK(previous < first * (1 - 1e-9));
}

} // namespace

TEST_CASE("the energy falls monotonically in the fast method", "[energy]")
{
  // With exponent 2 a boost is nearly free. The balance that picks one refers to masses which are renewed as the
  // residual falls; the boost to the new balance may raise the energy, by little.
  const auto [exponent, rises] = GENERATE(std::pair(2., 15), std::pair(2.5, 0), std::pair(4., 0));
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED);
  settings.method = SP::Balanced{exponent};
  check_energy_falls(dumbbell(3), settings, 15, rises);
  check_energy_falls(spiky_star(3, 1.5), settings, 15, rises);
}

TEST_CASE("the energy falls monotonically in the fast method with fixed vertices", "[energy]")
{
  const Soup soup = dumbbell(3);
  const Sphere natural = solve_or_throw(soup);
  Settings settings;
  settings.method = SP::Balanced{GENERATE(2., 3.)};
  for(std::size_t vertex : {0, 5, 8, 11})
    settings.fixed[vertex] = natural[vertex];
  check_energy_falls(soup, settings, 15);
}

TEST_CASE("the energy falls monotonically in the published method", "[energy]")
{
  Settings settings;
  SP::Saddle_point method;
  method.splitting = GENERATE(Splitting::JACOBI, Splitting::GAUSS_SEIDEL);
  method.check_interval = 100;
  settings.method = method;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED);
  settings.accuracy = 1e-7;
  check_energy_falls(bumpy_sphere(2), settings, 10);
}
