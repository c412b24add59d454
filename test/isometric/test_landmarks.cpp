// SPDX-License-Identifier: GPL-3.0-or-later
// The isometric method with fixed vertices: exactly where they were put, or refused by name; or soft.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <catch2/catch.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <cmath>
#include <limits>
#include <map>
#include <string>

using namespace test;

namespace {

typedef std::map<std::size_t, Point> Landmarks;

Settings with_landmarks(const Landmarks& landmarks, double weight = std::numeric_limits<double>::infinity())
{
  Settings settings;
  settings.method = SP::Isometric{1, weight};
  settings.accuracy = SP::Isometric::default_accuracy;
  settings.number_of_iterations = SP::Isometric::default_number_of_iterations;
  settings.fixed = landmarks;
  return settings;
}

/// The direction as a unit vector
Point on_sphere(double x, double y, double z)
{
  const double length = std::sqrt(x * x + y * y + z * z);
  return Point(x / length, y / length, z / length);
}

/// So many vertices, spread over the numbering, each put where vertex `image(i)` of the map is, moved by up to `move`.
template <class Image>
Landmarks moved(const Sphere& map, std::size_t number, double move, Image image)
{
  Landmarks landmarks;
  for(std::size_t i = 0; i < number; ++i) {
    const Point p = map[image(i) * map.size() / number];
    const double angle = 2.4 * double(i); // turns by the golden angle do not repeat
    landmarks[i * map.size() / number] =
      on_sphere(p.x() + move * std::cos(angle), p.y() + move * std::sin(angle), p.z());
  }
  return landmarks;
}

Sphere check_valid(const Soup& soup, const Settings& settings)
{
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result, soup.points.size());
  REQUIRE(bool(result));
  CHECK(result.detail.empty());
  CHECK(count_flipped_faces(soup, sphere) == 0);
  CHECK(degree(soup, sphere) == 1);
  return sphere;
}

/// The map is valid, and has all landmarks where they belong, to the last bit.
void check_kept(const Soup& soup, const Landmarks& landmarks)
{
  const Sphere sphere = check_valid(soup, with_landmarks(landmarks));
  for(const auto& [vertex, position] : landmarks)
    CHECK(sphere[vertex] == position);
}

} // namespace

TEST_CASE("landmarks stay exactly where they are put: three, five, fifty", "[landmarks]")
{
  const Soup soup = bumpy_sphere(4);
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  for(std::size_t number : {3, 5, 50}) {
    CAPTURE(number);
    check_kept(soup, moved(free, number, 0.1, [](std::size_t i) { return i; }));
  }
}

TEST_CASE("landmarks that contradict the shape are kept", "[landmarks]")
{
  const Soup soup = bumpy_sphere(4);
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  SECTION("mirrored")
  {
    Landmarks landmarks;
    for(std::size_t v : {0, 100, 200, 300, 400})
      landmarks[v] = Point(-free[v].x(), free[v].y(), free[v].z());
    check_kept(soup, landmarks);
  }
  SECTION("permuted")
  {
    check_kept(soup, moved(free, 6, 0.05, [](std::size_t i) { return 5 * i % 6; }));
  }
  SECTION("two neighbours change places")
  {
    const auto& f = soup.faces[0];
    check_kept(soup, {{f[0], free[f[1]]}, {f[1], free[f[0]]}, {soup.points.size() - 1, free.back()}});
  }
}

TEST_CASE("landmarks on limbs and thin bars are kept", "[landmarks]")
{
  for(const Soup& soup : {dumbbell(3), comb(6, 8), capsule(4, 12)}) {
    const Sphere free = solve_or_throw(soup, with_landmarks({}));
    check_kept(soup, moved(free, 5, 0.2, [](std::size_t i) { return i; }));
  }
}

TEST_CASE("landmarks that get stuck are brought home from the map without them", "[landmarks]")
{
  const Soup soup = comb(6, 12);
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  check_kept(soup, moved(free, 6, 0.25, [](std::size_t i) { return i; }));
}

TEST_CASE("three hundred landmarks follow a smooth deformation of the sphere", "[landmarks]")
{
  const Soup soup = bumpy_sphere(4);
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  constexpr std::size_t number = 300;
  Landmarks landmarks;
  for(std::size_t i = 0; i < number; ++i) { // a twist about the axis z
    const std::size_t v = i * free.size() / number;
    const Point p = free[v];
    const double c = std::cos(p.z()), s = std::sin(p.z());
    landmarks[v] = on_sphere(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  }
  check_kept(soup, landmarks);
}

TEST_CASE("all vertices fixed at a valid map: that is the map", "[landmarks]")
{
  const Soup soup = ellipsoid(1, 2, 3, 2);
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  Landmarks landmarks;
  for(std::size_t v = 0; v < free.size(); ++v)
    landmarks[v] = free[v];
  check_kept(soup, landmarks);
}

TEST_CASE("a tetrahedron keeps four landmarks", "[landmarks]")
{
  const Soup soup = tetrahedron();
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  Landmarks landmarks; // another tetrahedron
  for(std::size_t v = 0; v < 4; ++v)
    landmarks[v] = on_sphere(free[v].y() + 0.1, free[v].z(), free[v].x() - 0.05);
  check_kept(soup, landmarks);
}

TEST_CASE("landmarks that a coarse mesh cannot keep are refused by name", "[landmarks]")
{
  Sphere sphere;
  SECTION("all corners of a face")
  {
    const Soup soup = flat_octahedron(0);
    Landmarks mirrored;
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      mirrored[v] = on_sphere(-soup.points[v].x(), soup.points[v].y(), soup.points[v].z());
    const Result result = solve(soup, sphere, with_landmarks(mirrored));
    CAPTURE(result);
    CHECK(result.error == Error_code::BAD_CONSTRAINTS);
    CHECK(result.detail.find("corners of face") != std::string::npos);

    Settings automatic = with_landmarks(mirrored);
    automatic.method = SP::Automatic();
    const Result last = solve(soup, sphere, automatic);
    CAPTURE(last);
    CHECK(last.attempts.size() > 1); // the harmonic map has flipped faces
    CHECK(last.detail == result.detail);
  }
  SECTION("edges that would cross")
  {
    const Soup soup = icosphere(0);
    std::map<std::size_t, std::size_t> next; // of the ring of vertex 0
    for(const auto& f : soup.faces)
      for(int k = 0; k < 3; ++k)
        if(f[k] == 0)
          next[f[(k + 1) % 3]] = f[(k + 2) % 3];
    REQUIRE(next.size() == 5);
    const std::size_t first = next.begin()->first, second = next[first], third = next[second], fourth = next[third];
    const std::size_t fifth = next[fourth];
    const auto& p = soup.points;
    const Landmarks landmarks = {
      {first, p[first]}, {second, p[fourth]}, {third, p[third]}, {fourth, p[second]}, {fifth, p[fifth]}};
    const Result result = solve(soup, sphere, with_landmarks(landmarks));
    CAPTURE(result);
    CHECK(result.error == Error_code::BAD_CONSTRAINTS);
    CHECK(result.detail.find("too coarse") != std::string::npos);
    CHECK(result.detail.find(" and ") != std::string::npos);
  }
}

TEST_CASE("landmarks at one place are refused", "[landmarks]")
{
  Sphere sphere;
  const Landmarks landmarks = {{0, Point(1, 0, 0)}, {1, Point(0, 1, 0)}, {2, Point(1, 0, 0)}};
  CHECK(solve(icosphere(2), sphere, with_landmarks(landmarks)).error == Error_code::BAD_CONSTRAINTS);
}

TEST_CASE("automatic keeps landmarks that the harmonic maps cannot", "[landmarks][automatic]")
{
  const Soup soup = bumpy_sphere(4);
  Landmarks landmarks;
  for(std::size_t v : {0, 100, 200, 300, 400})
    landmarks[v] = on_sphere(-soup.points[v].x(), soup.points[v].y(), soup.points[v].z());
  Settings settings;
  settings.method = SP::Automatic();
  settings.fixed = landmarks;
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  CHECK(bool(result));
  CHECK(result.method == "isometric");
  for(const auto& [vertex, position] : landmarks)
    CHECK(sphere[vertex] == position);
}

TEST_CASE("soft landmarks come the nearer the larger their weight", "[landmarks]")
{
  const Soup soup = bumpy_sphere(3);
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  const Landmarks landmarks = moved(free, 5, 0.4, [](std::size_t i) { return i; });
  double before = std::numeric_limits<double>::infinity();
  for(double weight : {0.1, 10., 1000.}) {
    const Sphere sphere = check_valid(soup, with_landmarks(landmarks, weight));
    double sum = 0;
    for(const auto& [vertex, position] : landmarks)
      sum += CGAL::squared_distance(sphere[vertex], position);
    CAPTURE(weight, sum);
    CHECK(sum < before / 2);
    before = sum;
  }
  CHECK(before < 1e-4);
}

TEST_CASE("the map with landmarks is that of one core, bit by bit", "[landmarks][each_policy]")
{
  const Soup soup = bumpy_sphere(4);
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  Settings settings = with_landmarks(moved(free, 6, 0.05, [](std::size_t i) { return 5 * i % 6; }));
  const Sphere sphere = solve_or_throw(soup, settings);
  settings.policy = CGAL::Sequential_tag();
  CHECK(solve_or_throw(soup, settings) == sphere);
}

TEST_CASE("turned landmarks give the turned map", "[landmarks]")
{
  const Soup soup = bumpy_sphere(3);
  const Sphere free = solve_or_throw(soup, with_landmarks({}));
  const Landmarks landmarks = moved(free, 5, 0.2, [](std::size_t i) { return i; });
  const auto rotation = random_rotation(3);
  Landmarks turned;
  for(const auto& [vertex, position] : landmarks)
    turned[vertex] = apply(rotation, position);
  const Sphere a = check_valid(soup, with_landmarks(landmarks)), b = check_valid(soup, with_landmarks(turned));
  double farthest = 0;
  for(std::size_t v = 0; v < a.size(); ++v)
    farthest = (std::max)(farthest, CGAL::squared_distance(apply(rotation, a[v]), b[v]));
  CHECK(std::sqrt(farthest) < 1e-2);
}
