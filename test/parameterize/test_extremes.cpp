// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes at the ends of what there is, for every method and all weights: a certified map, or a clear error; never a
// crash, never a coordinate that is no number.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace test;

namespace {

typedef decltype(Settings::method) Method;

struct Named_method {
  const char* name;
  Method method;
  bool is_bijective_by_construction;
};

std::vector<Named_method> methods()
{
  SP::Saddle_point coloured;
  coloured.splitting = Splitting::GAUSS_SEIDEL;
  coloured.check_interval = 50;
  return {{"balanced", SP::Balanced(), false},
          {"balanced, exponent 3", SP::Balanced{3}, false},
          {"saddle point", coloured, false},
          {"isometric", SP::Isometric(), true},
          {"isometric, areas", SP::Isometric{20}, true},
          {"automatic", SP::Automatic(), true}};
}

/// All methods with all weights. The accuracy and the iterations are those of `Balanced`, but for those of few steps.
void check_all_methods(const Soup& soup, const std::vector<Named_method>& all = methods())
{
  const Mesh mesh = make_mesh(soup);
  for(const Named_method& m : all)
    for(const Weights weights : {Weights::BARYCENTRIC, Weights::CLAMPED, Weights::CONFORMAL}) {
      Settings settings;
      settings.method = m.method;
      settings.weights = weights;
      if(std::holds_alternative<SP::Isometric>(m.method)) {
        settings.accuracy = SP::Isometric::default_accuracy;
        settings.number_of_iterations = SP::Isometric::default_number_of_iterations;
      } else if(std::holds_alternative<SP::Saddle_point>(m.method)) {
        settings.accuracy = 1e-3;
        settings.number_of_iterations = 3;
      }
      Sphere sphere;
      const Result result = solve(mesh, sphere, settings);
      CAPTURE(m.name, int(weights), result);
      if(result.error == Error_code::DEGENERATE_FACE) { // no length for springs that need one: no map, and it says so
        CHECK((std::string(m.name) == "balanced, exponent 3" && !result.detail.empty()));
        continue;
      }
      CHECK(count_vertices_off_sphere(sphere) == 0); // NaN is off the sphere
      CHECK(result.flipped_faces == count_flipped_faces(soup, sphere));
      if(result)
        CHECK((result.flipped_faces == 0 && degree(soup, sphere) == 1));
      else {
        CHECK((result.error == Error_code::NOT_CONVERGED || result.error == Error_code::NOT_BIJECTIVE));
        CHECK(!result.detail.empty());
      }
      if(m.is_bijective_by_construction)
        CHECK(bool(result));
    }
}

Soup scaled(const Soup& soup, double x, double y, double z)
{
  return transformed(soup, [&](const Point& p) { return Point(x * p.x(), y * p.y(), z * p.z()); });
}

Soup moved(const Soup& soup, double by)
{
  return transformed(soup, [&](const Point& p) { return Point(p.x() + by, p.y() - by, p.z() + by / 3); });
}

/// A tetrahedron with the vertices a, b, c, d.
Soup tetrahedron(Point a, Point b, Point c, Point d)
{
  Soup soup = test::tetrahedron();
  soup.points = {a, b, c, d};
  return soup;
}

Soup box(double x, double y, double z) { return scaled(cube(), x, y, z); }

} // namespace

TEST_CASE("extremes: coordinates from 1e-300 to 1e300", "[extremes]")
{
  const double scale = GENERATE(1e-300, 1e-200, 1e-160, 1e160, 1e200, 1e300);
  CAPTURE(scale);
  check_all_methods(scaled(bumpy_sphere(1), scale, scale, scale));
}

TEST_CASE("extremes: a power of two as scale changes not a bit", "[extremes]")
{
  const Soup soup = bumpy_sphere(2);
  const double scale = GENERATE(std::ldexp(1, -900), std::ldexp(1, -3), std::ldexp(1, 900));
  CAPTURE(scale);
  for(const Named_method& m : methods()) {
    CAPTURE(m.name);
    Settings settings;
    settings.method = m.method;
    settings.number_of_iterations = 5;
    Sphere sphere, of_scaled;
    solve(soup, sphere, settings);
    solve(scaled(soup, scale, scale, scale), of_scaled, settings);
    CHECK(sphere == of_scaled);
  }
}

TEST_CASE("extremes: the largest and the smallest numbers there are", "[extremes]")
{
  typedef std::numeric_limits<double> Limits;
  const Soup soup = GENERATE(bumpy_sphere(1), cube());
  double largest = 0;
  for(const Point& p : soup.points)
    largest = std::max({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  SECTION("denormal numbers") { check_all_methods(scaled(soup, 1e-310, 1e-310, 1e-310)); }
  SECTION("a few units of the smallest number") { check_all_methods(scaled(soup, 3e-323, 3e-323, 3e-323)); }
  SECTION("an extent that overflows")
  {
    const double most = Limits::max() / largest;
    check_all_methods(
      transformed(soup, [&](const Point& p) { return Point(most * p.x(), most * p.y(), -most * p.z()); }));
  }
  SECTION("one coordinate of another size")
  {
    check_all_methods(scaled(soup, 1e300, 1, 1));
    check_all_methods(scaled(soup, 1, 1e-300, 1));
    check_all_methods(scaled(soup, 1e300, 1, 1e-300));
  }
}

TEST_CASE("extremes: far from the origin", "[extremes]")
{
  check_all_methods(moved(bumpy_sphere(2), 1e9));
  check_all_methods(moved(bumpy_sphere(2), 1e15)); // on the grid of doubles: many points coincide
  check_all_methods(moved(bumpy_sphere(2), 1e17)); // all of them do
}

TEST_CASE("extremes: points that coincide, edges and faces of no size", "[extremes]")
{
  check_all_methods(coincident_points());
  check_all_methods(collinear_face());
  check_all_methods(many_coincident_points(2));
  check_all_methods(one_point(2));
  check_all_methods(scaled(bumpy_sphere(2), 1, 1, 0)); // a pancake
  check_all_methods(scaled(bumpy_sphere(2), 1, 0, 0)); // a line
  check_all_methods(needles(1, 1e-9));
}

TEST_CASE("extremes: four vertices", "[extremes]")
{
  check_all_methods(test::tetrahedron());
  const Point o(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  check_all_methods(tetrahedron(o, x, y, z));
  check_all_methods(tetrahedron(o, x, y, Point(0, 0, 1e-12)));
  check_all_methods(tetrahedron(o, x, y, Point(0, 0, 1e12)));
  check_all_methods(tetrahedron(o, x, y, Point(0.25, 0.25, 0)));
  check_all_methods(tetrahedron(o, x, Point(2, 0, 0), Point(3, 0, 0)));
  check_all_methods(tetrahedron(o, o, x, y));
  check_all_methods(tetrahedron(o, o, o, o));
}

TEST_CASE("extremes: right angles everywhere", "[extremes]")
{
  check_all_methods(cube());
  check_all_methods(box(1, 1, 100));
  check_all_methods(box(1, 1e3, 1e6));
  check_all_methods(box(1, 1e-9, 1));
  check_all_methods(cross());
  check_all_methods(comb(3, 2));
  check_all_methods(tree(2));
}

TEST_CASE("extremes: weights in any unit are the same map", "[extremes]")
{
  const Mesh mesh = make_mesh(bumpy_sphere(3));
  const int exponent = GENERATE(-1070, -600, 600, 1000);
  CAPTURE(exponent);
  for(const Named_method& m : methods()) {
    CAPTURE(m.name);
    Settings settings;
    settings.method = m.method;
    settings.weights = Weights::BARYCENTRIC;
    settings.number_of_iterations = 5;
    Sphere sphere, of_scaled;
    const Result result = solve(mesh, sphere, settings);
    for(std::size_t e = 0; e < mesh.number_of_edges(); ++e)
      settings.weight_of_edge[e] = std::ldexp(1., exponent);
    const Result scaled = solve(mesh, of_scaled, settings);
    CHECK(sphere == of_scaled);
    CHECK(scaled.error == result.error);
    CHECK(scaled.residual == result.residual);
    if(exponent > -1000 && scaled.method != "isometric") // denormal numbers are rounded
      CHECK(scaled.energy == std::ldexp(result.energy, exponent));
  }
}

TEST_CASE("extremes: no face with three different vertices", "[extremes]")
{
  // two triangles, each with two sides glued to each other: cones over a loop, along which they meet
  Mesh mesh;
  const auto a = mesh.add_vertex(Point(1, 0, 0)), o = mesh.add_vertex(Point(0, 1, 0)),
             b = mesh.add_vertex(Point(0, 0, 1));
  const auto loop = mesh.add_edge();
  for(const auto& [side, apex] : {std::pair(loop, a), std::pair(mesh.opposite(loop), b)}) {
    const auto seam = mesh.add_edge(), back = mesh.opposite(seam);
    const auto face = mesh.add_face();
    mesh.set_target(side, o);
    mesh.set_target(seam, apex);
    mesh.set_target(back, o);
    for(const auto& [h, next] : {std::pair(side, seam), std::pair(seam, back), std::pair(back, side)}) {
      mesh.set_next(h, next);
      mesh.set_face(h, face);
    }
    mesh.set_halfedge(face, side);
    mesh.set_halfedge(apex, seam);
  }
  mesh.set_halfedge(o, loop);
  REQUIRE(mesh.is_valid());
  for(const Named_method& m : methods()) {
    CAPTURE(m.name);
    Settings settings;
    settings.method = m.method;
    Sphere sphere;
    const Result result = solve(mesh, sphere, settings);
    CHECK_FALSE(bool(result));
    CHECK(!result.detail.empty());
  }
}

TEST_CASE("extremes: vertices of all degrees", "[extremes]")
{
  const int degree = GENERATE(3, 4, 10, 100, 1000);
  CAPTURE(degree);
  check_all_methods(bipyramid(degree));
}

TEST_CASE("extremes: vertices of degree 50,000", "[extremes]")
{
  check_all_methods(bipyramid(50000), {{"balanced", SP::Balanced(), false}, {"isometric", SP::Isometric(), true}});
}
