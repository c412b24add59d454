// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that can be wrong has its own code and says what and where. Not here: INCONSISTENT_ORIENTATION, which no
// FaceGraph can express (test_tool.cpp).

#include "helpers/check.h"
#include "helpers/meshes.h"

#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <catch2/catch.hpp>

#include <limits>
#include <set>

using namespace test;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

template <class Mesh_or_soup>
Result solve_any(const Mesh_or_soup& input, const Settings& settings = {})
{
  Sphere sphere;
  Result result = solve(input, sphere, settings);
  INFO(result);
  CHECK_FALSE(bool(result));
  CHECK(result.detail.find('\n') == std::string::npos);
  return result;
}

} // namespace

TEST_CASE("every code has a sentence of its own", "[errors]")
{
  std::set<std::string> sentences;
  for(int code = 0; code <= int(Error_code::NOT_BIJECTIVE); ++code)
    sentences.insert(SP::get_error_message(Error_code(code)));
  CHECK(sentences.size() == std::size_t(Error_code::NOT_BIJECTIVE) + 1);
  CHECK(sentences.count("unknown error") == 0);
}

TEST_CASE("a mesh without faces is refused", "[errors]")
{
  CHECK(solve_any(Soup()).error == Error_code::EMPTY_MESH);
  Soup points_only;
  points_only.points = icosphere(0).points;
  CHECK(solve_any(points_only).error == Error_code::EMPTY_MESH);
}

TEST_CASE("polygons are refused", "[errors]")
{
  Mesh cube_of_quads = make_mesh(quad_cube());
  // conformal weights of a quadrangle have no meaning, so that none are asked for
  Settings settings;
  settings.weights = Weights::BARYCENTRIC;
  CHECK(solve_any(cube_of_quads, settings).error == Error_code::NOT_TRIANGULAR);
}

TEST_CASE("an isolated vertex is refused and named", "[errors]")
{
  const Result result = solve_any(isolated_vertex());
  CHECK(result.error == Error_code::ISOLATED_VERTEX);
  CHECK(mentions(result.detail, 42));
}

TEST_CASE("a boundary is refused, with the number of its edges", "[errors]")
{
  const Result result = solve_any(open_sphere(2));
  CHECK(result.error == Error_code::BOUNDARY);
  CHECK(mentions(result.detail, 5));
}

TEST_CASE("several components are refused and counted", "[errors]")
{
  const Result result = solve_any(two_spheres());
  CHECK(result.error == Error_code::SEVERAL_COMPONENTS);
  CHECK(mentions(result.detail, 2));
}

TEST_CASE("handles are refused, with the genus", "[errors]")
{
  const Result one = solve_any(torus(12, 8));
  CHECK(one.error == Error_code::WRONG_GENUS);
  CHECK(mentions(one.detail, 1));
  const Result two = solve_any(double_torus());
  CHECK(two.error == Error_code::WRONG_GENUS);
  CHECK(mentions(two.detail, 2));
}

TEST_CASE("non-manifold vertices are refused", "[errors]")
{
  CHECK(solve_any(hourglass()).error == Error_code::NON_MANIFOLD);
  CHECK(solve_any(pinched_sphere()).error == Error_code::NON_MANIFOLD);
}

TEST_CASE("coordinates that are not finite are refused, with the vertex", "[errors]")
{
  const Weights weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED);
  Settings settings;
  settings.weights = weights;
  const Result with_nan = solve_any(nan_coordinate(), settings);
  CHECK(with_nan.error == Error_code::NON_FINITE_COORDINATE);
  CHECK(mentions(with_nan.detail, 5));
  const Result with_infinity = solve_any(infinite_coordinate(), settings);
  CHECK(with_infinity.error == Error_code::NON_FINITE_COORDINATE);
  CHECK(mentions(with_infinity.detail, 7));
}

TEST_CASE("zero-area faces are refused only where the weights need an area", "[errors]")
{
  Settings settings;
  settings.weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED); // whose angles are clamped
  solve_or_throw(collinear_face(), settings);
  solve_or_throw(coincident_points(), settings);

  settings.weights = Weights::MEAN_VALUE;
  CHECK(solve_any(collinear_face(), settings).error == Error_code::DEGENERATE_FACE);
  CHECK(solve_any(coincident_points(), settings).error == Error_code::DEGENERATE_FACE);

  Soup flat = collinear_face(); // a normal that is not 0, and an angle of 180 degrees to rounding
  auto& middle = flat.points[flat.faces[0][0]];
  middle = middle + 1e-12 * (CGAL::ORIGIN - middle);
  CHECK(solve_any(flat, settings).error == Error_code::DEGENERATE_FACE);
}

TEST_CASE("meshes that have no straight embedding are refused by every method, which is not blamed", "[errors]")
{
  Soup pillow;
  pillow.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  pillow.faces = {{0, 1, 2}, {0, 2, 1}};
  Mesh twofold = make_mesh(tetrahedron());
  CGAL::Euler::flip_edge(*halfedges(twofold).begin(), twofold); // two edges between the other two vertices
  Settings settings;
  settings.weights = Weights::BARYCENTRIC;
  const auto check = [&](const auto& method) {
    settings.method = method;
    Sphere sphere;
    for(const Mesh& mesh : {make_mesh(pillow), twofold}) {
      const Result result = solve(mesh, sphere, settings);
      CHECK(result.error == Error_code::NOT_BIJECTIVE);
      CHECK(result.detail.find("no map with geodesic edges") != std::string::npos);
    }
  };
  check(SP::Automatic());
  check(SP::Balanced());
  check(SP::Isometric());
  check(SP::Saddle_point());
}

TEST_CASE("a weight that is not positive and finite is refused, with its edge", "[errors]")
{
  const double weight = GENERATE(0., -1., -1e-300, not_a_number, infinity, -infinity);
  CAPTURE(weight);
  const Mesh mesh = make_mesh(icosphere(1));
  const std::size_t edge = GENERATE(0u, 17u, 64u, 110u);
  Settings settings;
  settings.weights = Weights::BARYCENTRIC;
  settings.weight_of_edge[edge] = weight;
  const Result result = solve_any(mesh, settings);
  CHECK(result.error == Error_code::BAD_WEIGHT);
  CHECK(mentions(result.detail, mesh.vertex(Mesh::Edge_index(edge), 0)));
  CHECK(mentions(result.detail, mesh.vertex(Mesh::Edge_index(edge), 1)));
}

TEST_CASE("fixed vertices that determine no map are refused", "[errors]")
{
  const Soup soup = icosphere(1);
  std::map<std::size_t, Point> fixed;
  SECTION("one") { fixed = {{3, Point(1, 0, 0)}}; }
  SECTION("two") { fixed = {{3, Point(1, 0, 0)}, {4, Point(0, 1, 0)}}; }
  SECTION("two at the same place") { fixed = {{3, Point(1, 0, 0)}, {4, Point(0, 1, 0)}, {5, Point(1, 0, 0)}}; }
  SECTION("two in the same direction") { fixed = {{3, Point(1, 0, 0)}, {4, Point(0, 1, 0)}, {5, Point(2, 0, 0)}}; }
  SECTION("no direction") { fixed = {{3, Point(1, 0, 0)}, {4, Point(0, 1, 0)}, {5, Point(0, 0, 0)}}; }
  SECTION("not a number") { fixed = {{3, Point(1, 0, 0)}, {4, Point(0, 1, 0)}, {5, Point(0, not_a_number, 1)}}; }
  SECTION("infinite") { fixed = {{3, Point(1, 0, 0)}, {4, Point(0, 1, 0)}, {5, Point(0, 0, infinity)}}; }
  Settings settings;
  settings.fixed = fixed;
  CHECK(solve_any(soup, settings).error == Error_code::BAD_CONSTRAINTS);
  settings.method = SP::Saddle_point();
  CHECK(solve_any(soup, settings).error == Error_code::BAD_CONSTRAINTS);
}

TEST_CASE("too few iterations are reported, and the map so far is handed over", "[errors][each_policy]")
{
  const Soup soup = dumbbell(3);
  Settings settings;
  settings.number_of_iterations = 2;
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CHECK(result.error == Error_code::NOT_CONVERGED);
  CHECK(result.iterations == 2);
  check_certificate(result, soup, sphere, settings);
}

TEST_CASE("the callback and the time limit interrupt, and the map so far is handed over if there is one", "[errors]")
{
  const Soup soup = dumbbell(3);
  Settings settings;
  SP::Saddle_point published;
  published.check_interval = 10;
  settings.method = GENERATE_COPY(decltype(settings.method)(SP::Balanced()), published);
  int calls = 0;
  bool has_map = false;
  SECTION("callback at once")
  {
    settings.callback = [&](double) { return ++calls < 1; };
  }
  SECTION("callback later")
  {
    settings.callback = [](double fraction) { return !(fraction > 0); };
    has_map = true;
  }
  SECTION("time limit") { settings.maximum_running_time = 0; }
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CHECK(result.error == Error_code::INTERRUPTED);
  CHECK(calls <= 1);
  if(has_map)
    check_certificate(result, soup, sphere, settings);
  else {
    CHECK(result.detail.find("before there was a map") != std::string::npos);
    CHECK(count_vertices_off_sphere(sphere) == soup.points.size()); // nothing was written
  }
}

TEST_CASE("an error that a callback throws is passed on, also one of this package", "[errors]")
{
  Mesh mesh = make_mesh(icosphere(2));
  const SP::Spherical_locator<Mesh> locator(mesh, mesh.points());
  const auto careless = CGAL::parameters::callback([&locator](double) {
    locator.locate(Point(0, 0, 0));
    return true;
  });
  auto sphere_map = mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
  CHECK_THROWS_AS(SP::parameterize(mesh, SP::Automatic(), sphere_map, careless), SP::Error);
}

TEST_CASE("the callback sees the progress, from 0 to 1", "[errors]")
{
  const Soup soup = dumbbell(3);
  Settings settings;
  std::vector<double> fractions;
  settings.callback = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  solve_or_throw(soup, settings);
  REQUIRE(fractions.size() > 3);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.front() >= 0);
  CHECK(fractions.back() <= 1);
}

TEST_CASE("a tube too long for doubles is reported with its flips and its smallest area", "[errors]")
{
  const Soup soup = capsule(20, 12);
  Settings settings;
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  INFO(result);
  CHECK(result.error == Error_code::NOT_BIJECTIVE);
  CHECK(result.flipped_faces > 0);
  CHECK(mentions(result.detail, result.flipped_faces));
  CHECK(result.detail.find("; use the automatic or the isometric method, or ") != std::string::npos);
  CHECK(result.smallest_area < 1e-30);
  check_certificate(result, soup, sphere, settings);
}
