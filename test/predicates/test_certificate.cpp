// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate in the result, figure by figure, against the independent one.

#include "helpers/check.h"
#include "helpers/meshes.h"

#include <catch2/catch.hpp>

#include <sstream>

using namespace test;

namespace {

const std::vector<std::pair<const char*, Soup>>& fixtures()
{
  static const std::vector<std::pair<const char*, Soup>> all = {{"tetrahedron", tetrahedron()},
                                                                {"icosphere", icosphere(3)},
                                                                {"flat octahedron", flat_octahedron(3)},
                                                                {"ellipsoid", ellipsoid(1, 2, 4, 3)},
                                                                {"bumpy sphere", bumpy_sphere(4)},
                                                                {"dumbbell", dumbbell(4)},
                                                                {"spiky star", spiky_star(4, 2)},
                                                                {"cube", cube()},
                                                                {"cross", cross()},
                                                                {"capsule", capsule(4, 24)},
                                                                {"collinear face", collinear_face()}};
  return all;
}

} // namespace

TEST_CASE("converged or not, the figures of the result are those of the map", "[certificate][each_policy]")
{
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED);
  settings.method = SP::Balanced{GENERATE(2., 3.)};
  settings.number_of_iterations = GENERATE(1u, 3u, 500u);
  for(const auto& [name, soup] : fixtures()) {
    Sphere sphere;
    const Result result = solve(soup, sphere, settings);
    INFO(name);
    check_certificate(result, soup, sphere, settings);
  }
}

TEST_CASE("closed surfaces of 100 vertices and more get valid maps", "[certificate]")
{
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED);
  settings.method = SP::Balanced{GENERATE(2., 3.)};
  for(const auto& [name, soup] : fixtures()) {
    if(soup.points.size() < 100)
      continue;
    Sphere sphere;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(name, result);
    CHECK(result);
    CHECK(count_flipped_faces(soup, sphere) == 0);
    CHECK(degree(soup, sphere) == 1);
  }
}

TEST_CASE("mean value weights give valid maps", "[certificate]")
{
  Settings settings;
  settings.weights = Weights::MEAN_VALUE;
  for(const Soup& soup : {bumpy_sphere(3), dumbbell(3), spiky_star(3, 1.5), ellipsoid(1, 2, 4, 3)}) {
    Sphere sphere;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(result);
    CHECK(result);
    check_certificate(result, soup, sphere, settings);
  }
}

TEST_CASE("the result prints as one line with the verdict and the figures", "[certificate]")
{
  const Soup soup = icosphere(1);
  Sphere sphere;
  std::ostringstream out;
  out << solve(soup, sphere);
  CHECK(out.str().find("valid spherical map") == 0);
  CHECK(out.str().find("0 flipped faces, degree 1") != std::string::npos);
  CHECK(out.str().find('\n') == std::string::npos);
}
