// SPDX-License-Identifier: GPL-3.0-or-later
// measure_distortion.h on maps made by hand.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace test;
namespace SP = CGAL::Spherical_parameterization;

namespace {

using Vertex = Mesh::Vertex_index;

Point opposite(const Point& p) { return Point(-p.x(), -p.y(), -p.z()); }

/// Pulled towards the poles.
Point stretched(const Point& p)
{
  const double length = std::sqrt(p.x() * p.x() / 4 + p.y() * p.y() / 4 + p.z() * p.z());
  return Point(p.x() / 2 / length, p.y() / 2 / length, p.z() / length);
}

/// log(source share / sphere share) of a face.
double log_stretch(const Soup& soup, const Sphere& sphere, const std::vector<std::size_t>& face)
{
  auto flat_area = [&](const std::vector<std::size_t>& f) {
    return std::sqrt(CGAL::squared_area(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]));
  };
  double total = 0;
  for(const auto& f : soup.faces)
    total += flat_area(f);
  Soup one;
  one.faces = {face};
  return std::log(flat_area(face) / total / (smallest_area(one, sphere) / (4 * std::acos(-1.))));
}

} // namespace

TEST_CASE("flips and degree of maps made by hand", "[distortion]")
{
  const Soup soup = icosphere(2);
  const Mesh mesh = make_mesh(soup);
  Sphere sphere = soup.points;

  SECTION("the identity")
  {
    CHECK(SP::number_of_flipped_faces(mesh, on(sphere)) == 0);
    CHECK(SP::degree_of_map(mesh, on(sphere)) == 1);
  }
  SECTION("one vertex of degree five at its antipode")
  {
    sphere[0] = opposite(sphere[0]);
    CHECK(SP::number_of_flipped_faces(mesh, on(sphere)) == 5);
  }
  SECTION("one vertex pulled over the opposite side of its star")
  {
    // past a neighbour in the same direction: some faces turn over, and the degree stays
    const Vector to_neighbour = sphere[soup.faces[0][1]] - sphere[soup.faces[0][0]];
    const Vector moved = sphere[soup.faces[0][0]] - CGAL::ORIGIN + 2 * to_neighbour;
    sphere[soup.faces[0][0]] = CGAL::ORIGIN + moved / std::sqrt(moved.squared_length());
    const std::size_t flips = SP::number_of_flipped_faces(mesh, on(sphere));
    CHECK(flips > 0);
    CHECK(flips == count_flipped_faces(soup, sphere));
    CHECK(SP::degree_of_map(mesh, on(sphere)) == 1);
  }
  SECTION("two equal points: their two faces have no orientation")
  {
    sphere[soup.faces[0][0]] = sphere[soup.faces[0][1]];
    const std::size_t flips = SP::number_of_flipped_faces(mesh, on(sphere));
    CHECK(flips == count_flipped_faces(soup, sphere));
    CHECK(flips >= 2);
    CHECK(SP::degree_of_map(mesh, on(sphere)) == 1);
  }
  SECTION("a vertex that is nowhere: its faces are not oriented")
  {
    sphere[0] = Point(0, std::numeric_limits<double>::quiet_NaN(), 1);
    CHECK(SP::number_of_flipped_faces(mesh, on(sphere)) == 5);
  }
  SECTION("the antipodal map")
  {
    for(Point& p : sphere)
      p = opposite(p);
    CHECK(SP::number_of_flipped_faces(mesh, on(sphere)) == soup.faces.size());
    CHECK(SP::degree_of_map(mesh, on(sphere)) == -1);
  }
  SECTION("a rotation by half a turn: two reversals")
  {
    for(Point& p : sphere)
      p = Point(-p.x(), -p.y(), p.z());
    CHECK(SP::number_of_flipped_faces(mesh, on(sphere)) == 0);
    CHECK(SP::degree_of_map(mesh, on(sphere)) == 1);
  }
  SECTION("a fold: the southern half laid on the northern one")
  {
    for(Point& p : sphere)
      p = Point(p.x(), p.y(), std::abs(p.z()));
    CHECK(SP::degree_of_map(mesh, on(sphere)) == 0);
    CHECK(SP::number_of_flipped_faces(mesh, on(sphere)) == count_flipped_faces(soup, sphere));
  }
  SECTION("all in one point")
  {
    sphere.assign(sphere.size(), Point(0, 0, 1));
    CHECK(SP::number_of_flipped_faces(mesh, on(sphere)) == soup.faces.size());
    CHECK(SP::degree_of_map(mesh, on(sphere)) == 0);
  }
}

TEST_CASE("a map that winds twice round the axis has degree 2", "[distortion]")
{
  // fine enough that no face becomes larger than a half-sphere
  const Soup soup = icosphere(4);
  const Sphere sphere = transformed(soup, [](const Point& p) {
                          const double r = std::hypot(p.x(), p.y()), angle = 2 * std::atan2(p.y(), p.x());
                          return Point(r * std::cos(angle), r * std::sin(angle), p.z());
                        }).points;
  const Mesh mesh = make_mesh(soup);
  CHECK(SP::degree_of_map(mesh, on(sphere)) == 2);
  CHECK(degree(soup, sphere) == 2);
}

TEST_CASE("the degree is right where the directions in which faces are counted are on a border", "[distortion]")
{
  const double t = 773. / 1024; // certificate.h: (1, t, t^2), t = 773/1024 + 0, 1, ...
  const Point q(1, t, t * t), next(1, t + 1, (t + 1) * (t + 1));
  const auto mean = [&](double s, double r) { // on the great circle through both
    return Point(s * q.x() + r * next.x(), s * q.y() + r * next.y(), s * q.z() + r * next.z());
  };
  const Soup soup = tetrahedron();
  const Mesh mesh = make_mesh(soup);
  const Point far(-1, -2, 2);
  Sphere sphere;
  SECTION("two vertices there") { sphere = {q, next, far}; }
  SECTION("an edge through the first, a vertex at the second")
  {
    sphere = {Point(q.x() + 0.5, q.y(), q.z() - 1), next, Point(q.x() - 0.5, q.y(), q.z() + 1)};
  }
  SECTION("an edge through both") { sphere = {mean(2, -1), far, mean(-1, 2)}; }
  SECTION("an edge on the great circle through both") { sphere = {mean(-1, 5), mean(-1, 3), far}; }
  sphere.push_back(
    opposite(Point(sphere[0].x() + sphere[1].x() + sphere[2].x(), sphere[0].y() + sphere[1].y() + sphere[2].y(),
                   sphere[0].z() + sphere[1].z() + sphere[2].z())));
  const int expected = degree(soup, sphere);
  CHECK(std::abs(expected) == 1);
  CHECK(SP::degree_of_map(mesh, on(sphere)) == expected);
}

TEST_CASE("flips are counted by exact predicates", "[distortion]")
{
  // The star of a vertex shrunk until its faces are far below the rounding errors of a determinant, round a point with
  // full mantissas: what counts is the sign of the exact determinant of the doubles.
  const auto rotation = random_rotation(5);
  const Soup soup = transformed(icosphere(2), [&](const Point& p) { return apply(rotation, p); });
  const Mesh mesh = make_mesh(soup);
  bool some_flipped = false, some_not = false;
  for(double scale : {1e-6, 1e-10, 1e-13, 1e-15, 3e-16}) {
    Sphere sphere = soup.points;
    for(const auto& f : soup.faces)
      if(std::find(f.begin(), f.end(), 0) != f.end())
        for(std::size_t i : f)
          sphere[i] = soup.points[0] + scale * (soup.points[i] - soup.points[0]);
    const std::size_t flips = SP::number_of_flipped_faces(mesh, on(sphere));
    CHECK(flips == count_flipped_faces(soup, sphere));
    some_flipped = some_flipped || flips > 0;
    some_not = some_not || (flips == 0 && scale < 1e-12);
  }
  CHECK(some_flipped);
  CHECK(some_not);
}

TEST_CASE("log area stretch is zero for an icosahedron", "[distortion]")
{
  const Soup soup = icosphere(0);
  Mesh mesh = make_mesh(soup);
  auto stretch = mesh.add_property_map<Vertex, double>("v:stretch", 42).first;
  const auto [least, greatest] = SP::vertex_log_area_stretch(mesh, on(soup.points), stretch);
  CHECK(std::abs(least) < 1e-14);
  CHECK(std::abs(greatest) < 1e-14);
  for(Vertex v : vertices(mesh))
    CHECK(std::abs(stretch[v]) < 1e-14);
}

TEST_CASE("log area stretch is the mean over the faces of a vertex", "[distortion]")
{
  const Soup soup = bumpy_sphere(2);
  const Sphere sphere = transformed(icosphere(2), stretched).points;
  Mesh mesh = make_mesh(soup);
  auto stretch = mesh.add_property_map<Vertex, double>("v:stretch", 42).first;
  const auto [least, greatest] = SP::vertex_log_area_stretch(mesh, on(sphere), stretch);

  std::vector<double> sum(soup.points.size(), 0), faces(soup.points.size(), 0);
  for(const auto& f : soup.faces) {
    const double x = log_stretch(soup, sphere, f);
    for(std::size_t i : f) {
      sum[i] += x;
      ++faces[i];
    }
  }
  for(Vertex v : vertices(mesh))
    CHECK(stretch[v] == Approx(sum[v] / faces[v]).margin(1e-12));
  CHECK(least == *std::min_element(stretch.begin(), stretch.end()));
  CHECK(greatest == *std::max_element(stretch.begin(), stretch.end()));
  CHECK(greatest - least > 0.5);
}

TEST_CASE("log area stretch is positive where the map shrinks", "[distortion]")
{
  Mesh mesh = make_mesh(icosphere(2));
  auto stretch = mesh.add_property_map<Vertex, double>("v:stretch", 0).first;
  const Sphere sphere = transformed(icosphere(2), stretched).points;
  SP::vertex_log_area_stretch(mesh, on(sphere), stretch);
  for(Vertex v : vertices(mesh)) {
    if(std::abs(mesh.point(v).z()) > 0.9)
      CHECK(stretch[v] > 0.3);
    if(std::abs(mesh.point(v).z()) < 0.1)
      CHECK(stretch[v] < -0.3);
  }
}
