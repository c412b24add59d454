// SPDX-License-Identifier: GPL-3.0-or-later
// A symmetric mesh has a symmetric map.
//
// On an icosphere of level 0 or 1 every vertex lies on an axis of the rotation group of the icosahedron, so the
// weighted mean of its neighbours does too, whatever the (symmetric) weights: the mesh itself solves eq. (2) exactly.
// From level 2 on only the symmetry remains, and that conformal maps converge to the identity under refinement.
//
// With exponent 2 and no fixed vertices a boost is free, and balancing picks it by the masses of a map that is the
// solution to a residual of 1e-5 only: there the statements hold up to a boost that small.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <catch2/catch.hpp>

#include <cmath>

using namespace test;

namespace {

/// The rotation by 72 degrees about vertex 0 of the icosahedron, as a permutation of the vertices of an icosphere.
std::vector<std::size_t> fivefold_rotation(const Soup& icosphere)
{
  const Vector axis = icosphere.points[0] - CGAL::ORIGIN;
  const double angle = 2 * std::acos(-1.) / 5, c = std::cos(angle), s = std::sin(angle);
  std::vector<std::size_t> image;
  for(const Point& p : icosphere.points) {
    const Vector v = p - CGAL::ORIGIN;
    const Vector rotated = c * v + s * CGAL::cross_product(axis, v) + (1 - c) * (axis * v) * axis;
    std::size_t nearest = 0;
    for(std::size_t i = 0; i < icosphere.points.size(); ++i)
      if(CGAL::squared_distance(icosphere.points[i], CGAL::ORIGIN + rotated) <
         CGAL::squared_distance(icosphere.points[nearest], CGAL::ORIGIN + rotated))
        nearest = i;
    image.push_back(nearest);
  }
  return image;
}

/// How far the balanced boost may be from the symmetric one.
const double boost_tolerance = 1e-5;

Settings settings(Weights weights, double exponent)
{
  Settings s;
  s.weights = weights;
  s.method = SP::Balanced{exponent};
  return s;
}

} // namespace

TEST_CASE("an icosphere all of whose vertices lie on axes of symmetry is a fixed point up to rotation",
          "[symmetry][each_policy]")
{
  const int level = GENERATE(0, 1);
  const Weights weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED, Weights::CONFORMAL);
  CAPTURE(level, int(weights));
  const Soup soup = icosphere(level);
  CHECK(distance_up_to_rotation(soup.points, solve_or_throw(soup, settings(weights, 3))) < 1e-8);
  CHECK(distance_up_to_rotation(soup.points, solve_or_throw(soup, settings(weights, 2))) < boost_tolerance);
}

TEST_CASE("the map of a symmetric mesh has its symmetry", "[symmetry]")
{
  const Weights weights = GENERATE(Weights::BARYCENTRIC, Weights::CLAMPED, Weights::CONFORMAL);
  const Soup soup = icosphere(3);
  const std::vector<std::size_t> image = fivefold_rotation(soup);
  for(const auto& [exponent, tolerance] : {std::pair(3., 1e-7), std::pair(2., boost_tolerance)}) {
    CAPTURE(int(weights), exponent);
    const Sphere sphere = solve_or_throw(soup, settings(weights, exponent));
    Sphere rotated;
    for(std::size_t i : image)
      rotated.push_back(sphere[i]);
    CHECK(distance(sphere, rotated) > 0.1);
    CHECK(distance_up_to_rotation(sphere, rotated) < tolerance);
  }
}

TEST_CASE("conformal maps of icospheres converge to the identity", "[symmetry]")
{
  double previous = 0;
  for(int level = 2; level <= 4; ++level) {
    const Soup soup = icosphere(level);
    const double error = distance_up_to_rotation(soup.points, solve_or_throw(soup));
    CAPTURE(level, previous, error);
    CHECK(error < 0.01);
    if(level > 2)
      CHECK(error < 0.5 * previous);
    previous = error;
  }
}

TEST_CASE("the map of a mirrored mesh is the mirrored map", "[symmetry]")
{
  const Soup soup = bumpy_sphere(3);
  auto mirror = [](const Point& p) { return Point(p.x(), -p.y(), p.z()); };
  Soup mirrored = transformed(soup, mirror);
  for(auto& face : mirrored.faces)
    std::swap(face[1], face[2]);
  Soup sphere = soup;
  sphere.points = solve_or_throw(soup);
  CHECK(distance_up_to_rotation(transformed(sphere, mirror).points, solve_or_throw(mirrored)) < boost_tolerance);
}
