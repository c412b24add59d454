// SPDX-License-Identifier: GPL-3.0-or-later
// locate.h: from the sphere back to the mesh.

#include "helpers/certificate.h"
#include "helpers/hard_maps.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Spherical_parameterization/locate.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace test;
namespace SP = CGAL::Spherical_parameterization;

namespace {

using Locator = SP::Spherical_locator<Mesh>;
using Location = Locator::Face_location;

Locator make_locator(const Mesh& mesh, const Sphere& sphere)
{
  return Locator(mesh, Readable_map<Mesh::Vertex_index, Point>{[&](auto v) { return sphere[v]; }});
}

std::array<Point, 3> corners(const Mesh& mesh, const Sphere& sphere, Mesh::Face_index f)
{
  const auto h = mesh.halfedge(f);
  return {sphere[mesh.source(h)], sphere[mesh.target(h)], sphere[mesh.target(mesh.next(h))]};
}

/// By exact predicates: whether the direction is in the closed face.
bool contains(const std::array<Point, 3>& corner, const Point& q)
{
  const Point o(0, 0, 0);
  return exact_orientation(o, corner[0], corner[1], q) != CGAL::NEGATIVE &&
         exact_orientation(o, corner[1], corner[2], q) != CGAL::NEGATIVE &&
         exact_orientation(o, corner[2], corner[0], q) != CGAL::NEGATIVE;
}

/// Distance of the weighted mean of the corners from the line along q, over the longest edge. Exact but for the last
/// step, since doubles do not resolve what is asked for inside of limbs.
double round_trip_error(const std::array<Point, 3>& corner, const std::array<double, 3>& weight, const Point& q)
{
  using FT = CGAL::Exact_rational;
  std::array<FT, 3> mean = {0, 0, 0}, cross;
  for(int i = 0; i < 3; ++i)
    for(std::size_t k = 0; k < 3; ++k)
      mean[std::size_t(i)] += FT(weight[k]) * FT(corner[k][i]);
  double squared = 0, longest = 0;
  for(int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const double x = CGAL::to_double(FT(mean[std::size_t(j)] * FT(q[k]) - mean[std::size_t(k)] * FT(q[j])));
    squared += x * x;
    longest = std::max(longest, std::sqrt(CGAL::squared_distance(corner[std::size_t(j)], corner[std::size_t(k)])));
  }
  return std::sqrt(squared / (q - CGAL::ORIGIN).squared_length()) / longest;
}

Point random_direction(std::mt19937& random)
{
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random), z = normal(random), length = std::sqrt(x * x + y * y + z * z);
  return Point(x / length, y / length, z / length);
}

void check(const Mesh& mesh, const Sphere& sphere, const Location& location, const Point& q)
{
  const auto corner = corners(mesh, sphere, location.first);
  const auto& w = location.second;
  CAPTURE(q, w[0], w[1], w[2]);
  REQUIRE(contains(corner, q));
  REQUIRE(std::min({w[0], w[1], w[2]}) >= 0);
  REQUIRE(std::abs(w[0] + w[1] + w[2] - 1) < 1e-15);
  REQUIRE(round_trip_error(corner, w, q) < 1e-12);
}

} // namespace

TEST_CASE("every vertex is found where it is", "[locate]")
{
  for(const Mapped_soup& map : hard_maps()) {
    const Mesh mesh = make_mesh(map.soup);
    const Locator locator = make_locator(mesh, map.sphere);
    CAPTURE(map.name);
    for(auto v : vertices(mesh)) {
      const auto [f, w] = locator.locate(map.sphere[v]);
      const auto h = mesh.halfedge(f);
      const std::array<Mesh::Vertex_index, 3> corner = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
      const std::size_t k = std::size_t(std::find(corner.begin(), corner.end(), v) - corner.begin());
      REQUIRE(k < 3);
      CHECK(w[k] == 1);
      CHECK(w[(k + 1) % 3] == 0);
    }
  }
}

TEST_CASE("directions inside of every face are found there, however small it is", "[locate]")
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> weight(0.1, 1);
  for(const Mapped_soup& map : hard_maps()) {
    const Mesh mesh = make_mesh(map.soup);
    const Locator locator = make_locator(mesh, map.sphere);
    CAPTURE(map.name);
    for(auto f : faces(mesh)) {
      const auto corner = corners(mesh, map.sphere, f);
      const Vector sum = weight(random) * (corner[0] - CGAL::ORIGIN) + weight(random) * (corner[1] - CGAL::ORIGIN) +
                         weight(random) * (corner[2] - CGAL::ORIGIN);
      const Point q = CGAL::ORIGIN + sum / std::sqrt(sum.squared_length());
      const Location location = locator.locate(q);
      check(mesh, map.sphere, location, q);
      if(contains(corner, q) && location.first != f) // rounding may have put it on an edge, but not beyond
        CHECK(std::min({location.second[0], location.second[1], location.second[2]}) < 1e-12);
    }
  }
}

TEST_CASE("random directions, and the middles of edges", "[locate]")
{
  std::mt19937 random(2);
  for(const Mapped_soup& map : hard_maps()) {
    const Mesh mesh = make_mesh(map.soup);
    const Locator locator = make_locator(mesh, map.sphere);
    CAPTURE(map.name);
    for(int i = 0; i < 500; ++i) {
      const Point q = random_direction(random);
      check(mesh, map.sphere, locator.locate(q), q);
    }
    for(auto e : edges(mesh)) {
      const auto h = mesh.halfedge(e);
      const Point q = CGAL::midpoint(map.sphere[mesh.source(h)], map.sphere[mesh.target(h)]);
      check(mesh, map.sphere, locator.locate(q), q);
    }
  }
}

TEST_CASE("a million random directions make the round trip", "[locate]")
{
  const auto rotation = random_rotation(3);
  const Soup soup = transformed(icosphere(5), [&](const Point& p) { return test::apply(rotation, p); });
  const Mesh mesh = make_mesh(soup);
  const Locator locator = make_locator(mesh, soup.points);
  std::mt19937 random(3);
  double largest = 0;
  for(int i = 0; i < 1000000; ++i) {
    const Point q = random_direction(random);
    const auto [f, w] = locator.locate(q);
    const auto c = corners(mesh, soup.points, f);
    const Vector p = w[0] * (c[0] - CGAL::ORIGIN) + w[1] * (c[1] - CGAL::ORIGIN) + w[2] * (c[2] - CGAL::ORIGIN);
    const double squared_distance = CGAL::cross_product(p, q - CGAL::ORIGIN).squared_length();
    largest = std::max(largest, squared_distance / CGAL::squared_distance(c[0], c[1]));
  }
  CHECK(std::sqrt(largest) < 1e-12);
}

TEST_CASE("the length of a direction does not matter", "[locate]")
{
  const Mapped_soup map = small_star(1e-6, 8);
  const Mesh mesh = make_mesh(map.soup);
  const Locator locator = make_locator(mesh, map.sphere);
  for(std::size_t i = 0; i < 20; ++i) {
    const Point& p = map.sphere[i];
    for(const double length : {std::ldexp(1., 900), std::ldexp(1., -900), std::ldexp(1., 3)}) {
      const Point q(length * p.x(), length * p.y(), length * p.z());
      const auto [f, w] = locator.locate(q);
      CHECK(contains(corners(mesh, map.sphere, f), q));
      CHECK(std::max({w[0], w[1], w[2]}) == 1);
    }
  }
}

TEST_CASE("locating on a Polyhedron_3, in any type of direction", "[locate]")
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Polyhedron polyhedron = make_graph<Polyhedron>(icosphere(2));
  const auto points = get(CGAL::vertex_point, polyhedron);
  const SP::Spherical_locator<Polyhedron> locator(polyhedron, points);
  const std::array<double, 3> direction = {0.1, -3, 0.2};
  const auto [f, w] = locator.locate(direction);
  const auto h = halfedge(f, polyhedron);
  Vector p = w[0] * (get(points, source(h, polyhedron)) - CGAL::ORIGIN) +
             w[1] * (get(points, target(h, polyhedron)) - CGAL::ORIGIN) +
             w[2] * (get(points, target(next(h, polyhedron), polyhedron)) - CGAL::ORIGIN);
  CHECK(CGAL::cross_product(p, Vector(0.1, -3, 0.2)).squared_length() < 1e-28);
  CHECK(p.y() < 0);
}

TEST_CASE("locating: what is no direction, and what is no map", "[locate]")
{
  const Soup soup = icosphere(1);
  const Mesh mesh = make_mesh(soup);
  const Locator locator = make_locator(mesh, soup.points);
  const auto code_of = [](const auto& f) {
    try {
      f();
    } catch(const SP::Error& error) {
      return error.code();
    }
    return SP::Error_code::OK;
  };
  for(const Point& p : {Point(0, 0, 0), Point(0, std::numeric_limits<double>::quiet_NaN(), 1),
                        Point(std::numeric_limits<double>::infinity(), 0, 1)})
    CHECK(code_of([&] { locator.locate(p); }) == SP::Error_code::NON_FINITE_COORDINATE);

  Sphere flipped = soup.points;
  flipped[0] = flipped[soup.faces[0][0] == 0 ? soup.faces[0][1] : soup.faces[0][0]];
  CHECK(code_of([&] { make_locator(mesh, flipped); }) == SP::Error_code::NOT_BIJECTIVE);

  const Soup fine = icosphere(4);
  const Sphere twice = transformed(fine, [](const Point& p) {
                         const double r = std::hypot(p.x(), p.y()), angle = 2 * std::atan2(p.y(), p.x());
                         return Point(r * std::cos(angle), r * std::sin(angle), p.z());
                       }).points;
  const Mesh fine_mesh = make_mesh(fine);
  CHECK(code_of([&] { make_locator(fine_mesh, twice); }) == SP::Error_code::NOT_BIJECTIVE);

  // a hole so small that the degree does not tell, and a vertex without faces
  Mesh open = make_mesh(fine);
  CGAL::Euler::remove_face(open.halfedge(Mesh::Face_index(7)), open);
  CHECK(code_of([&] { make_locator(open, fine.points); }) == SP::Error_code::BOUNDARY);
  Soup with_isolated = fine;
  with_isolated.points.emplace_back(0, 0, 1);
  const Mesh isolated = make_mesh(with_isolated);
  CHECK(code_of([&] { make_locator(isolated, with_isolated.points); }) == SP::Error_code::ISOLATED_VERTEX);
}
