// SPDX-License-Identifier: GPL-3.0-or-later
// The isometric method finds a map of everything, moves as little as the surface allows, and slides from angle to area
// preservation.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>

#include <catch2/catch.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

using namespace test;

namespace {

Settings isometric(double area_exponent = 1)
{
  Settings settings;
  settings.method = SP::Isometric{area_exponent};
  settings.accuracy = SP::Isometric::default_accuracy;
  settings.number_of_iterations = SP::Isometric::default_number_of_iterations;
  return settings;
}

void check_valid(const Soup& soup, const Settings& settings = isometric())
{
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result, soup.points.size());
  CHECK(bool(result));
  CHECK(result.detail.empty());
  CHECK(result.method == "isometric");
  CHECK(result.flipped_faces == 0);
  CHECK(count_flipped_faces(soup, sphere) == 0);
  CHECK(degree(soup, sphere) == 1);
  CHECK(count_vertices_off_sphere(sphere) == 0);
}

/// What the map does to the faces, weighted with their source areas.
struct Figures {
  double symmetric_dirichlet = 0; ///< mean of s^2 + t^2 + 1/s^2 + 1/t^2, after scaling to equal areas
  double conformal = 0;           ///< mean of (s/t + t/s) / 2
  double log_area_deviation = 0;  ///< standard deviation, faces equally weighted
};

Figures measure(const Soup& soup, const Sphere& sphere)
{
  struct Face {
    double area, image, squares; ///< squares: s^2 + t^2
  };
  std::vector<Face> faces;
  double area = 0, image = 0;
  for(const auto& f : soup.faces) {
    const Vector a = soup.points[f[1]] - soup.points[f[0]], b = soup.points[f[2]] - soup.points[f[0]];
    const Vector c = sphere[f[1]] - sphere[f[0]], d = sphere[f[2]] - sphere[f[0]];
    const double twice_area = std::sqrt(CGAL::cross_product(a, b).squared_length());
    const double squares = (b * b * (c * c) - 2 * (a * b) * (c * d) + a * a * (d * d)) / (twice_area * twice_area);
    faces.push_back({twice_area / 2, std::sqrt(CGAL::cross_product(c, d).squared_length()) / 2, squares});
    area += faces.back().area;
    image += faces.back().image;
  }
  Figures figures;
  double sum = 0, square = 0;
  for(const Face& f : faces) {
    const double ratio = f.image / f.area, scaled = ratio * area / image;
    figures.symmetric_dirichlet += f.area / area * f.squares * area / image * (1 + 1 / (scaled * scaled));
    figures.conformal += f.area / area * f.squares / (2 * ratio);
    sum += std::log(scaled);
    square += std::log(scaled) * std::log(scaled);
  }
  const double n = double(faces.size());
  figures.log_area_deviation = std::sqrt(square / n - sum / n * sum / n);
  return figures;
}

Figures figures_of(const Soup& soup, const Settings& settings) { return measure(soup, solve_or_throw(soup, settings)); }

/// An icosphere with a neck of this width, and of half this length
Soup dumbbell_with_neck(int level, double neck, double length)
{
  return transformed(icosphere(level), [=](const Point& p) {
    const double width = neck + (1 - neck) * std::clamp((std::abs(p.z()) - 0.2) / 0.3, 0., 1.);
    return Point(width * p.x(), width * p.y(), length * p.z());
  });
}

} // namespace

TEST_CASE("small meshes have isometric maps", "[isometric]")
{
  check_valid(tetrahedron());
  check_valid(cube());
  check_valid(cross());
  check_valid(icosphere(0));
  check_valid(bipyramid(3));
  check_valid(collinear_face());
}

TEST_CASE("capsules of any length have isometric maps", "[isometric]")
{
  check_valid(capsule(GENERATE(1., 6., 12., 30., 100.), 12));
}

TEST_CASE("spirals, combs and trees have isometric maps", "[isometric]")
{
  SECTION("spiral") { check_valid(spiral(GENERATE(1, 4, 12), 10)); }
  SECTION("comb") { check_valid(comb(200, 5)); }
  SECTION("tree") { check_valid(tree(6)); }
  SECTION("star") { check_valid(spiky_star(4, 5)); }
}

TEST_CASE("needles have isometric maps", "[isometric]")
{
  check_valid(needles(3, GENERATE(1e-3, 1e-9, 1e-15)));
  check_valid(ellipsoid(1, 1, 1e9, 3));
  check_valid(ellipsoid(1, 1, 1e-9, 3));
}

TEST_CASE("faces without area do no harm to isometric maps", "[isometric]")
{
  check_valid(coincident_points());
  check_valid(many_coincident_points(4));
  check_valid(ellipsoid(1, 1, 0, 3));
  check_valid(one_point(2));
}

TEST_CASE("vertices of high degree have isometric maps", "[isometric]") { check_valid(bipyramid(1000)); }

TEST_CASE("an isometric map of a round sphere is the sphere", "[isometric]")
{
  const Soup soup = icosphere(4);
  CHECK(distance_up_to_rotation(soup.points, solve_or_throw(soup, isometric())) < 0.01);
  CHECK(figures_of(soup, isometric()).symmetric_dirichlet < 4.001);
}

TEST_CASE("isometric maps are far less distorted than conformal ones", "[isometric]")
{
  const Soup soup = spiky_star(4, 5);
  CHECK(figures_of(soup, isometric()).symmetric_dirichlet < 0.2 * figures_of(soup, Settings()).symmetric_dirichlet);
}

TEST_CASE("the exponent slides from angle to area preservation", "[isometric]")
{
  const Soup soup = GENERATE(0, 1) == 0 ? spiky_star(4, 1.5) : dumbbell(4);
  Figures before = figures_of(soup, isometric(0));
  for(double exponent : {0.3, 1., 3., 10., 30.}) {
    const Figures next = figures_of(soup, isometric(exponent));
    CAPTURE(exponent);
    CHECK(next.log_area_deviation < before.log_area_deviation);
    CHECK(next.conformal > before.conformal);
    before = next;
  }
  CHECK(before.log_area_deviation < 0.1);
}

TEST_CASE("the isometric energy is the one that is reported", "[isometric]")
{
  // On a fine mesh, where the determinant of a triangle is twice its area.
  const Soup soup = bumpy_sphere(5);
  Sphere sphere;
  const Result result = solve(soup, sphere, isometric());
  CHECK(result.energy == Approx(measure(soup, sphere).symmetric_dirichlet).epsilon(1e-3));
  CHECK(result.smallest_edge > 1e9);
}

TEST_CASE("the energy is that of the map that is stored, in the scale that fits it", "[isometric]")
{
  const Soup soup = GENERATE(ellipsoid(1, 1, 2, 0), flat_octahedron(2), ellipsoid(1, 2, 8, 2), bumpy_sphere(3));
  Sphere sphere;
  const Result result = solve(soup, sphere, isometric());
  const Mesh mesh = make_mesh(soup);
  CHECK(result.energy ==
        Approx(SP::distortion_summary(mesh, on(sphere)).spherical_symmetric_dirichlet.mean).epsilon(1e-5));
}

TEST_CASE("no face of a dumbbell with a thin neck covers much of the sphere", "[isometric]")
{
  const double exponent = GENERATE(1., 2., 3., 10.);
  const auto [neck, length] = GENERATE(std::pair(0.035, 2.09), std::pair(0.12, 3.58), std::pair(0.3, 2.));
  const Soup soup = dumbbell_with_neck(4, neck, length);
  Settings settings = isometric();
  settings.method = SP::Isometric{exponent};
  double last = 0;
  settings.callback = [&](double fraction) {
    CHECK(fraction >= last); // there may be two maps
    last = fraction;
    return true;
  };
  const Sphere sphere = solve_or_throw(soup, settings);
  CAPTURE(exponent, neck, length);
  double largest = 0;
  for(const auto& f : soup.faces) {
    const Vector a = sphere[f[0]] - CGAL::ORIGIN, b = sphere[f[1]] - CGAL::ORIGIN, c = sphere[f[2]] - CGAL::ORIGIN;
    largest = std::max(largest, 2 * std::atan2(CGAL::cross_product(a, b) * c, 1 + a * b + b * c + c * a));
  }
  CHECK(largest < 0.01 * 4 * std::acos(-1.));
}

TEST_CASE("large exponents measure and fit areas by the scale of the map that they have got to", "[isometric]")
{
  const Soup soup = transformed(icosphere(0), [](const Point& p) { return Point(p.x(), p.y(), 2 * p.z()); });
  Settings settings = isometric();
  const auto energy = [&](double exponent) {
    settings.method = SP::Isometric{exponent};
    Sphere sphere;
    return solve(soup, sphere, settings).energy;
  };
  CHECK(energy(30) < 5.56); // 5.81 by the scale at the start
  CHECK(energy(100) < 5.56);
}

TEST_CASE("large exponents are not stuck where needles go far round the sphere", "[isometric]")
{
  const Soup soup = dumbbell_with_neck(3, 0.035, 2.09);
  Settings settings = isometric();
  settings.method = SP::Isometric{100};
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CHECK(result.termination != SP::Termination::STALLED);
  CHECK(result.energy < 45); // 409 with what the flat triangles take off
}

TEST_CASE("scaling by a power of two, and exact translations, leave isometric maps as they are", "[isometric]")
{
  const Soup soup = transformed(flat_octahedron(4), [](const Point& p) { return Point(p.x(), 2 * p.y(), 4 * p.z()); });
  const Sphere sphere = solve_or_throw(soup, isometric());
  for(int exponent : {-990, -100, 100, 990}) {
    const double s = std::ldexp(1., exponent);
    const Soup scaled = transformed(soup, [=](const Point& p) { return Point(s * p.x(), s * p.y(), s * p.z()); });
    CHECK(solve_or_throw(scaled, isometric()) == sphere);
  }
  const Soup moved =
    transformed(soup, [](const Point& p) { return Point(p.x() + (1 << 30), p.y() - (1 << 30), p.z() + 3); });
  CHECK(solve_or_throw(moved, isometric()) == sphere);
}

TEST_CASE("isometric maps do not depend on how the mesh is numbered", "[isometric]")
{
  // without symmetry, with spikes, and with many equal edges
  const int shape = GENERATE(0, 1, 2, 3);
  const Soup soup = shape == 0 ? bumpy_sphere(4) : shape == 1 ? spiky_star(4, 5) : shape == 2 ? tree(5) : icosphere(3);
  const Sphere sphere = solve_or_throw(soup, isometric());
  for(unsigned seed : {1, 2}) {
    CAPTURE(shape, seed);
    std::vector<std::size_t> order;
    const Sphere other = solve_or_throw(renumbered(soup, seed, order), isometric());
    for(std::size_t i = 0; i < order.size(); ++i)
      REQUIRE(other[i] == sphere[order[i]]);
  }
}

TEST_CASE("a mesh that is turned, scaled and moved has the same isometric map, bit for bit", "[isometric]")
{
  const int shape = GENERATE(0, 1, 2);
  const Soup soup = shape == 0 ? bumpy_sphere(5) : shape == 1 ? spiky_star(4, 1.5) : spiky_star(4, 5);
  const Sphere sphere = solve_or_throw(soup, isometric());
  for(unsigned seed : {1, 2, 3}) {
    CAPTURE(shape, seed);
    const std::array<Vector, 3> rows = random_rotation(seed);
    const Soup turned = transformed(soup, [&](const Point& p) {
      const Vector x = 1.7 * (p - CGAL::ORIGIN) + Vector(3, 1, -2);
      return Point(rows[0] * x, rows[1] * x, rows[2] * x);
    });
    CHECK(solve_or_throw(turned, isometric()) == sphere);
  }
}

TEST_CASE("any scale and any place give valid isometric maps", "[isometric]")
{
  const double s = GENERATE(1e-300, 1e-150, 1e150, 1e300);
  check_valid(transformed(spiky_star(3, 2), [=](const Point& p) { return Point(s * p.x(), s * p.y(), s * p.z()); }));
  check_valid(transformed(spiky_star(3, 2), [](const Point& p) { return Point(p.x() + 1e9, p.y(), p.z() - 1e9); }));
}

TEST_CASE("large meshes have the energies of maps that are relaxed after every round", "[isometric]")
{
  // 40,962 vertices: the whole mesh is the only fine level. The energies are those of maps that were relaxed after
  // every round, at 1.6 times the cost.
  const auto [soup, energy] =
    GENERATE(0, 1) == 0 ? std::make_pair(spiky_star(6, 1.5), 6.25985) : std::make_pair(dumbbell(6), 6.91401);
  Sphere sphere;
  const Result result = solve(soup, sphere, isometric());
  CHECK(bool(result));
  CHECK(result.energy < 1.005 * energy);
}

TEST_CASE("the residual of a large mesh is that of the map, if by the matrix of the last step", "[isometric]")
{
  const Soup soup = spiky_star(7, 1.5); // 163,842 vertices
  Settings settings = isometric();
  Sphere sphere, other;
  const Result result = solve(soup, sphere, settings);
  settings.accuracy = std::nextafter(SP::Isometric::default_accuracy, 0); // then by a new matrix, and 100 iterations
  const Result exact = solve(soup, other, settings);
  CAPTURE(result, exact);
  REQUIRE((sphere == other)); // without their coordinates
  CHECK(result.residual > 0.4 * exact.residual);
  CHECK(result.residual < 1.25 * exact.residual);
}

TEST_CASE("large meshes of needles have isometric maps", "[isometric]")
{
  check_valid(needles(6, 1e-15)); // 68,269 vertices
}

TEST_CASE("isometric maps do not depend on the policy", "[isometric][each_policy]")
{
  const Soup soup = GENERATE(0, 1) == 0 ? spiky_star(5, 1.5) : spiky_star(6, 1.5); // coarse levels only, and fine ones
  Settings settings = isometric();
  settings.policy = CGAL::Sequential_tag();
  const Sphere sphere = solve_or_throw(soup, settings);
  settings.policy = default_policy();
  CHECK(solve_or_throw(soup, settings) == sphere);
#ifdef CGAL_LINKED_WITH_TBB
  settings.policy = CGAL::Parallel_tag();
  for(int threads : {1, 2, 5}) {
    tbb::task_arena arena(threads);
    arena.execute([&] { CHECK(solve_or_throw(soup, settings) == sphere); });
  }
#endif
}

TEST_CASE("the isometric method can be stopped at any time", "[isometric][each_policy]")
{
  const Soup soup = spiky_star(4, 1.5);
  Settings settings = isometric();
  const double when = GENERATE(0., 0.1, 0.3, 0.59);
  settings.callback = [=](double fraction) { return fraction <= when; };
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result, when);
  CHECK(result.error == Error_code::INTERRUPTED);
  CHECK(!result.detail.empty());

  settings.callback = [](double) { return true; };
  settings.maximum_running_time = 0;
  CHECK(solve(soup, sphere, settings).error == Error_code::INTERRUPTED);
}

TEST_CASE("an isometric map that is interrupted at the end is bijective", "[isometric]")
{
  const Soup soup = spiky_star(4, 1.5);
  Settings settings = isometric();
  settings.callback = [](double fraction) { return fraction < 0.6; }; // all vertices are there
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CHECK(result.error == Error_code::INTERRUPTED);
  CHECK(count_flipped_faces(soup, sphere) == 0);
  CHECK(degree(soup, sphere) == 1);
}

TEST_CASE("an isometric map that is interrupted anywhere on the last level is bijective", "[isometric][each_policy]")
{
  const Soup soup = spiky_star(6, 1.5);
  Settings settings = isometric();
  int left = GENERATE(2, 4, 7); // calls, 5 ms apart
  settings.callback = [&](double fraction) { return fraction < 0.6 || --left > 0; };
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CHECK(result.error == Error_code::INTERRUPTED);
  CHECK(std::isnan(result.residual)); // of a map that nobody has measured
  CHECK(count_flipped_faces(soup, sphere) == 0);
  CHECK(degree(soup, sphere) == 1);
}

TEST_CASE("no part of the isometric method keeps a callback waiting for long", "[isometric]")
{
  Settings settings = isometric();
  const SP::internal::Stopwatch watch;
  std::optional<double> last; // nothing, while the mesh is read: the callback may change it
  double longest = 0;
  settings.callback = [&](double) {
    const double now = watch.seconds();
    longest = (std::max)(longest, now - last.value_or(now));
    last = now;
    return true;
  };
  solve_or_throw(spiky_star(7, 1.5), settings); // 163,842 vertices
  CHECK(longest < 0.05 * watch.seconds());
}

TEST_CASE("the Newton steps of the whole mesh are no more than asked for, at any exponent", "[isometric]")
{
  Settings settings = isometric(10);
  settings.accuracy = 1e-12;
  const Soup soup = spiky_star(4, 1.5);
  const auto with_steps = [&](std::size_t most) {
    settings.number_of_iterations = most;
    Sphere sphere;
    return solve(soup, sphere, settings);
  };
  CHECK(with_steps(0).iterations == 0);
  CHECK(with_steps(1).iterations == 4); // the exponents 3, 4.5, 6.75 and 10
  const std::size_t unlimited = (std::numeric_limits<std::size_t>::max)();
  CHECK(with_steps(unlimited).termination == SP::Termination::CONVERGED);
  settings.accuracy = 1e-30; // below what rounding leaves
  CHECK(with_steps(unlimited).termination == SP::Termination::STALLED);
}

TEST_CASE("an accuracy that is asked for is reached while there are steps left", "[isometric]")
{
  const auto [soup, accuracy] = GENERATE(
    table<Soup, double>({{capsule(30, 12), 1e-5}, {capsule(100, 12), 1e-6}, {spiral(8, 6), 1e-7}, {tree(4), 1e-5}}));
  Settings settings = isometric(1);
  settings.accuracy = accuracy;
  settings.number_of_iterations = 5000;
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(result.error == Error_code::OK);
  CHECK(result.residual <= accuracy);
}

TEST_CASE("angles alone: limbs beyond doubles on coarse meshes are no reason for no map", "[isometric]")
{
  Settings settings = isometric(0);
  for(const Soup& soup : {capsule(1000, 3), spiral(20, 4)}) {
    Sphere sphere;
    CHECK(solve(soup, sphere, settings).error == Error_code::OK);
    CHECK(count_flipped_faces(soup, sphere) == 0);
  }
}

TEST_CASE("the progress of the isometric method never goes back and ends at 1", "[isometric]")
{
  double last = 0;
  Settings settings = isometric();
  settings.callback = [&](double fraction) {
    CHECK(fraction >= last);
    last = fraction;
    return true;
  };
  solve_or_throw(spiky_star(4, 1.5), settings);
  CHECK(last == 1);
}
