// SPDX-License-Identifier: GPL-3.0-or-later
// register_maps.h

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/register_maps.h>
#include <CGAL/assertions.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace test;

namespace {

using Vertex = Mesh::Vertex_index;
using Motion = SP::Registration::Motion;

/// A shape and its map.
struct Mapped {
  Soup soup;
  Mesh mesh;
  Sphere sphere;

  explicit Mapped(Soup s) : soup(std::move(s)), mesh(make_mesh(soup))
  {
    Settings settings;
    settings.method = SP::Isometric();
    sphere = solve_or_throw(soup, settings);
  }
  Mapped(Soup s, Sphere of_it) : soup(std::move(s)), mesh(make_mesh(soup)), sphere(std::move(of_it)) {}
  Readable_map<Vertex, Point> map() const
  {
    return {[this](Vertex v) { return sphere[v]; }};
  }
};

Soup limbs(double length)
{
  const std::vector<Vector>& d = six_directions();
  return body_with_limbs({{d[0], 0.4, length}, {d[1], 0.3, 2}, {d[2], 0.4, 1.2}, {d[4], 0.35, 1.6}}, 4).soup;
}

Sphere moved(const Sphere& sphere, const std::function<Point(const Point&)>& f)
{
  Sphere result;
  std::transform(sphere.begin(), sphere.end(), std::back_inserter(result), f);
  return result;
}

double mean_distance(const Sphere& a, const Sphere& b)
{
  double sum = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += std::sqrt((a[i] - b[i]).squared_length()) / double(a.size());
  return sum;
}

struct Registered {
  SP::Registration_result result;
  Sphere sphere;
};

Registered registered(const Mapped& a, const Mapped& b, const SP::Registration& method = {},
                      const std::vector<SP::Landmark_pair<Mesh, Mesh>>& landmarks = {})
{
  std::map<Vertex, Point> out;
  Registered r;
  r.result =
    SP::register_maps(a.mesh, a.map(), b.mesh, b.map(), Read_write_map<Vertex, Point>{&out}, method, landmarks);
  for(const auto& [v, p] : out)
    r.sphere.push_back(p);
  return r;
}

void check_certificate(const Mapped& a, const Registered& r)
{
  REQUIRE(r.result);
  CHECK(r.result.flipped_faces == 0);
  CHECK(r.result.degree == 1);
  CHECK(count_flipped_faces(a.soup, r.sphere) == 0);
  CHECK(degree(a.soup, r.sphere) == 1);
}

} // namespace

TEST_CASE("a map that was turned is turned back, whatever the pose of the shape", "[registration]")
{
  const Mapped b(limbs(1.4));
  Mapped a = b;
  const auto turn = random_rotation(3), pose = random_rotation(4);
  a.sphere = moved(b.sphere, [&](const Point& p) { return apply(turn, p); });
  for(Vertex v : vertices(a.mesh)) {
    const Point p = apply(pose, b.mesh.point(v));
    a.mesh.point(v) = Point(3 * p.x() + 1, 3 * p.y(), 3 * p.z());
  }
  const Motion motion = GENERATE(Motion::ROTATION, Motion::MOEBIUS, Motion::DEFORMATION);
  SP::Registration method;
  method.motion = motion;
  const Registered r = registered(a, b, method);
  check_certificate(a, r);
  CHECK(mean_distance(r.sphere, b.sphere) < 0.01);
  if(motion == Motion::DEFORMATION) {
    CHECK(r.result.distortion < 4.001);
    CHECK(r.result.mismatch_before < 0.01);
    CHECK(r.result.mismatch < 0.01);
  }
}

TEST_CASE("what is alike is not bent", "[registration]")
{
  const Mapped a(limbs(1.4));
  const Registered r = registered(a, a);
  check_certificate(a, r);
  CHECK(r.result.distortion == 4);
  CHECK(r.result.mismatch < 1e-6);
  CHECK(mean_distance(r.sphere, a.sphere) < 1e-6);
}

TEST_CASE("deformation finds what a rotation cannot", "[registration]")
{
  const Mapped b(limbs(1.4));
  Mapped a = b;
  // another valid map: bent by a field that is no rotation, so little that no face flips
  a.sphere = moved(b.sphere, [](const Point& p) {
    const Vector v = (p - CGAL::ORIGIN) + 0.12 * Vector(std::sin(3 * p.y()), std::sin(2 * p.z()), std::sin(3 * p.x()));
    return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  });
  REQUIRE(count_flipped_faces(a.soup, a.sphere) == 0);
  SP::Registration rigid;
  rigid.motion = Motion::ROTATION;
  const Registered rotated = registered(a, b, rigid), deformed = registered(a, b);
  check_certificate(a, rotated);
  check_certificate(a, deformed);
  CHECK(mean_distance(deformed.sphere, b.sphere) < 0.8 * mean_distance(rotated.sphere, b.sphere));
  CHECK(deformed.result.distortion > 4);
  CHECK(deformed.result.mismatch < deformed.result.mismatch_before);
}

TEST_CASE("Moebius transformations are undone by Moebius registration", "[registration]")
{
  const Mapped b(limbs(1.4));
  Mapped a = b;
  const Vector c(0.2, -0.15, 0.1);
  a.sphere = moved(b.sphere, [&](const Point& p) {
    const Vector d = p - CGAL::ORIGIN - c;
    const Vector v = (1 - c.squared_length()) / d.squared_length() * d - c;
    return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  });
  SP::Registration method;
  method.motion = Motion::MOEBIUS;
  const Registered r = registered(a, b, method);
  check_certificate(a, r);
  CHECK(mean_distance(r.sphere, b.sphere) < 0.01);
}

TEST_CASE("landmarks are put onto each other, or their distance is said", "[registration]")
{
  const Mapped a(limbs(1.4)), b(limbs(1.8));
  std::vector<SP::Landmark_pair<Mesh, Mesh>> landmarks;
  for(int i : {10, 500, 1000, 1500, 2000})
    landmarks.emplace_back(Vertex(unsigned(i)), Vertex(unsigned(i)));
  const Registered r = registered(a, b, {}, landmarks);
  check_certificate(a, r);
  CHECK(r.result.start == "landmarks");
  double largest = 0;
  for(const auto& [v, w] : landmarks)
    largest = (std::max)(largest, 2 * std::asin(std::sqrt((r.sphere[v] - b.sphere[w]).squared_length()) / 2));
  CHECK(largest == Approx(r.result.largest_landmark_distance).margin(1e-7));
  CHECK(largest < 0.05);
}

TEST_CASE("positions count if that is asked for", "[registration]")
{
  const Mapped a(bumpy_sphere(4)), b(bumpy_sphere(3)); // of the same shape, of other vertices
  SP::Registration method;
  method.position_weight = 20;
  const Registered r = registered(a, b, method);
  check_certificate(a, r);
  const SP::Spherical_locator<Mesh> locator(b.mesh, b.map());
  double error = 0;
  for(Vertex v : vertices(a.mesh)) {
    const Point p = SP::interpolate(b.mesh, locator.locate(r.sphere[v]), b.mesh.points());
    error += std::sqrt((p - a.mesh.point(v)).squared_length()) / double(a.sphere.size());
  }
  CHECK(error < 0.03); // of a radius of 1, with edges of 0.15
}

TEST_CASE("what cannot be registered is named", "[registration]")
{
  const Mapped a(bumpy_sphere(2));
  Mapped flipped = a;
  flipped.sphere = moved(a.sphere, [](const Point& p) { return Point(-p.x(), p.y(), p.z()); });
  CHECK(registered(flipped, a).result.error == Error_code::NOT_BIJECTIVE);
  CHECK(registered(a, flipped).result.error == Error_code::NOT_BIJECTIVE);
  CHECK(registered(flipped, a).sphere.empty());
  Mapped nowhere = a;
  nowhere.mesh.point(Vertex(5)) = Point(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  CHECK(registered(nowhere, a).result.error == Error_code::NON_FINITE_COORDINATE);
  Mapped point = a;
  for(Vertex v : vertices(point.mesh))
    point.mesh.point(v) = Point(1, 1, 1);
  CHECK(registered(point, a).result.error == Error_code::DEGENERATE_FACE);
  SP::Registration method;
  method.curvature_weight = -1;
  CHECK_THROWS_AS(registered(a, a, method), CGAL::Precondition_exception);
  method = {};
  method.levels = 0;
  CHECK_THROWS_AS(registered(a, a, method), CGAL::Precondition_exception);
  method = {};
  method.coarsest_scale = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(registered(a, a, method), CGAL::Precondition_exception);
}

TEST_CASE("centring brings the centroid of any masses to the centre", "[registration]")
{
  const Mapped a(limbs(1.4));
  std::mt19937 random(1);
  std::exponential_distribution<double> some;
  std::map<Vertex, double> mass;
  for(Vertex v : vertices(a.mesh))
    mass[v] = some(random);
  std::map<Vertex, Point> out;
  const auto of = [&](Vertex v) { return mass.at(v); };
  CHECK(SP::moebius_centred_map(a.mesh, a.map(), Readable_map<Vertex, double>{of}, Writable_map<Vertex, Point>{&out}) <
        1e-12);
  Vector sum(0, 0, 0);
  double total = 0;
  for(const auto& [v, p] : out) {
    sum = sum + mass[v] * (p - CGAL::ORIGIN);
    total += mass[v];
    CHECK((p - CGAL::ORIGIN).squared_length() == Approx(1));
  }
  CHECK(std::sqrt(sum.squared_length()) < 1e-11 * total);
  for(double wrong : {-1., std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    mass[Vertex(3)] = wrong;
    CHECK_THROWS_AS(
      SP::moebius_centred_map(a.mesh, a.map(), Readable_map<Vertex, double>{of}, Writable_map<Vertex, Point>{&out}),
      SP::Error);
  }
  // there is no such transformation for a mass in one point
  for(auto& [v, m] : mass)
    m = v == Vertex(3) ? 1 : 0;
  CHECK(SP::moebius_centred_map(a.mesh, a.map(), Readable_map<Vertex, double>{of}, Writable_map<Vertex, Point>{&out}) >
        0.5);
}

TEST_CASE("callback and time limit end a registration with a certified map", "[registration]")
{
  const Mapped a(limbs(1.4)), b(limbs(1.8));
  std::map<Vertex, Point> out;
  const auto run = [&](const auto& parameters) {
    out.clear();
    return SP::register_maps(a.mesh, a.map(), b.mesh, b.map(), Read_write_map<Vertex, Point>{&out}, {}, {}, parameters);
  };
  const auto check_stored = [&](const SP::Registration_result& r) {
    CHECK(r.error == Error_code::INTERRUPTED);
    CHECK(!r.detail.empty());
    Sphere sphere;
    for(const auto& [v, p] : out)
      sphere.push_back(p);
    CHECK(r.flipped_faces == 0);
    CHECK(count_flipped_faces(a.soup, sphere) == 0);
    CHECK(degree(a.soup, sphere) == 1);
  };

  std::vector<double> fractions;
  const auto note = [&](double fraction) {
    fractions.push_back(fraction);
    return true;
  };
  CHECK(run(CGAL::parameters::callback(note)));
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.front() >= 0);
  CHECK(fractions.back() <= 1);
  CHECK(fractions.back() > 0.8); // the last level may be short

  for(const double last : {0., 0.2, 0.6}) {
    std::size_t calls_after_no = 0;
    bool has_said_no = false;
    const auto say_no = [&](double fraction) {
      calls_after_no += has_said_no;
      has_said_no = has_said_no || fraction >= last;
      return !has_said_no;
    };
    check_stored(run(CGAL::parameters::callback(say_no)));
    CHECK(calls_after_no == 0);
  }
  check_stored(run(CGAL::parameters::maximum_running_time(0)));
  CHECK_THROWS_AS(run(CGAL::parameters::maximum_running_time(std::numeric_limits<double>::quiet_NaN())),
                  CGAL::Precondition_exception);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("registration is the same bits on several threads", "[registration]")
{
  const Soup round = icosphere(5);
  const auto longer = [](const Point& p) { return Point(1.5 * p.x(), p.y(), p.z()); };
  const Mapped a(bumpy_sphere(5), round.points), b(transformed(bumpy_sphere(5), longer), round.points);
  SP::Registration method;
  method.levels = 2;
  method.iterations = 3;
  std::map<Vertex, Point> on_several;
  const SP::Registration_result r = SP::register_maps(CGAL::Parallel_tag(), a.mesh, a.map(), b.mesh, b.map(),
                                                      Read_write_map<Vertex, Point>{&on_several}, method);
  REQUIRE(r);
  CHECK(r.iterations == 6);
  const Sphere on_one = registered(a, b, method).sphere;
  REQUIRE(on_several.size() == on_one.size());
  CHECK(std::all_of(on_several.begin(), on_several.end(),
                    [&](const auto& p) { return p.second == on_one[static_cast<std::size_t>(p.first.idx())]; }));
  CHECK(mean_distance(on_one, round.points) > 1e-3);
}
#endif
