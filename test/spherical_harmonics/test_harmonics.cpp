// SPDX-License-Identifier: GPL-3.0-or-later
// spherical_harmonics.h and harmonic_files.h

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/harmonic_alignment.h>
#include <CGAL/Spherical_parameterization/harmonic_files.h>
#include <CGAL/Spherical_parameterization/harmonic_grids.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/Spherical_parameterization/spherical_harmonics.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <vector>

using namespace test;

namespace {

using Vertex = Mesh::Vertex_index;
using Coefficients = SP::Harmonic_coefficients;
using Grid = SP::Latitude_longitude_grid;
using Direction = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846;
const CGAL::Sequential_tag one_core;

/// By the standard library, whose functions have the Condon-Shortley phase.
double harmonic(int l, int m, const Direction& x)
{
  const double theta = std::atan2(std::hypot(x[0], x[1]), x[2]), phi = std::atan2(x[1], x[0]);
  const int k = std::abs(m);
  const double y = (k % 2 == 0 ? 1 : -1) * std::sph_legendre(unsigned(l), unsigned(k), theta);
  return m == 0 ? y : std::sqrt(2.) * y * (m > 0 ? std::cos(k * phi) : std::sin(k * phi));
}

/// Coefficients that fall with the degree, as those of shapes do.
Coefficients random_coefficients(int degree, int fields, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Coefficients c(degree, fields);
  for(int field = 0; field < fields; ++field)
    for(int l = 0; l <= degree; ++l)
      for(int m = -l; m <= l; ++m)
        c(l, m, field) = normal(random) / (1 + l);
  return c;
}

double difference(const Coefficients& a, const Coefficients& b)
{
  REQUIRE(a.values().size() == b.values().size());
  double largest = 0;
  for(std::size_t i = 0; i < a.values().size(); ++i)
    largest = (std::max)(largest, std::abs(a.values()[i] - b.values()[i]));
  return largest;
}

SP::Rotation some_rotation(unsigned seed)
{
  const auto rows = random_rotation(seed);
  SP::Rotation r;
  for(std::size_t i = 0; i < 3; ++i)
    r[i] = {rows[i].x(), rows[i].y(), rows[i].z()};
  return r;
}

Direction apply_rotation(const SP::Rotation& r, const Direction& x)
{
  Direction y = {};
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      y[i] += r[i][j] * x[j];
  return y;
}

double degrees_between(const SP::Rotation& a, const SP::Rotation& b)
{
  double square = 0;
  for(std::size_t i = 0; i < 3; ++i)
    for(std::size_t j = 0; j < 3; ++j)
      square += (a[i][j] - b[i][j]) * (a[i][j] - b[i][j]);
  return 2 * std::asin((std::min)(1., std::sqrt(square / 8))) * 180 / pi;
}

/// An icosphere whose vertices have other places: the map is the identity.
struct Sphere_with_points {
  Mesh mesh;
  std::map<Vertex, Point> points;

  template <class F>
  Sphere_with_points(int level, F f) : mesh(make_mesh(icosphere(level)))
  {
    for(Vertex v : vertices(mesh))
      points[v] = f(mesh.point(v));
  }
  Readable_map<Vertex, Point> map() const
  {
    return {[this](Vertex v) { return points.at(v); }};
  }
};

SP::Least_squares tight()
{
  SP::Least_squares method;
  method.accuracy = 1e-13;
  return method;
}

} // namespace

TEST_CASE("values of single harmonics are those of the standard library", "[harmonics]")
{
  const std::vector<Direction> directions = {{1, 2, 3},  {-.3, .1, -2}, {0, 0, 1},
                                             {0, 0, -4}, {-1, 0, 0},    {1e-3, 2e-3, -1}};
  for(int l : {0, 1, 2, 3, 7, 20, 64})
    for(int m : {-l, -(l + 1) / 2, 0, l / 2, l}) {
      Coefficients c(l);
      c(l, m) = 1;
      const std::vector<double> values = SP::harmonic_values(one_core, c, directions);
      for(std::size_t i = 0; i < directions.size(); ++i)
        CHECK(values[i] == Approx(harmonic(l, m, directions[i])).margin(1e-11));
    }
}

TEST_CASE("a grid finds every single harmonic up to degree 64", "[harmonics]")
{
  constexpr int degree = 64;
  const auto grid = Grid::gauss_legendre(degree);
  double error = 0;
  for(int l = 0; l <= degree; ++l) {
    const int m = l % 3 == 0 ? -l : l % 3 == 1 ? l / 2 : l;
    std::vector<double> values;
    for(int row = 0; row < grid.rows(); ++row)
      for(int column = 0; column < grid.columns(); ++column)
        values.push_back(harmonic(l, m, grid.direction(row, column)));
    Coefficients expected(degree);
    expected(l, m) = 1;
    error = (std::max)(error, difference(SP::harmonic_grid_analysis(one_core, grid, values, degree), expected));
  }
  CHECK(error < 1e-11);
}

TEST_CASE("grids give coefficients back, of high degrees, too", "[harmonics]")
{
  for(int degree : {0, 1, 10, 700}) {
    const Coefficients c = random_coefficients(degree, degree > 100 ? 1 : 3, 1);
    const auto grid = Grid::gauss_legendre(degree);
    CHECK(difference(SP::harmonic_grid_analysis(one_core, grid, SP::harmonic_grid_values(one_core, c, grid), degree),
                     c) < 1e-11);
  }
  const Coefficients c = random_coefficients(20, 2, 2);
  const auto grid = Grid::equidistant(41, 43);
  CHECK(difference(SP::harmonic_grid_analysis(one_core, grid, SP::harmonic_grid_values(one_core, c, grid), 20), c) <
        1e-12);
  // few columns: a sample of the function is still that
  const auto coarse = Grid::equidistant(5, 3);
  const std::vector<double> values = SP::harmonic_grid_values(one_core, c, coarse);
  const std::vector<double> there = SP::harmonic_values(one_core, c, std::vector<Direction>{coarse.direction(3, 2)});
  CHECK(values[3 * 3 + 2] == Approx(there[0]).margin(1e-11));
  CHECK(values[15 + 3 * 3 + 2] == Approx(there[1]).margin(1e-11));
}

TEST_CASE("the power is the integral of the squares", "[harmonics]")
{
  const Coefficients c = random_coefficients(24, 3, 3);
  const auto grid = Grid::gauss_legendre(24);
  const std::vector<double> values = SP::harmonic_grid_values(one_core, c, grid);
  double integral = 0, power = 0, area = 0;
  for(std::size_t i = 0; i < values.size(); ++i)
    integral += grid.weight(int(i) / grid.columns() % grid.rows()) * values[i] * values[i];
  for(int row = 0; row < grid.rows(); ++row)
    area += grid.weight(row) * grid.columns();
  for(double p : SP::power_spectrum(c))
    power += p;
  CHECK(power == Approx(integral).epsilon(1e-12));
  CHECK(area == Approx(4 * pi).epsilon(1e-13));
}

TEST_CASE("least squares find spheres, moved spheres and ellipsoids", "[harmonics]")
{
  const std::array<double, 3> radius = {GENERATE(1., 3.), 1, GENERATE(1., .5)}, centre = {GENERATE(0., 20.), -1, 2};
  const Sphere_with_points shape(4, [&](const Point& p) {
    return Point(centre[0] + radius[0] * p.x(), centre[1] + radius[1] * p.y(), centre[2] + radius[2] * p.z());
  });
  const auto weights =
    GENERATE(SP::Vertex_weights::SPHERE_AREA, SP::Vertex_weights::SURFACE_AREA, SP::Vertex_weights::EQUAL);
  SP::Least_squares method = tight();
  method.weights = weights;
  const SP::Harmonic_analysis found = SP::harmonic_analysis(shape.mesh, shape.mesh.points(), shape.map(), 8, method,
                                                            CGAL::parameters::vertex_point_map(shape.map()));
  CHECK(found.has_converged);
  Coefficients expected(8, 3);
  const std::array<int, 3> m = {1, -1, 0};
  for(int k = 0; k < 3; ++k) {
    expected(0, 0, k) = centre[std::size_t(k)] * std::sqrt(4 * pi);
    expected(1, m[std::size_t(k)], k) = radius[std::size_t(k)] * std::sqrt(4 * pi / 3);
  }
  CHECK(difference(found.coefficients, expected) < 1e-10);
}

TEST_CASE("directions have any length but 0", "[harmonics]")
{
  const Coefficients c = random_coefficients(6, 1, 8);
  const auto values = [&c](double length) {
    return SP::harmonic_values(c, std::vector<Direction>{{length, -2 * length, 0.5 * length}}).at(0);
  };
  for(double length : {1e-300, 1e-161, 1e155, 1e300})
    CHECK(values(length) == Approx(values(1)).epsilon(1e-12));
  CHECK_THROWS_AS(values(0), SP::Error);

  const Mesh mesh = make_mesh(icosphere(2));
  std::vector<Point> longer;
  for(const Point& p : mesh.points())
    longer.push_back(CGAL::ORIGIN + (1.5 + p.x()) * (p - CGAL::ORIGIN));
  const auto integrals = [&mesh](const auto& sphere) {
    return SP::harmonic_analysis(mesh, sphere, mesh.points(), 3, SP::Integration()).coefficients;
  };
  const Readable_map<Vertex, Point> at_length{[&longer](Vertex v) { return longer[v.idx()]; }};
  CHECK(difference(integrals(at_length), integrals(mesh.points())) < 1e-12);
}

TEST_CASE("far from the origin harmonics keep their digits", "[harmonics]")
{
  const Coefficients c = random_coefficients(6, 1, 7);
  const auto bump = [&c](const Point& p) {
    double sum = 0;
    for(int l = 0; l <= 6; ++l)
      for(int m = -l; m <= l; ++m)
        sum += c(l, m) * harmonic(l, m, {p.x(), p.y(), p.z()});
    return sum;
  };
  const auto check = [&](const auto& method) {
    const auto analysis = [&](double shift) {
      const auto cut = [](double x) { return std::ldexp(std::nearbyint(std::ldexp(x, 20)), -20); }; // rounds nothing
      const Sphere_with_points shape(
        3, [&](const Point& p) { return Point(cut(bump(p)) + shift, cut(p.y()) - shift, p.z()); });
      Coefficients found = SP::harmonic_analysis(shape.mesh, shape.mesh.points(), shape.map(), 8, method,
                                                 CGAL::parameters::vertex_point_map(shape.map()))
                             .coefficients;
      CHECK(found(0, 0, 0) / std::sqrt(4 * pi) == Approx(shift).margin(2));
      for(int k = 0; k < 3; ++k)
        found(0, 0, k) = 0;
      return found;
    };
    CHECK(difference(analysis(0), analysis(1 << 30)) < 1e-12);
  };
  check(SP::Least_squares());
  check(SP::Integration());
}

TEST_CASE("least squares give back what was synthesized at vertices, and synthesis what was analyzed", "[harmonics]")
{
  const Mesh mesh = make_mesh(icosphere(5));
  const Coefficients c = random_coefficients(40, 3, 4);
  std::map<Vertex, Point> points;
  SP::harmonic_synthesis(c, mesh, mesh.points(), Writable_map<Vertex, Point>{&points});
  const auto readable = Read_write_map<Vertex, Point>{&points};
  const SP::Harmonic_analysis found = SP::harmonic_analysis(mesh, mesh.points(), readable, 40, tight());
  CHECK(found.has_converged);
  CHECK(difference(found.coefficients, c) < 1e-10);
  std::map<Vertex, Point> again;
  SP::harmonic_synthesis(found.coefficients, mesh, mesh.points(), Writable_map<Vertex, Point>{&again});
  const SP::Reconstruction_error error =
    SP::reconstruction_error(mesh, readable, Read_write_map<Vertex, Point>{&again});
  CHECK(error.root_mean_square < 1e-10);
  CHECK(error.largest < 1e-9);
  for(const double scale : {0x1p-900, 0x1p900}) { // the same, where squares would vanish or overflow
    const auto scaled = [scale](const std::map<Vertex, Point>& all) {
      return Readable_map<Vertex, Point>{[&all, scale](Vertex v) {
        const Point p = all.at(v);
        return Point(scale * p.x(), scale * p.y(), scale * p.z());
      }};
    };
    const SP::Reconstruction_error same = SP::reconstruction_error(mesh, scaled(points), scaled(again));
    CHECK(same.root_mean_square == scale * error.root_mean_square);
    CHECK(same.relative == error.relative);
    CHECK(same.largest == scale * error.largest);
  }
  // one function of numbers is the same as one of three
  const auto x = Readable_map<Vertex, double>{[&](Vertex v) { return points.at(v).x(); }};
  const SP::Harmonic_analysis of_x = SP::harmonic_analysis(mesh, mesh.points(), x, 40, tight());
  REQUIRE(of_x.coefficients.number_of_fields() == 1);
  for(int i = 0; i < c.size(); ++i)
    CHECK(std::abs(of_x.coefficients.values()[std::size_t(i)] - c.values()[std::size_t(i)]) < 1e-10);
  // too few iterations are said to be
  SP::Least_squares hasty;
  hasty.iterations = 2;
  CHECK_FALSE(SP::harmonic_analysis(mesh, mesh.points(), x, 40, hasty).has_converged);
}

TEST_CASE("icospheres find single harmonics of every degree up to 64", "[harmonics]")
{
  double error = 0;
  for(int l = 0; l <= 64; ++l) {
    Coefficients c(l, 3); // of the orders -l and l, and one between
    c(l, -l, 0) = 1;
    c(l, l / 2, 1) = 1;
    c(l, l, 2) = 1;
    const Mesh mesh = make_mesh(icosphere(l < 20 ? 3 : l < 40 ? 4 : 5));
    std::map<Vertex, Point> points;
    SP::harmonic_synthesis(c, mesh, mesh.points(), Writable_map<Vertex, Point>{&points});
    const SP::Harmonic_analysis found =
      SP::harmonic_analysis(mesh, mesh.points(), Read_write_map<Vertex, Point>{&points}, l, tight());
    CHECK(found.has_converged);
    error = (std::max)(error, difference(found.coefficients, c));
  }
  CHECK(error < 1e-10);
}

TEST_CASE("integrals of what is not linear on faces have an error of second order in the length of edges",
          "[harmonics]")
{
  Coefficients ellipsoid(4, 3);
  ellipsoid(1, 1, 0) = 3 * std::sqrt(4 * pi / 3);
  ellipsoid(1, -1, 1) = 2 * std::sqrt(4 * pi / 3);
  ellipsoid(1, 0, 2) = std::sqrt(4 * pi / 3);
  ellipsoid(0, 0, 2) = 5 * std::sqrt(4 * pi);
  double before = 0;
  for(int level = 2; level <= 5; ++level) {
    const Sphere_with_points shape(level, [](const Point& p) { return Point(3 * p.x(), 2 * p.y(), 5 + p.z()); });
    const double error =
      difference(SP::harmonic_analysis(shape.mesh, shape.mesh.points(), shape.map(), 4, SP::Integration()).coefficients,
                 ellipsoid);
    if(level > 2)
      CHECK(before / error == Approx(4).epsilon(0.1));
    before = error;
  }
  CHECK(before < 2e-3); // of 6
}

TEST_CASE("integrals of no error are those of rounding errors", "[harmonics]")
{
  const Mesh mesh = make_mesh(icosphere(1));
  const auto coefficients = [&](double accuracy) {
    return SP::harmonic_analysis(mesh, mesh.points(), mesh.points(), 1, SP::Integration{accuracy}).coefficients;
  };
  CHECK(difference(coefficients(1e-60), coefficients(1e-13)) < 1e-12); // which took hours
}

TEST_CASE("least squares are the best approximation at the vertices", "[harmonics]")
{
  const Sphere_with_points shape(4, [](const Point& p) { // not band-limited
    const double r = 1 + .3 * std::abs(p.x()) + .2 * std::abs(p.y() - p.z());
    return Point(r * p.x(), r * p.y(), r * p.z());
  });
  SP::Least_squares method = tight();
  method.weights = SP::Vertex_weights::EQUAL;
  const auto error = [&](const Coefficients& c) {
    std::map<Vertex, Point> out;
    SP::harmonic_synthesis(c, shape.mesh, shape.mesh.points(), Writable_map<Vertex, Point>{&out});
    return SP::reconstruction_error(shape.mesh, shape.map(), Read_write_map<Vertex, Point>{&out}).root_mean_square;
  };
  double before = 1;
  for(int degree : {2, 4, 8, 16}) {
    const Coefficients best =
      SP::harmonic_analysis(shape.mesh, shape.mesh.points(), shape.map(), degree, method).coefficients;
    const double least = error(best);
    CHECK(least < before);
    before = least;
    for(unsigned seed = 0; seed < 5; ++seed) {
      Coefficients other = best;
      const Coefficients change = random_coefficients(degree, 3, seed);
      for(std::size_t i = 0; i < other.values().size(); ++i)
        other.values()[i] += 1e-3 * change.values()[i];
      CHECK(error(other) > least);
    }
  }
}

TEST_CASE("integrals are exact for what is linear on faces", "[harmonics]")
{
  // A constant, on faces as large as they come: the tetrahedron's and the octahedron's
  const auto one = Readable_map<Vertex, double>{[](Vertex) { return 1.; }};
  for(const Soup& soup : {tetrahedron(), flat_octahedron(0)}) {
    const Mesh mesh = make_mesh(soup);
    const auto unit = Readable_map<Vertex, Point>{[&](Vertex v) {
      const Point p = mesh.point(v);
      const double length = std::sqrt((p - CGAL::ORIGIN).squared_length());
      return Point(p.x() / length, p.y() / length, p.z() / length);
    }};
    Coefficients expected(12);
    expected(0, 0) = std::sqrt(4 * pi);
    CHECK(difference(SP::harmonic_analysis(mesh, unit, one, 12, SP::Integration()).coefficients, expected) < 1e-10);
  }
  // Another field, by interpolation on a fine grid, whose error is that of sampling edges
  const Sphere_with_points shape(1, [](const Point& p) { return Point(p.x() * p.y(), std::abs(p.z()), p.x() + 1); });
  const Coefficients c =
    SP::harmonic_analysis(shape.mesh, shape.mesh.points(), shape.map(), 6, SP::Integration()).coefficients;
  const SP::Spherical_locator<Mesh> locator(shape.mesh, shape.mesh.points());
  const auto grid = Grid::gauss_legendre(150);
  std::vector<double> values(3 * std::size_t(grid.rows()) * std::size_t(grid.columns()));
  for(int row = 0; row < grid.rows(); ++row)
    for(int column = 0; column < grid.columns(); ++column) {
      const Point p = SP::interpolate(shape.mesh, locator.locate(grid.direction(row, column)), shape.map());
      for(int k = 0; k < 3; ++k) {
        const int place = (k * grid.rows() + row) * grid.columns() + column;
        values[std::size_t(place)] = p[k];
      }
    }
  CHECK(difference(SP::harmonic_grid_analysis(one_core, grid, values, 6), c) < 1e-4);
  // The accuracy is what was asked for
  SP::Integration rough;
  rough.accuracy = 1e-5;
  const double error =
    difference(SP::harmonic_analysis(shape.mesh, shape.mesh.points(), shape.map(), 6, rough).coefficients, c);
  CHECK(error < 1e-5);
  CHECK(error > 0);
}

TEST_CASE("turning functions turns coefficients by Wigner's matrices", "[harmonics]")
{
  const int degree = GENERATE(1, 2, 17, 64);
  const Coefficients c = random_coefficients(degree, 3, 5);
  const std::vector<double> power = SP::power_spectrum(c);
  std::vector<SP::Rotation> rotations = {
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {{{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}, {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}};
  for(unsigned seed = 0; seed < 3; ++seed)
    rotations.push_back(some_rotation(seed));
  const std::vector<Direction> directions = {{1, 2, 3}, {-1, 1, .2}, {0, 0, 1}, {.1, -.7, -2}};
  for(const SP::Rotation& r : rotations) {
    const Coefficients turned = SP::rotated(c, r);
    std::vector<Direction> there;
    for(const Direction& x : directions)
      there.push_back(apply_rotation(r, x));
    const std::vector<double> before = SP::harmonic_values(one_core, c, directions);
    const std::vector<double> after = SP::harmonic_values(one_core, turned, there);
    for(std::size_t i = 0; i < before.size(); ++i)
      CHECK(after[i] == Approx(before[i]).margin(1e-11));
    const std::vector<double> turned_power = SP::power_spectrum(turned);
    for(std::size_t l = 0; l < power.size(); ++l)
      CHECK(turned_power[l] == Approx(power[l]).epsilon(1e-12));
  }
}

TEST_CASE("analysis of a turned map gives turned coefficients", "[harmonics]")
{
  const Mesh mesh = make_mesh(icosphere(4));
  const auto c = random_coefficients(20, 1, 6);
  std::map<Vertex, double> value;
  SP::harmonic_synthesis(c, mesh, mesh.points(), Writable_map<Vertex, double>{&value});
  const SP::Rotation r = some_rotation(9);
  const auto turned_sphere = Readable_map<Vertex, Point>{[&](Vertex v) {
    const Point p = mesh.point(v);
    const Direction q = apply_rotation(r, {p.x(), p.y(), p.z()});
    return Point(q[0], q[1], q[2]);
  }};
  const auto found = SP::harmonic_analysis(mesh, turned_sphere, Read_write_map<Vertex, double>{&value}, 20, tight());
  CHECK(difference(found.coefficients, SP::rotated(c, r)) < 1e-9);
}

TEST_CASE("the best of all rotations is found, with noise", "[harmonics]")
{
  const int degree = GENERATE(1, 4, 31);
  for(unsigned seed = 0; seed < 4; ++seed) {
    const Coefficients g = random_coefficients(degree, 3, 10 + seed);
    const SP::Rotation r = some_rotation(20 + seed);
    Coefficients f = SP::rotated(g, r);
    CHECK(degrees_between(SP::best_rotation(one_core, f, g), r) < 1e-6);
    const Coefficients noise = random_coefficients(degree, 3, 30 + seed);
    for(std::size_t i = 0; i < f.values().size(); ++i)
      f.values()[i] += .01 * noise.values()[i];
    f(0, 0, 1) += 1000;                                                                    // place does not matter
    CHECK(degrees_between(SP::best_rotation(one_core, f, g), r) < (degree == 1 ? 5 : .5)); // few data, more noise
  }
  // one function, and of another degree
  const Coefficients g = random_coefficients(12, 1, 7);
  const SP::Rotation r = some_rotation(8);
  CHECK(degrees_between(SP::best_rotation(one_core, SP::with_degree(SP::rotated(g, r), 15), g), r) < 1e-6);
}

TEST_CASE("the first-order ellipsoid, and shapes in its position", "[harmonics]")
{
  Coefficients shape = random_coefficients(10, 3, 11);
  for(int k = 0; k < 3; ++k)
    for(int l = 1; l <= 10; ++l)
      for(int m = -l; m <= l; ++m)
        shape(l, m, k) = .05 * shape(l, m, k) + (l == 1 && m == (k == 0 ? 1 : k == 1 ? -1 : 0) ? 3 - k : 0);
  const SP::First_order_ellipsoid ellipsoid = SP::first_order_ellipsoid(shape);
  CHECK(ellipsoid.radii[0] > ellipsoid.radii[1]);
  CHECK(ellipsoid.radii[1] > ellipsoid.radii[2]);
  CHECK(ellipsoid.radii[2] > 0);
  // the first-order part of the shape is the ellipsoid
  const Direction x = {.6, -.48, .64};
  const std::vector<double> there = SP::harmonic_values(one_core, SP::with_degree(shape, 1), std::vector<Direction>{x});
  const Direction on_axes = apply_rotation(ellipsoid.sphere_axes, x);
  for(std::size_t i = 0; i < 3; ++i) {
    double sum = ellipsoid.centre[i];
    for(std::size_t k = 0; k < 3; ++k)
      sum += ellipsoid.axes[k][i] * ellipsoid.radii[k] * on_axes[k];
    CHECK(there[i] == Approx(sum).margin(1e-11));
  }
  // in its position it has no place and no direction left, wherever it came from
  const Coefficients aligned = SP::aligned_to_ellipsoid(shape);
  for(int k = 0; k < 3; ++k) {
    CHECK(aligned(0, 0, k) == 0);
    for(int m = -1; m <= 1; ++m)
      CHECK(aligned(1, m, k) == Approx(m == (k == 0   ? 1
                                             : k == 1 ? -1
                                                      : 0)
                                         ? ellipsoid.radii[std::size_t(k)] * std::sqrt(4 * pi / 3)
                                         : 0)
                                  .margin(1e-12));
  }
  const SP::Rotation in_space = some_rotation(12), of_map = some_rotation(13);
  Coefficients moved(10, 3);
  for(int i = 0; i < shape.size(); ++i)
    for(int k = 0; k < 3; ++k)
      for(int j = 0; j < 3; ++j)
        moved.field_begin(k)[i] += in_space[std::size_t(k)][std::size_t(j)] * shape.field_begin(j)[i];
  moved(0, 0, 2) += 100;
  CHECK(difference(SP::aligned_to_ellipsoid(SP::rotated(moved, of_map)), aligned) < 1e-10);
}

TEST_CASE("shapes in any pose are brought together, also where the ellipsoid is a sphere", "[harmonics]")
{
  const double elongation = GENERATE(0., .5);
  for(unsigned seed = 0; seed < 4; ++seed) {
    Coefficients g = random_coefficients(12, 3, 40 + seed);
    for(double& x : g.values())
      x *= .3;
    for(int k = 0; k < 3; ++k)
      g(1, k == 0 ? 1 : k == 1 ? -1 : 0, k) += 2 + elongation * k;
    const SP::Rotation in_space = some_rotation(50 + seed), of_map = some_rotation(60 + seed);
    const bool is_mirrored = seed == 3;
    Coefficients f(12, 3);
    const Coefficients turned = SP::rotated(is_mirrored ? SP::mirrored(g) : g, of_map);
    for(int i = 0; i < f.size(); ++i)
      for(int k = 0; k < 3; ++k)
        for(int j = 0; j < 3; ++j)
          f.field_begin(k)[i] += 7 * in_space[std::size_t(k)][std::size_t(j)] * turned.field_begin(j)[i];
    f(0, 0, 1) += 300;
    const SP::Shape_alignment found = SP::best_alignment(one_core, f, is_mirrored ? SP::mirrored(g) : g);
    CHECK(degrees_between(found.space, in_space) < 1e-3);
    CHECK(degrees_between(found.sphere, of_map) < 1e-3);
    CHECK(found.correlation == Approx(1).margin(1e-9));
    if(is_mirrored)
      CHECK(SP::best_alignment(one_core, f, g).correlation < .999);
  }
}

TEST_CASE("a mirror image is that of the points", "[harmonics]")
{
  const Coefficients c = random_coefficients(7, 3, 16);
  const std::vector<double> there = SP::harmonic_values(one_core, c, std::vector<Direction>{{1, 2, 3}});
  const std::vector<double> mirrored =
    SP::harmonic_values(one_core, SP::mirrored(c), std::vector<Direction>{{1, 2, -3}});
  CHECK(mirrored[0] == Approx(there[0]));
  CHECK(mirrored[1] == Approx(there[1]));
  CHECK(mirrored[2] == Approx(-there[2]));
}

TEST_CASE("filters, smaller and larger degrees", "[harmonics]")
{
  const Coefficients c = random_coefficients(6, 2, 14);
  const Coefficients smooth = SP::filtered(c, [](int l) { return std::exp(-.1 * l * (l + 1)); });
  CHECK(smooth(0, 0, 1) == c(0, 0, 1));
  CHECK(smooth(5, -3, 1) == Approx(std::exp(-3.) * c(5, -3, 1)));
  const Coefficients low = SP::with_degree(c, 3);
  CHECK(low.degree() == 3);
  CHECK(low(3, -3, 1) == c(3, -3, 1));
  const Coefficients high = SP::with_degree(c, 8);
  CHECK(high(6, 6, 1) == c(6, 6, 1));
  CHECK(high(8, 0, 1) == 0);
}

TEST_CASE("files of coefficients read back", "[harmonics]")
{
  using Format = SP::Coefficient_format;
  const Coefficients c = random_coefficients(9, 3, 15);
  const auto text = [&](Format format) {
    std::ostringstream out;
    SP::write_coefficients(out, c, format);
    return out.str();
  };
  const auto read = [](const std::string& from, Format format) {
    std::istringstream in(from);
    return SP::read_coefficients(in, format);
  };
  CHECK(read(text(Format::CSV), Format::CSV).values() == c.values());
  CHECK(read(text(Format::JSON), Format::JSON).values() == c.values());
  CHECK(difference(read(text(Format::SPHARM_PDM), Format::SPHARM_PDM), c) < 1e-15);
  // SPHARM-PDM's own: of degree 1, as its writer writes, for the unit sphere x, y, z
  const double k = std::sqrt(4 * pi / 3);
  std::ostringstream pdm;
  pdm.precision(17);
  pdm << "{ 4,{0.000000, 0.000000, 0.000000},\n{0.000000, 0.000000, " << k << "},\n{" << -std::sqrt(2.) * k
      << ", 0.000000, 0.000000},\n{0.000000, " << -std::sqrt(2.) * k << ", 0.000000}}";
  const Coefficients sphere = read(pdm.str(), Format::SPHARM_PDM);
  const std::vector<double> at = SP::harmonic_values(one_core, sphere, std::vector<Direction>{{.6, 0, .8}, {0, -1, 0}});
  const std::vector<double> expected = {.6, 0, .8, 0, -1, 0};
  for(std::size_t i = 0; i < 6; ++i)
    CHECK(std::abs(at[i]) == Approx(std::abs(expected[i])).margin(1e-12));
  for(const Format format : {Format::CSV, Format::JSON, Format::SPHARM_PDM}) {
    const std::string good = text(format);
    CHECK_THROWS_AS(read("", format), std::runtime_error);
    CHECK_THROWS_AS(read(good.substr(0, good.size() / 2), format), std::runtime_error);
    std::string wrong = good;
    wrong[wrong.rfind('.')] = 'x';
    CHECK_THROWS_AS(read(wrong, format), std::runtime_error);
  }
  CHECK_THROWS_WITH(read("{ 268435456, {0,0,0}", Format::SPHARM_PDM),
                    Catch::Contains("cut short")); // and no memory is taken
  std::ostringstream out;
  CHECK_THROWS_AS(SP::write_coefficients(out, Coefficients(3, 2), Format::SPHARM_PDM), std::runtime_error);
  CHECK_THROWS_AS(SP::write_coefficients(out, Coefficients(), Format::CSV), CGAL::Precondition_exception);
  Coefficients nan(1, 3);
  nan(1, 0, 2) = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(SP::write_coefficients(out, nan, Format::JSON), SP::Error);
  CHECK(out.str().empty());
}

TEST_CASE("what cannot be analyzed is refused", "[harmonics]")
{
  const Mesh mesh = make_mesh(icosphere(1)); // 42 vertices
  CHECK_THROWS_AS(SP::harmonic_analysis(mesh, mesh.points(), mesh.points(), 6), CGAL::Precondition_exception);
  CHECK_NOTHROW(SP::harmonic_analysis(mesh, mesh.points(), mesh.points(), 6, SP::Integration()));
  CHECK_THROWS_AS(SP::harmonic_analysis(mesh, mesh.points(), mesh.points(), -1), CGAL::Precondition_exception);
  SP::Least_squares bad;
  bad.accuracy = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(SP::harmonic_analysis(mesh, mesh.points(), mesh.points(), 2, bad), CGAL::Precondition_exception);
  const auto not_finite = Readable_map<Vertex, double>{[](Vertex v) { return 1. / double(v.idx()); }};
  CHECK_THROWS_AS(SP::harmonic_analysis(mesh, mesh.points(), not_finite, 2), SP::Error);
  const auto zero = Readable_map<Vertex, Point>{[](Vertex) { return Point(0, 0, 0); }};
  CHECK_THROWS_AS(SP::harmonic_analysis(mesh, zero, mesh.points(), 2), SP::Error);
  std::map<Vertex, Point> out;
  CHECK_THROWS_AS(SP::harmonic_synthesis(Coefficients(2, 1), mesh, mesh.points(), Writable_map<Vertex, Point>{&out}),
                  CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::first_order_ellipsoid(Coefficients(0, 3)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::best_rotation(one_core, Coefficients(2, 1), Coefficients(2, 3)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::best_alignment(one_core, Coefficients(2, 1), Coefficients(2, 3)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::mirrored(Coefficients(2, 1)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(Grid::equidistant(1, 4), CGAL::Precondition_exception);
}

TEST_CASE("maps that are not valid are not analyzed", "[harmonics]")
{
  const Mesh mesh = make_mesh(icosphere(3));
  const auto height = Readable_map<Vertex, double>{[&](Vertex v) { return 1 + mesh.point(v).z(); }};
  const auto check = [&](const std::function<Point(Vertex)>& image) {
    const auto is_refused = [](const SP::Error& error) { return error.code() == SP::Error_code::NOT_BIJECTIVE; };
    const Readable_map<Vertex, Point> map{image};
    CHECK_THROWS_MATCHES(SP::harmonic_analysis(mesh, map, height, 4), SP::Error,
                         Catch::Predicate<SP::Error>(is_refused));
    CHECK_THROWS_MATCHES(SP::harmonic_analysis(mesh, map, height, 4, SP::Integration()), SP::Error,
                         Catch::Predicate<SP::Error>(is_refused));
  };
  check([&](Vertex v) { // the mirror image
    const Point& p = mesh.point(v);
    return Point(-p.x(), p.y(), p.z());
  });
  check([&](Vertex v) { // a vertex on the other side
    const Point& p = mesh.point(v);
    return v == Vertex(100) ? Point(-p.x(), -p.y(), -p.z()) : p;
  });
}

TEST_CASE("coefficients that are not finite are refused", "[harmonics]")
{
  const Mesh mesh = make_mesh(icosphere(2));
  for(const double wrong : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const Coefficients good = random_coefficients(3, 3, 1);
    Coefficients bad = good, all = good;
    bad(2, -1, 1) = wrong;
    std::fill(all.values().begin(), all.values().end(), wrong);
    for(const Coefficients& c : {bad, all}) {
      std::map<Vertex, Point> out;
      CHECK_THROWS_AS(SP::best_rotation(c, good), SP::Error);
      CHECK_THROWS_AS(SP::best_rotation(good, c), SP::Error);
      CHECK_THROWS_AS(SP::best_alignment(c, good), SP::Error);
      CHECK_THROWS_AS(SP::best_alignment(good, c), SP::Error);
      CHECK_THROWS_AS(SP::rotated(c, some_rotation(1)), SP::Error);
      CHECK_THROWS_AS(SP::first_order_ellipsoid(c), SP::Error);
      CHECK_THROWS_AS(SP::aligned_to_ellipsoid(c), SP::Error);
      CHECK_THROWS_AS(SP::harmonic_values(c, std::vector<Direction>{{1, 2, 3}}), SP::Error);
      CHECK_THROWS_AS(SP::harmonic_grid_values(c, Grid::gauss_legendre(3)), SP::Error);
      CHECK_THROWS_AS(SP::harmonic_synthesis(c, mesh, mesh.points(), Writable_map<Vertex, Point>{&out}), SP::Error);
      CHECK(out.empty());
    }
    CHECK_THROWS_WITH(SP::rotated(bad, some_rotation(1)), Catch::Contains("l = 2, m = -1 of function 1"));
    const Grid grid = Grid::gauss_legendre(2);
    std::vector<double> values(std::size_t(grid.rows() * grid.columns()), 1);
    values[4] = wrong;
    CHECK_THROWS_WITH(SP::harmonic_grid_analysis(grid, values, 2), Catch::Contains("value 4"));
  }
}

TEST_CASE("the size of data and coefficients does not matter", "[harmonics]")
{
  const Mesh mesh = make_mesh(icosphere(3));
  const auto analyzed = [&](int exponent) {
    const auto f = Readable_map<Vertex, double>{
      [&](Vertex v) { return std::ldexp(1 + mesh.point(v).z() * mesh.point(v).x(), exponent); }};
    return SP::harmonic_analysis(mesh, mesh.points(), f, 8);
  };
  const SP::Harmonic_analysis one = analyzed(0);
  const Coefficients f = random_coefficients(6, 3, 3), g = SP::rotated(f, some_rotation(4));
  for(const int exponent : {-700, 700}) {
    const auto scaled = [&](Coefficients c) {
      for(double& x : c.values())
        x = std::ldexp(x, exponent);
      return c;
    };
    const SP::Harmonic_analysis other = analyzed(exponent);
    CHECK(other.coefficients.values() == scaled(one.coefficients).values());
    CHECK(other.has_converged);
    CHECK(other.iterations == one.iterations);
    CHECK(SP::best_rotation(scaled(f), g) == SP::best_rotation(f, g));
    const SP::Shape_alignment a = SP::best_alignment(f, scaled(g)), b = SP::best_alignment(f, g);
    CHECK(a.sphere == b.sphere);
    CHECK(a.space == b.space);
    CHECK(a.correlation == b.correlation);
    CHECK(SP::first_order_ellipsoid(scaled(f)).axes == SP::first_order_ellipsoid(f).axes);
  }
}

TEST_CASE("least squares have converged where their gradient says so", "[harmonics]")
{
  const Mesh mesh = make_mesh(icosphere(3)); // 642 vertices
  const auto rough = Readable_map<Vertex, double>{[](Vertex v) { return v.idx() % 7 < 3 ? 1. : -1.; }};
  SP::Least_squares method;
  method.weights = SP::Vertex_weights::EQUAL;
  constexpr int degree = 20;
  const auto gradient = [&](const Coefficients& c) { // at the coefficients, by sums over the vertices
    Coefficients result(degree);
    const std::vector<double> value = SP::harmonic_values(c, mesh.points());
    for(Vertex v : vertices(mesh)) {
      const Point& p = mesh.point(v);
      for(int l = 0; l <= degree; ++l)
        for(int m = -l; m <= l; ++m)
          result(l, m) += (get(rough, v) - value[v.idx()]) * harmonic(l, m, {p.x(), p.y(), p.z()});
    }
    double square = 0;
    for(double x : result.values())
      square += x * x;
    return std::sqrt(square);
  };
  const double first = gradient(Coefficients(degree));
  for(const double accuracy : {1e-2, 1e-6, 1e-10}) {
    method.accuracy = accuracy;
    const SP::Harmonic_analysis fit = SP::harmonic_analysis(mesh, mesh.points(), rough, degree, method);
    CHECK(fit.has_converged);
    CHECK(gradient(fit.coefficients) <= accuracy * first * (1 + 1e-3));
  }
  method.accuracy = 1e-30; // rounding does not let them come that far, and it is said
  const SP::Harmonic_analysis fit = SP::harmonic_analysis(mesh, mesh.points(), rough, degree, method);
  CHECK(!fit.has_converged);
  CHECK(gradient(fit.coefficients) < 1e-11 * first);
}

TEST_CASE("callback and time limit end whatever takes long with harmonics", "[harmonics]")
{
  // large enough for loops that ask every 5 ms
  const Mesh mesh = make_mesh(icosphere(6));
  const Coefficients f = random_coefficients(150, 3, 1), small = random_coefficients(32, 3, 1),
                     other = SP::rotated(small, some_rotation(2));
  const Grid grid = Grid::gauss_legendre(600);
  const std::vector<double> values = SP::harmonic_grid_values(f, grid);
  std::map<Vertex, Point> out;
  const Writable_map<Vertex, Point> written{&out};
  const auto check = [](const auto& call) {
    int calls = 0, calls_after_no = 0;
    double last = 0;
    const auto count = [&](double fraction) {
      CHECK(fraction >= last);
      CHECK(fraction <= 1);
      last = fraction;
      return ++calls > 0;
    };
    call(CGAL::parameters::callback(count));
    CHECK(calls > 1);
    const int no = 1; // how many calls there are depends on the time that they take
    calls = 0;
    const auto say_no = [&](double) {
      calls_after_no += calls > no;
      return ++calls <= no;
    };
    const auto is_interrupted = [](const SP::Error& e) { return e.code() == SP::Error_code::INTERRUPTED; };
    CHECK_THROWS_MATCHES(call(CGAL::parameters::callback(say_no)), SP::Error,
                         Catch::Predicate<SP::Error>(is_interrupted));
    CHECK(calls_after_no == 0);
    CHECK_THROWS_MATCHES(call(CGAL::parameters::maximum_running_time(0)), SP::Error,
                         Catch::Predicate<SP::Error>(is_interrupted));
  };
  check(
    [&](const auto& np) { SP::harmonic_analysis(mesh, mesh.points(), mesh.points(), 20, SP::Least_squares(), np); });
  check([&](const auto& np) { SP::harmonic_analysis(mesh, mesh.points(), mesh.points(), 20, SP::Integration(), np); });
  check([&](const auto& np) { SP::harmonic_values(f, mesh.points(), np); });
  check([&](const auto& np) { SP::harmonic_grid_values(f, grid, np); });
  check([&](const auto& np) { SP::harmonic_grid_analysis(grid, values, 150, np); });
  check([&](const auto& np) { SP::rotated(f, some_rotation(1), np); });
  check([&](const auto& np) { SP::best_rotation(small, other, np); });
  check([&](const auto& np) { SP::best_alignment(small, other, np); });
  check([&](const auto& np) { SP::aligned_to_ellipsoid(f, np); });
  CHECK_THROWS_AS(SP::harmonic_synthesis(f, mesh, mesh.points(), written, CGAL::parameters::maximum_running_time(0)),
                  SP::Error);
  CHECK(out.empty());
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("harmonics are the same bits on several threads", "[harmonics]")
{
  const CGAL::Parallel_tag several;
  const Mesh mesh = make_mesh(icosphere(5));
  const auto values = Readable_map<Vertex, double>{[&](Vertex v) { return std::abs(mesh.point(v).x()); }};
  const auto one = SP::harmonic_analysis(mesh, mesh.points(), values, 20);
  CHECK(SP::harmonic_analysis(several, mesh, mesh.points(), values, 20).coefficients.values() ==
        one.coefficients.values());
  CHECK(SP::harmonic_analysis(several, mesh, mesh.points(), values, 20, SP::Integration()).coefficients.values() ==
        SP::harmonic_analysis(mesh, mesh.points(), values, 20, SP::Integration()).coefficients.values());
  const std::vector<Direction> directions = {{1, 2, 3}, {-1, 2, -3}};
  CHECK(SP::harmonic_values(several, one.coefficients, directions) ==
        SP::harmonic_values(one_core, one.coefficients, directions));
  CHECK(SP::best_rotation(several, one.coefficients, one.coefficients) ==
        SP::best_rotation(one_core, one.coefficients, one.coefficients));
}
#endif
