// SPDX-License-Identifier: GPL-3.0-or-later
// The automatic method hands over the map that was asked for where that is valid, and else the next one that is.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <random>
#include <utility>
#include <vector>

using namespace test;

namespace {

Result solve_automatically(const Soup& soup, Sphere& sphere, Settings settings = {})
{
  settings.method = SP::Automatic();
  Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(bool(result));
  CHECK(count_flipped_faces(soup, sphere) == 0);
  CHECK(degree(soup, sphere) == 1);
  return result;
}

double area(const Point& a, const Point& b, const Point& c)
{
  return std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / 2;
}

/// By how much the lengths of every face shrink, against the mean of the map, and its share of the surface; those that
/// shrink most first.
std::vector<std::pair<double, double>> shrinkage(const Soup& soup, const Sphere& sphere)
{
  std::vector<std::pair<double, double>> faces;
  double whole = 0;
  for(const auto& f : soup.faces)
    whole += area(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]);
  for(const auto& f : soup.faces) {
    const double share = area(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]) / whole;
    faces.emplace_back(std::sqrt(4 * 3.14159265 * share / area(sphere[f[0]], sphere[f[1]], sphere[f[2]])), share);
  }
  std::sort(faces.rbegin(), faces.rend());
  return faces;
}

} // namespace

TEST_CASE("automatic: where the map asked for is valid, it is that one", "[automatic][each_policy]")
{
  const Soup soup = spiky_star(4, 1.5);
  Sphere sphere, balanced;
  const Result result = solve_automatically(soup, sphere);
  CHECK(result.method == "balanced");
  CHECK(result.fallback_reason.empty());
  const Result expected = solve(soup, balanced);
  CHECK(sphere == balanced);
  CHECK(result.residual == expected.residual);
}

TEST_CASE("automatic: isometric where no harmonic map is valid", "[automatic][each_policy]")
{
  Sphere sphere;
  const Result result = solve_automatically(capsule(30, 12), sphere);
  CHECK(result.method == "isometric");
  CHECK(result.fallback_reason.find("balanced: ") == 0);
  CHECK(result.fallback_reason.find("flipped") != std::string::npos);
  CHECK(result.fallback_reason.find("use ") == std::string::npos); // no advice to do what has been done
}

TEST_CASE("automatic: a valid map that leaves nothing of a limb is passed over, with the reason", "[automatic]")
{
  const Soup soup = capsule(6, 24);
  Settings settings;
  Sphere sphere, first;
  REQUIRE(solve(soup, first, settings)); // it is valid
  Result result = solve_automatically(soup, sphere, settings);
  CHECK(result.method == "isometric");
  CHECK(result.fallback_reason.find("balanced: valid, but lengths shrink more than 1e+04 times on ") == 0);
  REQUIRE(result.attempts.size() == 2);
  CHECK(result.attempts[0].error == Error_code::OK);
  CHECK_FALSE(result.attempts[0].detail.empty());

  SP::Automatic any;
  any.largest_shrinkage = std::numeric_limits<double>::infinity();
  settings.method = any;
  result = solve(soup, sphere, settings);
  CHECK(result.method == "balanced");
  CHECK(result.fallback_reason.empty());
  CHECK(sphere == first);
}

TEST_CASE("automatic: the spikes of noise are no limbs", "[automatic]")
{
  std::minstd_rand random;
  const Soup soup = transformed(icosphere(6), [&](const Point& p) {
    const double radius = 0.95 + 0.1 * static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max());
    return Point(radius * p.x(), radius * p.y(), radius * p.z());
  });
  SP::Automatic method;
  method.largest_shrinkage = 30;
  Settings settings;
  settings.method = method;
  settings.weights = Weights::CONFORMAL;
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  REQUIRE(bool(result));
  CHECK(result.method == "balanced");
  CHECK(result.fallback_reason.empty());

  double shrunk = 0; // there are such spikes
  for(const auto& [times, share] : shrinkage(soup, sphere))
    shrunk += times > method.largest_shrinkage ? share : 0;
  CHECK(shrunk > 1e-3);
}

TEST_CASE("automatic: a thousandth of the surface decides", "[automatic]")
{
  const Soup soup = transformed(capsule(3, 48), [](const Point& p) { // no two faces are alike
    const double bump = 1 + 0.05 * std::sin(3 * p.x() + 1) * std::cos(4 * p.y() + 2) * std::sin(p.z());
    return Point(bump * p.x(), bump * p.y(), bump * p.z());
  });
  Sphere balanced, sphere;
  REQUIRE(solve(soup, balanced));
  double share = 0, less = 0, more = 0; // the bounds beyond which there is less, and more, than a thousandth
  for(const auto& [times, of_face] : shrinkage(soup, balanced)) {
    share += of_face;
    if(share < 0.7e-3)
      less = times;
    if(share > 1.4e-3 && more == 0) {
      more = times;
      CHECK(share < 5e-3);
    }
  }
  REQUIRE(less > more);
  REQUIRE(more > 1);
  Settings settings;
  SP::Automatic method;
  method.largest_shrinkage = 0.999 * less;
  settings.method = method;
  CHECK(solve(soup, sphere, settings).method == "balanced");
  method.largest_shrinkage = 0.999 * more;
  settings.method = method;
  CHECK(solve(soup, sphere, settings).method == "isometric");
}

TEST_CASE("automatic: an extreme map is better than none", "[automatic]")
{
  // vertices are fixed, which the isometric method cannot keep
  const Soup soup = capsule(6, 24);
  Settings settings;
  Sphere first, sphere;
  REQUIRE(solve(soup, first, settings));
  for(std::size_t i = 0; i < first.size(); i += 3)
    settings.fixed[i] = first[i];
  settings.method = SP::Automatic();
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  if(result.method == "balanced" && result) {
    CHECK(result.fallback_reason.find("balanced: valid, but") == 0);
    CHECK(sphere[0] == first[0]);
  } else
    CHECK(result.method == "isometric");
}

TEST_CASE("automatic: what is right but extreme is better than what has not converged", "[automatic]")
{
  Settings settings;
  settings.method = SP::Automatic{2, 1, 1.01};
  settings.number_of_iterations = 1;
  Sphere sphere;
  const Soup soup = spiky_star(4, 1.5);
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(result.error == Error_code::OK);
  CHECK(result.method == "isometric");
  CHECK(count_flipped_faces(soup, sphere) == 0);
}

TEST_CASE("automatic: tubes of any length, spirals, combs, trees and needles have valid maps", "[automatic]")
{
  Sphere sphere;
  SECTION("capsules") { solve_automatically(capsule(GENERATE(1., 3., 10., 100.), 8), sphere); }
  SECTION("spirals") { solve_automatically(spiral(GENERATE(2, 8), 8), sphere); }
  SECTION("comb") { solve_automatically(comb(200, 3), sphere); }
  SECTION("tree") { solve_automatically(tree(6), sphere); }
  SECTION("needles") { solve_automatically(needles(3, 1e-9), sphere); }
  SECTION("plates and rods")
  {
    const double thickness = GENERATE(1e-4, 1e4);
    solve_automatically(
      transformed(bumpy_sphere(3), [=](const Point& p) { return Point(p.x(), p.y(), thickness * p.z()); }), sphere);
  }
}

TEST_CASE("automatic: isometric where a face without area leaves no weights", "[automatic]")
{
  Settings settings;
  settings.weights = Weights::MEAN_VALUE;
  Sphere sphere;
  const Result result = solve_automatically(coincident_points(), sphere, settings);
  CHECK(result.method == "isometric");
  CHECK(!result.fallback_reason.empty());
}

TEST_CASE("automatic: weights that are wrong are refused all the same", "[automatic]")
{
  Settings settings;
  settings.method = SP::Automatic();
  settings.weight_of_edge[3] = -1;
  Sphere sphere;
  CHECK(solve(icosphere(2), sphere, settings).error == Error_code::BAD_WEIGHT);

  Soup short_edge = icosphere(2); // whose faces are thin, and not flat
  const auto& f = short_edge.faces[0];
  short_edge.points[f[0]] = short_edge.points[f[1]] + 1e-9 * (short_edge.points[f[0]] - short_edge.points[f[1]]);
  settings.weight_of_edge = {{GENERATE(0u, 1u, 2u), -1}}; // of that face
  CHECK(solve(short_edge, sphere, settings).error == Error_code::BAD_WEIGHT);
}

TEST_CASE("automatic: fixed vertices are kept where only the isometric method can", "[automatic][each_policy]")
{
  const Soup soup = capsule(30, 12);
  Settings settings;
  settings.method = SP::Automatic();
  settings.number_of_iterations = 30;
  settings.fixed = {{0, Point(1, 0, 0)}, {100, Point(0, 1, 0)}, {200, Point(0, 0, 1)}};
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(bool(result));
  CHECK(result.method == "isometric");
  CHECK(result.attempts.size() == 2);
  CHECK(result.fallback_reason.find("balanced: ") == 0);
  CHECK(sphere[100] == Point(0, 1, 0));
}

TEST_CASE("automatic: stopping it stops all of it", "[automatic]")
{
  Settings settings;
  settings.method = SP::Automatic();
  settings.callback = [](double fraction) { return fraction < 0.2; };
  Sphere sphere;
  CHECK(solve(capsule(30, 12), sphere, settings).error == Error_code::INTERRUPTED);
}

TEST_CASE("automatic: a map that is of no use is not the answer where time or patience are over", "[automatic]")
{
  const Soup soup = capsule(6, 24);
  for(const double most : {0.55, 0.7}) {
    Settings settings;
    settings.method = SP::Automatic();
    settings.callback = [most](double fraction) { return fraction < most; };
    Sphere sphere;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(most, result);
    REQUIRE(result.attempts.size() == 2); // the first map is valid, and shrinks the limb too much
    CHECK(result.attempts[0].error == Error_code::OK);
    CHECK(result.error == Error_code::INTERRUPTED);
    CHECK(result.termination == SP::Termination::CALLBACK);
  }
}

TEST_CASE("automatic: the progress never goes back, and every map that is tried moves it", "[automatic]")
{
  Settings settings;
  settings.method = SP::Automatic();
  std::vector<double> fractions;
  settings.callback = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  Sphere sphere;
  SECTION("the first one is valid")
  {
    CHECK(solve(spiky_star(3, 1), sphere, settings).method == "balanced");
    CHECK(*std::prev(fractions.end(), 2) <= 0.5); // others might have been needed
  }
  SECTION("the last one is valid")
  {
    CHECK(solve(capsule(30, 12), sphere, settings).method == "isometric");
    for(const double begin : {0., 0.5})
      CHECK(std::count_if(fractions.begin(), fractions.end(), [&](double f) { return f > begin && f < begin + 0.5; }) >
            5);
  }
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.back() == 1);
}

TEST_CASE("automatic: every second of every attempt is accounted for", "[automatic]")
{
  Settings settings;
  settings.method = SP::Automatic();
  Sphere sphere;
  const Result result = solve(capsule(30, 24), sphere, settings);
  REQUIRE(result.attempts.size() == 2);
  CHECK(result.attempts[0].method == "balanced");
  CHECK(result.attempts[1].method == "isometric");
  CHECK(result.attempts[0].error == Error_code::NOT_BIJECTIVE);
  CHECK(result.attempts[1].error == Error_code::OK);
  CHECK(result.attempts[1].termination == result.termination);
  double of_attempts = 0;
  for(const Result::Attempt& attempt : result.attempts) {
    CHECK((attempt.error == Error_code::OK) == attempt.detail.empty());
    CHECK(attempt.seconds.start_map + attempt.seconds.solve + attempt.seconds.certify ==
          Approx(attempt.seconds.total).epsilon(0.02).margin(1e-3));
    of_attempts += attempt.seconds.total;
  }
  const Result::Seconds& s = result.seconds;
  CHECK(s.start_map + s.solve + s.certify == Approx(of_attempts).epsilon(0.02).margin(1e-3));
  CHECK(s.read + s.weights + s.start_map + s.solve + s.certify == Approx(s.total).epsilon(0.02).margin(2e-3));
}

TEST_CASE("automatic: the report is that of the map that is handed over", "[automatic]")
{
  // A face that fixed vertices flip: no method finds a valid map.
  const Soup soup = capsule(30, 12);
  Settings settings;
  settings.method = SP::Automatic();
  settings.weights = Weights::BARYCENTRIC;
  const auto& flipped = soup.faces[300];
  settings.fixed = {{flipped[0], Point(1, 0, 0)}, {flipped[2], Point(0, 1, 0)}, {flipped[1], Point(0, 0, 1)}};
  Sphere sphere, balanced;
  const Result result = solve(soup, sphere, settings);
  settings.method = SP::Balanced();
  const Result expected = solve(soup, balanced, settings);
  CAPTURE(result.fallback_reason, result.detail);
  CHECK(expected.error == Error_code::NOT_BIJECTIVE);
  REQUIRE(result.attempts.size() == 2);
  CHECK(result.attempts[0].error == expected.error);
  CHECK(result.attempts[0].termination == expected.termination);
  CHECK(result.error == Error_code::BAD_CONSTRAINTS); // which of them contradict the mesh is of more use than a map
  CHECK_FALSE(result.termination.has_value());
}
