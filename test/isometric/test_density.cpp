// SPDX-License-Identifier: GPL-3.0-or-later
// With densities the isometric map gives every face the area that is wanted, as far as its exponent says, and is as
// bijective as without.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/parameterize.h>

#include <boost/property_map/function_property_map.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

using namespace test;

namespace {

Settings with_density(std::vector<double> of_vertices, std::vector<double> of_faces = {})
{
  Settings settings;
  settings.method = SP::Isometric();
  settings.accuracy = SP::Isometric::default_accuracy;
  settings.number_of_iterations = SP::Isometric::default_number_of_iterations;
  settings.vertex_density = std::move(of_vertices);
  settings.face_density = std::move(of_faces);
  return settings;
}

double area(const Point& a, const Point& b, const Point& c)
{
  return std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / 2;
}

/// The solid angle of a face, by the formula of A. Van Oosterom and J. Strackee.
double area_on_sphere(const Sphere& sphere, const std::vector<std::size_t>& f)
{
  const Vector a = sphere[f[0]] - CGAL::ORIGIN, b = sphere[f[1]] - CGAL::ORIGIN, c = sphere[f[2]] - CGAL::ORIGIN;
  return 2 * std::atan2(CGAL::cross_product(a, b) * c, 1 + a * b + b * c + c * a);
}

/// The root mean square of log(area / wanted area), every face with its wanted area.
double deviation(const Soup& soup, const std::vector<double>& of_faces, const Sphere& sphere)
{
  std::vector<double> wanted;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const auto& v = soup.faces[f];
    wanted.push_back(of_faces[f] * area(soup.points[v[0]], soup.points[v[1]], soup.points[v[2]]));
  }
  const double whole = std::accumulate(wanted.begin(), wanted.end(), 0.), sphere_area = 4 * std::acos(-1.);
  double squares = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    squares +=
      wanted[f] * std::pow(std::log(area_on_sphere(sphere, soup.faces[f]) / sphere_area * whole / wanted[f]), 2);
  return std::sqrt(squares / whole);
}

std::vector<double> of_faces(const Soup& soup, const std::vector<double>& of_vertices)
{
  std::vector<double> density;
  for(const auto& f : soup.faces)
    density.push_back((of_vertices[f[0]] + of_vertices[f[1]] + of_vertices[f[2]]) / 3);
  return density;
}

/// `high` where z is positive, else 1
std::vector<double> upper_faces(const Soup& soup, double high)
{
  std::vector<double> density;
  for(const auto& f : soup.faces)
    density.push_back(soup.points[f[0]].z() + soup.points[f[1]].z() + soup.points[f[2]].z() > 0 ? high : 1);
  return density;
}

/// From 1 at the bottom of a sphere to `high` at the top
std::vector<double> rising(const Soup& soup, double high)
{
  std::vector<double> density;
  for(const Point& p : soup.points)
    density.push_back(std::pow(high, (1 + p.z()) / 2));
  return density;
}

void check_map(const Soup& soup, const Settings& settings)
{
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(bool(result));
  CHECK(count_flipped_faces(soup, sphere) == 0);
  CHECK(degree(soup, sphere) == 1);
}

} // namespace

TEST_CASE("a part of four times the density gets four times its share of the sphere", "[density]")
{
  const Soup soup = icosphere(4);
  const Settings settings = with_density({}, upper_faces(soup, 4));
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  REQUIRE(bool(result));
  double above = 0, whole = 0;
  for(std::size_t f = 0; f < soup.faces.size(); ++f) {
    const double a = area_on_sphere(sphere, soup.faces[f]);
    whole += a;
    above += settings.face_density[f] == 4 ? a : 0;
  }
  CHECK(whole == Approx(4 * std::acos(-1.)));
  CHECK(above / (whole - above) == Approx(4).epsilon(0.1));
  CHECK(result.density_deviation < 0.25);
  CHECK(result.density_deviation == Approx(deviation(soup, settings.face_density, sphere)).epsilon(1e-6));
}

TEST_CASE("larger exponents bring areas nearer to what is wanted", "[density]")
{
  const Soup soup = spiky_star(4, 1.5);
  Settings settings = with_density(rising(soup, 10));
  double before = std::numeric_limits<double>::infinity();
  for(double exponent : {1., 3., 10., 30.}) {
    settings.method = SP::Isometric{exponent};
    Sphere sphere;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(result, exponent);
    REQUIRE(bool(result));
    CHECK(result.density_deviation < before);
    CHECK(result.density_deviation ==
          Approx(deviation(soup, of_faces(soup, settings.vertex_density), sphere)).epsilon(1e-6));
    before = result.density_deviation;
  }
  CHECK(before < 0.12);
}

TEST_CASE("no face of a small target covers much of the sphere", "[density]")
{
  const Soup soup = icosphere(GENERATE(3, 4));
  const int axis = GENERATE(0, 1, 2);
  const double rate = GENERATE(2., 3.);
  std::vector<double> density;
  for(const Point& p : soup.points)
    density.push_back(std::exp(rate * p[axis]));
  Sphere sphere;
  const Result result = solve(soup, sphere, with_density(density));
  CAPTURE(result, axis, rate);
  REQUIRE(bool(result));
  CHECK(result.density_deviation < 0.05);
  double largest = 0;
  for(const auto& f : soup.faces)
    largest = std::max(largest, area_on_sphere(sphere, f));
  CHECK(largest < 0.1);
}

TEST_CASE("a uniform density changes no bit", "[density]")
{
  const Soup soup = spiky_star(3, 1.5);
  Settings plain = with_density({});
  plain.method = SP::Isometric{SP::Isometric::area_exponent_of_densities};
  const Sphere sphere = solve_or_throw(soup, plain);
  const double value = GENERATE(1., 0.3, 1e-300, 1e300);
  CHECK(solve_or_throw(soup, with_density(std::vector<double>(soup.points.size(), value))) == sphere);
  CHECK(solve_or_throw(soup, with_density({}, std::vector<double>(soup.faces.size(), value))) == sphere);
}

TEST_CASE("only ratios of densities matter", "[density]")
{
  const Soup soup = bumpy_sphere(3);
  std::vector<double> density = rising(soup, 10);
  const Sphere sphere = solve_or_throw(soup, with_density(density));
  const double factor = std::ldexp(1., GENERATE(-900, 900));
  for(double& d : density)
    d *= factor;
  CHECK(solve_or_throw(soup, with_density(density)) == sphere);
}

TEST_CASE("maps of densities hardly depend on the numbering", "[density]")
{
  const Soup soup = bumpy_sphere(4);
  const std::vector<double> density = rising(soup, 10);
  Soup reversed;
  reversed.points.assign(soup.points.rbegin(), soup.points.rend());
  for(auto f : soup.faces) {
    for(std::size_t& v : f)
      v = soup.points.size() - 1 - v;
    reversed.faces.insert(reversed.faces.begin(), f);
  }
  Sphere sphere, again;
  const double before = solve(soup, sphere, with_density(density)).density_deviation;
  const Result result = solve(reversed, again, with_density({density.rbegin(), density.rend()}));
  CHECK(bool(result));
  CHECK(result.density_deviation == Approx(before).epsilon(0.1));
  std::reverse(again.begin(), again.end());
  CHECK(distance_up_to_rotation(sphere, again) < 0.1);
}

TEST_CASE("any density has a certified map", "[density]")
{
  const Soup soup = std::vector{spiky_star(3, 2), collinear_face(), tetrahedron()}[GENERATE(0u, 1u, 2u)];
  const double high = GENERATE(1e-12, 1e3, 1e300);
  std::vector<double> alternating(soup.faces.size(), 1);
  for(std::size_t f = 0; f < alternating.size(); f += 2)
    alternating[f] = high;
  check_map(soup, with_density({}, alternating));
  check_map(soup, with_density({}, upper_faces(soup, high)));
}

TEST_CASE("faces without area do no harm to maps of densities", "[density]")
{
  for(const Soup& soup : {one_point(2), many_coincident_points(3), ellipsoid(1, 1, 0, 2)})
    check_map(soup, with_density(rising(soup, 100)));
}

TEST_CASE("maps of densities do not depend on the policy", "[density][each_policy]")
{
  const Soup soup = spiky_star(4, 1.5);
  Settings settings = with_density(rising(soup, 10));
  settings.policy = CGAL::Sequential_tag();
  const Sphere sphere = solve_or_throw(soup, settings);
  settings.policy = default_policy();
  CHECK(solve_or_throw(soup, settings) == sphere);
}

TEST_CASE("landmarks stay where they are put with densities", "[density]")
{
  const Soup soup = icosphere(4);
  Settings settings = with_density(rising(soup, 10));
  settings.fixed = {{0, {1, 0, 0}}, {1, {0, 1, 0}}, {2, {0, 0, 1}}, {3, {0, -1, 0}}};
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(bool(result));
  for(const auto& [vertex, place] : settings.fixed)
    CHECK(sphere[vertex] == place);
}

TEST_CASE("with densities the automatic method is the isometric one", "[density]")
{
  const Soup soup = bumpy_sphere(3);
  Settings settings = with_density(rising(soup, 10));
  const Sphere sphere = solve_or_throw(soup, settings);
  settings.method = SP::Automatic();
  Sphere automatic;
  const Result result = solve(soup, automatic, settings);
  CHECK(automatic == sphere);
  CHECK(result.method == "isometric");
  CHECK(result.attempts.size() == 1);
  CHECK(result.fallback_reason == "springs do not follow densities");
  CHECK(result.density_deviation > 0);
}

TEST_CASE("the first density that is wrong is named", "[density]")
{
  const Soup soup = icosphere(2);
  const double wrong =
    GENERATE(0., -1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN());
  std::vector<double> of_vertices(soup.points.size(), 1), of_faces(soup.faces.size(), 1);
  of_vertices[7] = of_vertices[100] = of_faces[9] = of_faces[200] = wrong;
  Sphere sphere;
  const Result by_vertex = solve(soup, sphere, with_density(of_vertices));
  CHECK(by_vertex.error == Error_code::BAD_DENSITY);
  CHECK(by_vertex.detail.find("vertex 7 has the density") == 0);
  const Result by_face = solve(soup, sphere, with_density({}, of_faces));
  CHECK(by_face.error == Error_code::BAD_DENSITY);
  CHECK(by_face.detail.find("face 9 has the density") == 0);
}

TEST_CASE("a density that is nothing beside another one is refused", "[density]")
{
  const Soup soup = icosphere(2);
  const auto error_of = [&](double largest, double least) {
    std::vector<double> density(soup.points.size(), least);
    density[7] = largest;
    Sphere sphere;
    return solve(soup, sphere, with_density(density)).error;
  };
  CHECK(error_of(1e200, 1e-200) == Error_code::BAD_DENSITY);
  CHECK(error_of(1e300, 1e295) == Error_code::OK);
}

TEST_CASE("springs take no densities, and nothing takes those of vertices and of faces", "[density]")
{
  const Soup soup = icosphere(2);
  Sphere sphere;
  Settings settings = with_density(rising(soup, 10));
  settings.method = SP::Balanced();
  CHECK_THROWS_AS(solve(soup, sphere, settings), CGAL::Precondition_exception);
  settings.method = SP::Saddle_point();
  CHECK_THROWS_AS(solve(soup, sphere, settings), CGAL::Precondition_exception);
  CHECK_THROWS_AS(solve(soup, sphere, with_density(rising(soup, 10), upper_faces(soup, 2))),
                  CGAL::Precondition_exception);
}

TEST_CASE("soups have densities by number", "[density]")
{
  const Soup soup = bumpy_sphere(3);
  const std::vector<double> of_faces = upper_faces(soup, 3), of_vertices = rising(soup, 3);
  std::vector<Point> sphere;
  const auto map = [&](const auto& density) {
    const Result result =
      SP::parameterize_triangle_soup(CGAL::Sequential_tag(), soup.points, soup.faces, SP::Isometric(), sphere, density);
    CHECK(bool(result));
    return sphere;
  };
  CHECK(map(CGAL::parameters::face_density_map(of_faces.data())) == solve_or_throw(soup, with_density({}, of_faces)));
  CHECK(map(CGAL::parameters::vertex_density_map(of_vertices.data()).verbose(false)) ==
        solve_or_throw(soup, with_density(of_vertices)));
  const auto function = boost::make_function_property_map<std::size_t>([&](std::size_t v) { return of_vertices[v]; });
  CHECK(map(CGAL::parameters::vertex_density_map(function)) == solve_or_throw(soup, with_density(of_vertices)));
}

TEST_CASE("densities may be a function of the vertices", "[density]")
{
  const Soup soup = bumpy_sphere(2);
  const std::vector<double> of_vertices = rising(soup, 3);
  Mesh mesh = make_mesh(soup);
  const auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
  const auto density = boost::make_function_property_map<Mesh::Vertex_index>(
    [&](Mesh::Vertex_index v) { return of_vertices[static_cast<std::size_t>(v)]; });
  REQUIRE(SP::parameterize(mesh, SP::Isometric(), sphere, CGAL::parameters::vertex_density_map(density)));
  const Sphere expected = solve_or_throw(soup, with_density(of_vertices));
  CHECK(std::all_of(mesh.vertices().begin(), mesh.vertices().end(),
                    [&](Mesh::Vertex_index v) { return sphere[v] == expected[static_cast<std::size_t>(v)]; }));
}
