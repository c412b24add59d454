// SPDX-License-Identifier: GPL-3.0-or-later
// The tests of the tests: are the generated meshes what their names say, and does the independent certificate notice?

#include "helpers/certificate.h"
#include "helpers/meshes.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace test;

namespace {

/// Vertices - edges + faces of a closed triangle mesh.
long euler_characteristic(const Soup& soup)
{
  return long(soup.points.size()) - long(soup.faces.size()) * 3 / 2 + long(soup.faces.size());
}

double volume(const Soup& soup)
{
  double sum = 0;
  for(const auto& f : soup.faces)
    sum += CGAL::volume(Point(0, 0, 0), soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]);
  return sum;
}

} // namespace

TEST_CASE("closed fixtures are closed, of genus 0 and oriented outwards", "[helpers]")
{
  const std::vector<Soup> soups = {tetrahedron(),
                                   icosphere(0),
                                   icosphere(3),
                                   flat_octahedron(3),
                                   ellipsoid(1, 2, 3, 2),
                                   bumpy_sphere(3),
                                   dumbbell(3),
                                   spiky_star(3, 2),
                                   cube(),
                                   cross(),
                                   capsule(2, 12),
                                   collinear_face(),
                                   coincident_points()};
  for(const Soup& soup : soups) {
    CAPTURE(soup.points.size());
    CHECK(CGAL::is_closed(make_mesh(soup)));
    CHECK(euler_characteristic(soup) == 2);
    CHECK(volume(soup) > 0);
  }
}

TEST_CASE("fixtures that have to be refused have the fault of their name", "[helpers]")
{
  CHECK(euler_characteristic(torus(8, 6)) == 0);
  CHECK(euler_characteristic(double_torus()) == -2);
  CHECK(CGAL::is_closed(make_mesh(torus(8, 6))));
  CHECK(CGAL::is_closed(make_mesh(double_torus())));
  CHECK_FALSE(CGAL::is_closed(make_mesh(open_sphere(1))));
  CHECK(euler_characteristic(two_spheres()) == 4);
  CHECK_FALSE(CGAL::is_triangle_mesh(make_mesh(quad_cube())));
  CHECK(make_mesh(isolated_vertex()).is_isolated(Mesh::Vertex_index(42)));
  CHECK(hourglass().number_of_vertices() == two_spheres().points.size() - 1);
  CHECK(pinched_sphere().number_of_vertices() == icosphere(2).points.size() - 1);
  CHECK(CGAL::is_closed(hourglass()));
  const Soup collinear = collinear_face();
  const auto& f = collinear.faces[0];
  CHECK(CGAL::collinear(collinear.points[f[0]], collinear.points[f[1]], collinear.points[f[2]]));
}

TEST_CASE("the independent certificate counts flips and coverings", "[helpers]")
{
  const Soup soup = icosphere(2);
  Sphere sphere = soup.points;
  CHECK(count_flipped_faces(soup, sphere) == 0);
  CHECK(degree(soup, sphere) == 1);
  CHECK(smallest_area(soup, sphere) > 0.01);
  CHECK(count_vertices_off_sphere(sphere) == 0);

  sphere[0] = Point(-sphere[0].x(), -sphere[0].y(), -sphere[0].z()); // to the antipode: its five faces turn over
  CHECK(count_flipped_faces(soup, sphere) == 5);
  CHECK(smallest_area(soup, sphere) > 0.01);

  Sphere mirrored;
  for(const Point& p : soup.points)
    mirrored.emplace_back(-p.x(), p.y(), p.z());
  CHECK(count_flipped_faces(soup, mirrored) == soup.faces.size());
  CHECK(degree(soup, mirrored) == -1);

  const Sphere collapsed(soup.points.size(), Point(0, 0, 1));
  CHECK(smallest_area(soup, collapsed) == 0);
  CHECK(count_flipped_faces(soup, collapsed) == soup.faces.size());
  CHECK(degree(soup, collapsed) == 0);
}

TEST_CASE("the independent residual vanishes where symmetry says so, and nowhere else", "[helpers]")
{
  // every vertex of an icosphere of level 1 lies on an axis of symmetry
  const Soup soup = icosphere(1);
  for(Weights weights : {Weights::BARYCENTRIC, Weights::CLAMPED, Weights::MEAN_VALUE}) {
    const auto springs = make_springs(soup, weights);
    CHECK(springs.size() == 120);
    CHECK(residual(springs, soup.points) < 1e-14);
    CHECK(balanced_residual(springs, soup.points) < 1e-14);
    CHECK(residual(springs, soup.points, {}, 3) < 1e-14);
    const Sphere moved = transformed(soup, [](const Point& p) {
                           const double length = std::sqrt((p - Point(-.1, -.3, 0)).squared_length());
                           return CGAL::ORIGIN + (p - Point(-.1, -.3, 0)) / length;
                         }).points;
    CHECK(residual(springs, moved) > 1e-2);
    CHECK(balanced_residual(springs, moved) > 1e-3);
    CHECK(energy(springs, moved) > 0);
  }
}

TEST_CASE("alignment finds rotations and refuses reflections", "[helpers]")
{
  const Soup soup = bumpy_sphere(2);
  const auto rotation = random_rotation(7);
  const Sphere rotated = transformed(soup, [&](const Point& p) { return apply(rotation, p); }).points;
  const Sphere mirrored = transformed(soup, [](const Point& p) { return Point(-p.x(), p.y(), p.z()); }).points;
  CHECK(distance(soup.points, rotated) > 0.1);
  CHECK(distance_up_to_rotation(soup.points, rotated) < 1e-14);
  CHECK(distance_up_to_rotation(soup.points, mirrored) > 0.1);
}
