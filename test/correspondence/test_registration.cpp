// SPDX-License-Identifier: GPL-3.0-or-later
// register_maps.h and moebius_centring.h

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/internal/correspondence/Carried_face.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Geodesic_graph.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Map_to_goal.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Order_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Registration_energy.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_registration.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/register_surfaces.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/moebius_centring.h>
#include <CGAL/Spherical_parameterization/register_maps.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>
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
  auto both() const { return SP::mapped_mesh(mesh, map()); }
};

Soup limbs(const std::array<double, 4>& length, int level = 4)
{
  const std::vector<Vector>& d = six_directions();
  return body_with_limbs(
           {{d[0], 0.4, length[0]}, {d[1], 0.3, length[1]}, {d[2], 0.4, length[2]}, {d[4], 0.35, length[3]}}, level)
    .soup;
}

Soup limbs(double length, int level = 4) { return limbs({length, 2, 1.2, 1.6}, level); }

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
  r.result = SP::register_maps(a.both(), b.both(), Read_write_map<Vertex, Point>{&out}, method, landmarks);
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

TEST_CASE("landmarks are put exactly onto each other", "[registration]")
{
  const Mapped a(limbs(1.4)), b(limbs(1.8));
  std::vector<SP::Landmark_pair<Mesh, Mesh>> landmarks;
  for(int i : {10, 500, 1000, 1500, 2000})
    landmarks.emplace_back(Vertex(unsigned(i)), Vertex(unsigned(i)));
  const Registered r = registered(a, b, {}, landmarks);
  check_certificate(a, r);
  CHECK(r.result.start == "spectrum");
  double largest = 0;
  for(const auto& [v, w] : landmarks)
    largest = (std::max)(largest, 2 * std::asin(std::sqrt((r.sphere[v] - b.sphere[w]).squared_length()) / 2));
  CHECK(largest == Approx(r.result.largest_landmark_distance).margin(1e-7));
  CHECK(largest < 1e-7);
}

TEST_CASE("landmarks that contradict the shapes are kept, too", "[registration]")
{
  const Mapped a(limbs(1.4));
  std::vector<SP::Landmark_pair<Mesh, Mesh>> landmarks;
  for(int i : {0, 12, 100, 321, 640})
    landmarks.emplace_back(Vertex(unsigned(i)), Vertex(unsigned((i + 700) % 1400)));
  const Registered r = registered(a, a, {}, landmarks);
  check_certificate(a, r);
  CHECK(r.result.largest_landmark_distance < 1e-7);
}

namespace {

/// Bent: turned about an axis, the more the farther out.
Soup in_another_pose(const Soup& soup)
{
  return transformed(soup, [](const Point& p) {
    const double angle = 0.5 * (std::sqrt((p - CGAL::ORIGIN).squared_length()) - 1), c = std::cos(angle),
                 s = std::sin(angle);
    return Point(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  });
}

/// How far the vertices of A, in the mean, are from where f says on B.
double mean_error(const Mapped& a, const Registered& r, const Mapped& b, const std::function<Point(Vertex)>& f)
{
  const SP::Spherical_locator<Mesh> locator(b.mesh, b.map());
  double error = 0;
  for(Vertex v : vertices(a.mesh)) {
    const Point p = SP::interpolate(b.mesh, locator.locate(r.sphere[v]), b.mesh.points());
    error += std::sqrt((p - f(v)).squared_length()) / double(a.sphere.size());
  }
  return error;
}

} // namespace

TEST_CASE("a body is found in another pose, whatever the numbers of its vertices", "[registration]")
{
  const Mapped a(limbs(1.4));
  std::vector<std::size_t> order;
  const Soup posed = in_another_pose(a.soup);
  const Mapped b(renumbered(posed, 5, order));
  const Registered r = registered(a, b);
  check_certificate(a, r);
  CHECK(r.result.start == "spectrum");
  CHECK(r.result.trust() == SP::Registration_result::Trust::SURE);
  CHECK(mean_error(a, r, b, [&](Vertex v) { return posed.points[v]; }) < 0.1); // limbs are 1.2 to 2 long
}

TEST_CASE("a body is found in another one, whose limbs have other lengths", "[registration]")
{
  const Mapped a(limbs({1.4, 2, 1.2, 1.6}));
  for(const std::array<double, 4>& length : {std::array<double, 4>{2, 1.4, 1.6, 1.2}, {0.9, 3, 0.8, 2.6}}) {
    const Mapped b(in_another_pose(limbs(length)));
    const Registered r = registered(a, b);
    check_certificate(a, r);
    CHECK(mean_error(a, r, b, [&](Vertex v) { return b.soup.points[v]; }) < 0.3); // limbs exchanged: 1.7
  }
}

TEST_CASE("a fine mesh follows the coarse one", "[registration]")
{
  const std::array<double, 4> length = {1.4, 2, 1.2, 1.6};
  const Mapped a(limbs(length, 5)), b(in_another_pose(limbs(length)));
  REQUIRE(a.sphere.size() > 10000); // more than eigenfunctions are computed of
  const Soup posed = in_another_pose(a.soup);
  const Registered r = registered(a, b);
  check_certificate(a, r);
  CHECK(r.result.start == "spectrum");
  CHECK(mean_error(a, r, b, [&](Vertex v) { return posed.points[v]; }) < 0.12);
}

TEST_CASE("shapes that have nothing to do with each other are not trusted to correspond", "[registration]")
{
  typedef SP::Registration_result::Trust Trust;
  const Mapped a(limbs(5)), b(bumpy_sphere(4));
  const Registered r = registered(a, b);
  check_certificate(a, r);
  CHECK((r.result.trust() == Trust::UNSURE || r.result.trust() == Trust::UNLIKE));
  SP::Registration_result result = r.result;
  result.signature_difference = 0.02;
  result.stretching = 5;
  result.margin = 1;
  CHECK(result.trust() == Trust::SURE);
  result.margin = 0.1;
  CHECK(result.trust() == Trust::UNSURE);
  result.stretching = 30;
  CHECK(result.trust() == Trust::UNLIKE);
}

TEST_CASE("nothing is trusted that was not asked", "[registration]")
{
  const Mapped a(limbs(1.4));
  SP::Registration method;
  method.motion = Motion::ROTATION;
  CHECK(registered(a, a, method).result.trust() == SP::Registration_result::Trust::UNKNOWN);
}

TEST_CASE("ways along edges and diagonals are hardly longer than geodesics", "[registration]")
{
  // also where half of the vertices are in a patch that is smaller than the mean way
  const double size = GENERATE(1., 1e-3);
  const Mapped ball(icosphere(5), icosphere(5).points);
  const auto map = SP::internal::read_map(ball.mesh, ball.mesh.points(), ball.map(), SP::internal::Reading::CHECKED,
                                          SP::internal::host_loop(CGAL::Sequential_tag()));
  auto points = map.image;
  for(auto& p : points)
    if(p.z > 0)
      p = {size * p.x, size * p.y, size * p.z};
  const SP::internal::Geodesic_graph graph(map.copy_of_corner_table(SP::internal::Host_loop()), points);
  const std::vector<double> distance = graph.distances(0);
  for(std::size_t i = 0; i < distance.size(); ++i) {
    const auto p = map.image[0], q = map.image[i];
    const double arc = 2 * std::asin(SP::internal::norm(SP::internal::sub(p, q)) / 2);
    if(size == 1) {
      CHECK(distance[i] >= 0.995 * arc); // the faces lie below the sphere
      CHECK(distance[i] <= 1.08 * arc);
    }
    double least = std::numeric_limits<double>::infinity(); // by way of a neighbour
    graph.for_each_way(static_cast<int>(i),
                       [&](int j, double length) { least = std::min(least, distance[j] + length); });
    CHECK(distance[i] == (i == 0 ? 0 : least));
  }
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

namespace {

/// An ellipsoid of revolution, whose form does not say how it is turned about its axis.
Mapped ellipsoid()
{
  Soup soup = icosphere(4);
  const Sphere sphere = soup.points;
  for(Point& p : soup.points)
    p = Point(p.x(), p.y(), 1.5 * p.z());
  return {std::move(soup), sphere};
}

/// About the axis, and more at some longitudes and latitudes than at others: so does the paint move.
Point carried(const Point& p, double bend)
{
  const double angle = 1.9 + bend * std::sin(2 * std::atan2(p.y(), p.x())) * (1 - p.z() * p.z());
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z()};
}

std::vector<SP::Registration_feature> paint(const Sphere& a, const Sphere& b)
{
  std::vector<SP::Registration_feature> features(3);
  for(int k = 0; k < 3; ++k)
    for(const auto& [of, values] : {std::pair(&a, &features[k].a), std::pair(&b, &features[k].b)})
      for(const Point& p : *of)
        values->push_back(std::sin(5 * p[k] + k + 1));
  return features;
}

} // namespace

TEST_CASE("what the form does not say, own features say", "[registration]")
{
  const Mapped shape = ellipsoid();
  const double bend = GENERATE(0., 0.25);
  const Sphere goal = moved(shape.sphere, [bend](const Point& p) { return carried(p, bend); });
  SP::Registration method;
  const double without = mean_distance(registered(shape, shape, method).sphere, goal);
  method.features = paint(goal, shape.sphere);
  const Registered joined = registered(shape, shape, method);
  check_certificate(shape, joined);
  CHECK(joined.result.start == "features");
  CHECK(joined.result.mismatch <= joined.result.mismatch_before);
  CHECK(mean_distance(joined.sphere, goal) < 0.03);
  CHECK(mean_distance(joined.sphere, goal) < 0.05 * without);
  method.curvature_weight = 0;
  const Registered alone = registered(shape, shape, method);
  CHECK(mean_distance(alone.sphere, goal) < 0.03);
  for(double& x : method.features[0].a) // in another unit: the same bits
    x *= 1024;
  CHECK(registered(shape, shape, method).sphere == alone.sphere);
  for(double& x : method.features[0].b) // and with another zero
    x = 0.3 * x + 7;
  CHECK(mean_distance(registered(shape, shape, method).sphere, alone.sphere) < 0.001);

  method.motion = Motion::ROTATION;
  const double turned = mean_distance(registered(shape, shape, method).sphere, goal);
  CHECK(turned < (bend == 0 ? 0.001 : 0.1));
  CHECK((bend == 0 || mean_distance(alone.sphere, goal) < 0.3 * turned));
  method.motion = Motion::MOEBIUS;
  CHECK(mean_distance(registered(shape, shape, method).sphere, goal) < (bend == 0 ? 0.001 : 0.1));
}

namespace {

/// The same shape and map, with other numbers of vertices and faces, and other first corners.
Mapped with_other_numbers(const Mapped& shape, unsigned seed, std::vector<std::size_t>& order)
{
  Soup soup = renumbered(shape.soup, seed, order);
  Sphere sphere;
  for(std::size_t i : order)
    sphere.push_back(shape.sphere[i]);
  return {std::move(soup), std::move(sphere)};
}

} // namespace

TEST_CASE("a registration is the same bits whatever the numbers of vertices and faces", "[registration]")
{
  const Mapped a(limbs(1.4, 3)), b(in_another_pose(a.soup));
  std::vector<std::size_t> order_a, order_b;
  const Mapped other_a = with_other_numbers(a, 1, order_a), other_b = with_other_numbers(b, 2, order_b);
  SP::Registration method, other_method;
  std::vector<SP::Landmark_pair<Mesh, Mesh>> landmarks, other_landmarks;
  SECTION("alone") {}
  SECTION("with landmarks")
  {
    for(std::size_t i : {10, 150, 300, 450}) {
      landmarks.emplace_back(Vertex(unsigned(order_a[i])), Vertex(unsigned(order_b[i])));
      other_landmarks.emplace_back(Vertex(unsigned(i)), Vertex(unsigned(i)));
    }
  }
  SECTION("with a feature")
  {
    method.features = {paint(a.sphere, b.sphere)[0]};
    SP::Registration_feature feature = method.features[0];
    for(std::size_t i = 0; i < order_a.size(); ++i) {
      feature.a[i] = method.features[0].a[order_a[i]];
      feature.b[i] = method.features[0].b[order_b[i]];
    }
    other_method.features = {feature};
  }
  const Registered r = registered(a, b, method, landmarks),
                   other = registered(other_a, other_b, other_method, other_landmarks);
  check_certificate(a, r);
  Sphere expected;
  for(std::size_t i : order_a)
    expected.push_back(r.sphere[i]);
  CHECK(other.sphere == expected);
  CHECK(other.result.stretching == r.result.stretching);
  CHECK(other.result.margin == r.result.margin);
}

TEST_CASE("a registration does not depend on the radius of the spheres", "[registration]")
{
  const Mapped a(limbs(1.4, 3)), b(in_another_pose(a.soup));
  const double radius = GENERATE(1 / 128., 100., 128.);
  const auto enlarge = [&](const Point& p) { return CGAL::ORIGIN + radius * (p - CGAL::ORIGIN); };
  Mapped large_a = a, large_b = b;
  large_a.sphere = moved(a.sphere, enlarge);
  large_b.sphere = moved(b.sphere, enlarge);
  const Registered r = registered(a, b), large = registered(large_a, large_b);
  check_certificate(large_a, large);
  CHECK(large.result.start == r.result.start);
  CHECK(large.result.margin == Approx(r.result.margin).epsilon(1e-3));
  CHECK(large.result.distortion == Approx(r.result.distortion).epsilon(1e-6));
  CHECK(mean_distance(large.sphere, r.sphere) < 1e-6);
}

TEST_CASE("features without weight, and constant ones, say nothing", "[registration]")
{
  const Mapped shape = ellipsoid();
  SP::Registration method;
  method.levels = 1;
  method.features = {{std::vector<double>(shape.sphere.size(), 0.1), std::vector<double>(shape.sphere.size(), 3)}};
  const Registered constant = registered(shape, shape, method);
  method.features[0].weight = 0;
  CHECK(constant.sphere == registered(shape, shape, method).sphere);
  CHECK(constant.result.mismatch == Approx(registered(shape, shape, method).result.mismatch));
  method.features[0].a[5] = std::numeric_limits<double>::quiet_NaN();
  const Registered refused = registered(shape, shape, method);
  CHECK(refused.result.error == SP::Error_code::NON_FINITE_COORDINATE);
  CHECK(refused.result.detail == "feature 0 of the first mesh is not finite at vertex 5");
  method.features[0].a.pop_back();
  CHECK_THROWS_AS(registered(shape, shape, method), CGAL::Precondition_exception);
  method.features[0] = {{}, {}, -1};
  CHECK_THROWS_AS(registered(shape, shape, method), CGAL::Precondition_exception);
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
  typedef std::vector<SP::Landmark_pair<Mesh, Mesh>> Landmarks;
  for(const Landmarks& wrong : {Landmarks{{Vertex(0), Vertex(0)}, {Vertex(0), Vertex(1)}},
                                Landmarks{{Vertex(0), Vertex(1)}, {Vertex(5), Vertex(1)}},
                                Landmarks{{Vertex(0), Vertex(100000)}}, Landmarks{{Mesh::null_vertex(), Vertex(1)}}})
    CHECK_THROWS_AS(registered(a, a, {}, wrong), CGAL::Precondition_exception);
  SP::Registration method;
  method.curvature_weight = -1;
  CHECK_THROWS_AS(registered(a, a, method), CGAL::Precondition_exception);
  method = {};
  method.landmark_weight = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(registered(a, a, method), CGAL::Precondition_exception);
  method = {};
  method.iterations = -1;
  CHECK_THROWS_AS(registered(a, a, method), CGAL::Precondition_exception);
  method = {};
  method.levels = 0;
  CHECK_THROWS_AS(registered(a, a, method), CGAL::Precondition_exception);
  method = {};
  method.coarsest_scale = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(registered(a, a, method), CGAL::Precondition_exception);
}

namespace {

/// An icosphere with a triangle of about this size in the middle of every face, so large that the map is valid exactly.
Mapped with_tiny_triangles(double size)
{
  Soup soup = icosphere(3);
  const Soup coarse = soup;
  soup.faces.clear();
  const auto is_positive = [](const Point& a, const Point& b, const Point& c) {
    return SP::internal::is_positively_oriented({a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}, {c.x(), c.y(), c.z()});
  };
  for(const auto& f : coarse.faces) {
    const std::array<Point, 3> corner = {coarse.points[f[0]], coarse.points[f[1]], coarse.points[f[2]]};
    const Vector middle = ((corner[0] - CGAL::ORIGIN) + (corner[1] - CGAL::ORIGIN) + (corner[2] - CGAL::ORIGIN)) / 3;
    std::array<Point, 3> p;
    bool is_valid = false;
    for(double e = size; !is_valid; e *= 1.3) {
      for(std::size_t k = 0; k < 3; ++k) {
        const Vector v = middle + e * ((corner[k] - CGAL::ORIGIN) - middle);
        p[k] = CGAL::ORIGIN + v / std::sqrt(v.squared_length());
      }
      is_valid = is_positive(p[0], p[1], p[2]);
      for(std::size_t k = 0, l = 1; k < 3; ++k, l = (k + 1) % 3)
        is_valid = is_valid && is_positive(corner[k], corner[l], p[k]) && is_positive(corner[l], p[l], p[k]);
    }
    const std::size_t n = soup.points.size();
    soup.points.insert(soup.points.end(), p.begin(), p.end());
    soup.faces.push_back({n, n + 1, n + 2});
    for(std::size_t k = 0, l = 1; k < 3; ++k, l = (k + 1) % 3) {
      soup.faces.push_back({f[k], f[l], n + k});
      soup.faces.push_back({f[l], n + l, n + k});
    }
  }
  const Sphere sphere = soup.points;
  for(std::size_t f = 0; f < coarse.faces.size(); ++f) { // on the surface they have a good size
    const auto& corner = coarse.faces[f];
    for(std::size_t k = 0; k < 3; ++k) {
      Vector v(0, 0, 0);
      for(std::size_t l = 0; l < 3; ++l)
        v = v + (l == k ? 0.6 : 0.2) * (coarse.points[corner[l]] - CGAL::ORIGIN);
      soup.points[coarse.points.size() + 3 * f + k] = CGAL::ORIGIN + v;
    }
  }
  for(Point& p : soup.points)
    p = Point(3 * p.x(), 2 * p.y(), p.z() * (1 + 0.3 * std::sin(5 * p.x())));
  return Mapped(soup, sphere);
}

/// For the parts of the registration.
SP::internal::Valid_map valid_map_of(const Mapped& m)
{
  namespace I = SP::internal;
  const I::Host_loop loop;
  return {I::read_map(m.mesh, m.mesh.points(), m.map(), I::Reading::CHECKED, loop), loop};
}

SP::internal::Registered_surface surface_of(const Mapped& m)
{
  return SP::internal::registered_surface(SP::internal::Host_loop(), valid_map_of(m));
}

Soup longer(const Soup& soup)
{
  return transformed(soup, [](const Point& p) { return Point(1.5 * p.x(), p.y() + 0.2 * p.x() * p.z(), p.z()); });
}

Sphere bent(const Sphere& sphere)
{
  return moved(sphere, [](const Point& p) {
    const Vector v = (p - CGAL::ORIGIN) + 0.1 * Vector(std::sin(3 * p.y()), std::sin(2 * p.z()), std::sin(3 * p.x()));
    return CGAL::ORIGIN + v / std::sqrt(v.squared_length());
  });
}

} // namespace

TEST_CASE("faces that rounding loses are registered or refused", "[registration]")
{
  const Mapped b(longer(icosphere(3)), icosphere(3).points);
  SP::Registration method;
  method.levels = 1;
  method.iterations = 3;
  method.motion = GENERATE(Motion::ROTATION, Motion::MOEBIUS, Motion::DEFORMATION);
  const auto check = [&](const Mapped& a, const std::vector<SP::Landmark_pair<Mesh, Mesh>>& landmarks) {
    REQUIRE(count_flipped_faces(a.soup, a.sphere) == 0);
    REQUIRE(degree(a.soup, a.sphere) == 1);
    const Registered r = registered(a, b, method, landmarks);
    if(r.result)
      check_certificate(a, r);
    else {
      CHECK(r.result.error == Error_code::NOT_BIJECTIVE);
      CHECK_THAT(r.result.detail, Catch::Contains("rounding"));
    }
    return bool(r.result);
  };
  const std::vector<SP::Landmark_pair<Mesh, Mesh>> three = {
    {Vertex(0), Vertex(0)}, {Vertex(5), Vertex(5)}, {Vertex(9), Vertex(9)}};
  const Mapped tiny = with_tiny_triangles(3e-15);
  check(tiny, {});
  check(tiny, three);
  CHECK(check(with_tiny_triangles(1e-3), three));           // these are large enough
  const Soup tube = capsule(68 / (2 * std::acos(-1.)), 24); // of length 68 and radius 1
  Settings settings;
  settings.weights = Weights::CONFORMAL;
  const Mapped long_tube(tube, solve_or_throw(tube, settings));
  check(long_tube, {});
  check(long_tube, three);
}

TEST_CASE("of answers that are equally good that one is taken which brings together what looks alike", "[registration]")
{
  namespace I = SP::internal;
  // half a turn about the third axis makes no difference to the shape
  const auto body = [](int level) {
    return Mapped(body_with_limbs({{{1, 0, 0}, 0.4, 2}, {{-1, 0, 0}, 0.4, 2}, {{0, 0, 1}, 0.4, 1.2}}, level).soup);
  };
  const Mapped shape_a = body(3), shape_b = body(4);
  const I::Registered_surface a = surface_of(shape_a), b = surface_of(shape_b);
  const I::Host_loop loop;
  I::Monitor monitor(1e9, {}, false);
  const I::Watched_loop<I::Host_loop> watched(loop, monitor);
  const I::Valid_map map_b = valid_map_of(shape_b);
  const I::Locator locator(loop, map_b);
  const double side = GENERATE(1., -1.);
  I::Registration_features paint = {1, {}, {}};
  for(const I::vec3& p : a.point)
    paint.a.push_back(p.x);
  double square = 0;
  for(const I::vec3& p : b.point) {
    paint.b.push_back(side * p.x);
    square += p.x * p.x / double(b.point.size());
  }
  I::Spectral_registration<> found(watched, a, b, locator, paint, {});
  REQUIRE(!found.image.empty());
  CHECK(std::abs(found.margin) < 0.1);
  CHECK(I::refine(loop, a, b, paint, {}, {0, 0, 0, 0}, monitor, found.image).mismatch < 0.1 * square);
}

TEST_CASE("a few places that are wrong are let go, and do not drag the others along", "[registration]")
{
  namespace I = SP::internal;
  const Mapped shape(limbs(1.4));
  const I::Registered_surface a = surface_of(shape);
  const I::Host_loop loop;
  I::Monitor monitor(1e9, {}, false);
  const I::Watched_loop<I::Host_loop> watched(loop, monitor);
  const I::Valid_map map = valid_map_of(shape);
  const I::Locator locator(loop, map);
  const int n = int(a.point.size());
  I::Registration_goal goal;
  goal.place = a.image;
  goal.target = a.point;
  const auto distance = [&](const I::Host_array<I::vec3>& x) {
    double mean = 0;
    for(int v = 0; v < n; ++v)
      mean += norm(sub(I::point_at(a, locator, x[v]), a.point[v])) / n;
    return mean;
  };
  std::vector<int> candidates;
  for(int v = 0; v < n; v += n / 100)
    candidates.push_back(v);
  const I::Geodesic_graph graph(a, a.point);
  SECTION("single ones are not pulled")
  {
    for(std::size_t k = 0; k < candidates.size(); k += 10) {
      goal.place[candidates[k]] = a.image[n - 1 - candidates[k]];
      goal.target[candidates[k]] = a.point[n - 1 - candidates[k]];
    }
    goal.spread_among(candidates, graph, a.point);
    CHECK(goal.spread.size() == candidates.size() - (candidates.size() + 9) / 10);
  }
  SECTION("those that all others contradict are let go")
  {
    goal.spread = candidates;
    for(std::size_t k = 0; k < candidates.size(); k += 10)
      goal.place[candidates[k]] = a.image[n - 1 - candidates[k]];
  }
  I::Map_to_goal<> found(watched, a, a, locator, goal, 0, 1);
  REQUIRE(!found.image().empty());
  CHECK(distance(found.image()) < 0.2); // the radius is about 1
  found.move_all();
  CHECK(distance(found.image()) < 0.05);
}

TEST_CASE("the gradient of the registration is that of its energy", "[registration]")
{
  namespace I = SP::internal;
  const I::Host_loop loop;
  const Soup round = icosphere(3);
  const I::Registered_surface a = surface_of({bumpy_sphere(3), round.points}),
                              b = surface_of({longer(bumpy_sphere(3)), bent(round.points)});
  const std::size_t n = a.point.size();
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  I::Registration_features features;
  if(GENERATE(false, true)) {
    features.number = 2;
    for(std::size_t k = 0; k < 2 * n; ++k) {
      features.a.push_back(normal(random));
      features.b.push_back(normal(random));
    }
  }
  const std::vector<I::Registration_landmark> landmarks = {{3, b.image[7]}, {100, b.image[90]}};
  I::Refinement settings = {};
  settings.isometry_weight = GENERATE(0., 3.);
  settings.landmark_weight = GENERATE(0., 2.);
  const auto turn = random_rotation(5);
  I::Host_array<I::vec3> x;
  for(const I::vec3& p : a.image) {
    const Point q = test::apply(turn, Point(p.x, p.y, p.z));
    x.push_back(I::unit({q.x() + 0.02 * std::sin(5 * q.y()), q.y(), q.z() + 0.02 * std::sin(4 * q.x())}));
  }
  I::Registration_energy energy(loop, a, b, features, landmarks, settings, x);
  REQUIRE(std::isfinite(energy.value(x)));
  CHECK((energy.stretching() > 4) == (settings.isometry_weight > 0));
  I::Host_array<I::vec3> gradient;
  energy.gradient(x, gradient);
  for(int trial = 0; trial < 5; ++trial) {
    I::Host_array<I::vec3> direction;
    double slope = 0;
    for(std::size_t i = 0; i < n; ++i) {
      direction.push_back(I::tangent({normal(random), normal(random), normal(random)}, x[i]));
      slope += I::inner(gradient[i], direction[i]);
    }
    const auto at = [&](double t) {
      I::Host_array<I::vec3> y;
      for(std::size_t i = 0; i < n; ++i)
        y.push_back(I::unit(I::add_scaled(x[i], t, direction[i])));
      return energy.value(y);
    };
    constexpr double h = 1e-7;
    CHECK((at(h) - at(-h)) / (2 * h) == Approx(slope).epsilon(1e-4).margin(1e-5));
  }
}

TEST_CASE("the second derivative of a carried triangle is that of its gradient, without what is negative",
          "[registration]")
{
  namespace I = SP::internal;
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  const auto random_vector = [&] { return I::vec3{normal(random), normal(random), normal(random)}; };
  typedef std::array<I::vec3, 3> Corners;
  const bool is_stretched = GENERATE(false, true);
  int trials = 0;
  while(trials < 100) {
    const Corners x = {random_vector(), random_vector(), random_vector()};
    Corners y = {random_vector(), random_vector(), random_vector()}, way;
    if(is_stretched) // where both singular values are above 1, nothing is negative
      for(int m = 0; m < 3; ++m)
        y[m] = I::add_scaled(I::scale(1.5, x[m]), 0.3, I::make_vec3(-x[m].y, x[m].x, 0.1 * x[m].z));
    for(I::vec3& w : way)
      w = random_vector();
    const auto at = [&](double t) {
      return I::Carried_face(x[0], x[1], x[2], I::add_scaled(y[0], t, way[0]), I::add_scaled(y[1], t, way[1]),
                             I::add_scaled(y[2], t, way[2]));
    };
    const I::Carried_face face = at(0);
    if(!face.counts() || !(face.energy() < 100 * face.area()))
      continue;
    ++trials;
    constexpr double h = 1e-5;
    const Corners after = at(h).gradients(), before = at(-h).gradients();
    double measured = 0, sum = 0;
    for(int m = 0; m < 3; ++m)
      measured += I::inner(way[m], I::sub(after[m], before[m])) / (2 * h);
    face.for_each_mode([&](double weight, const Corners& by_place) {
      const double change =
        I::inner(by_place[0], way[0]) + I::inner(by_place[1], way[1]) + I::inner(by_place[2], way[2]);
      sum += weight * change * change;
    });
    INFO("trial " << trials);
    CHECK(sum >= (std::max)(0., measured - 1e-3 * std::abs(measured)));
    if(is_stretched)
      CHECK(sum == Approx(measured).epsilon(1e-3));
  }
}

TEST_CASE("a deformation converges in a few steps of Newton's method at any size", "[registration]")
{
  namespace I = SP::internal;
  const I::Host_loop loop;
  for(const int level : {3, 4, 5}) {
    const Soup round = icosphere(level);
    const I::Registered_surface a = surface_of({bumpy_sphere(level), round.points}),
                                b = surface_of({longer(bumpy_sphere(level)), bent(round.points)});
    I::Registration_features features; // the places of B that A came with
    for(double I::vec3::*coordinate : {&I::vec3::x, &I::vec3::y, &I::vec3::z}) {
      for(const I::vec3& p : b.point)
        features.a.push_back(30 * p.*coordinate);
      for(const I::vec3& p : b.point)
        features.b.push_back(30 * p.*coordinate);
      ++features.number;
    }
    I::Host_array<I::vec3> x = a.image;
    I::Monitor monitor;
    const I::Refinement_report report = I::refine(loop, a, b, features, {}, {0, 1, 50, 1e-4}, monitor, x);
    INFO("level " << level << ": " << report.iterations << " steps from " << report.energy_before << " to "
                  << report.energy);
    CHECK(report.has_converged);
    CHECK(report.iterations <= 15);
    CHECK(report.energy < report.energy_before);
  }
}

TEST_CASE("the figures are those of the map that is stored", "[registration]")
{
  namespace I = SP::internal;
  const Soup round = icosphere(4);
  const Mapped a(bumpy_sphere(4), round.points), b(longer(bumpy_sphere(4)), bent(round.points));
  SP::Registration method;
  method.levels = 2;
  method.iterations = 20;
  std::vector<SP::Landmark_pair<Mesh, Mesh>> landmarks;
  if(GENERATE(false, true))
    for(int i : {10, 500, 1000, 1500, 2000})
      landmarks.emplace_back(Vertex(unsigned(i)), Vertex(unsigned(i + 3)));
  const Registered r = registered(a, b, method, landmarks);
  check_certificate(a, r);
  const I::Registered_surface of_a = surface_of(a), of_b = surface_of(b);
  I::Monitor monitor(1e9, {}, false);
  const auto features = [&](const Mapped& m) { // solvers smooth them: their last digits depend on the order
    const I::Host_loop loop;
    const I::Valid_map map = valid_map_of(m);
    const I::Order_on_sphere order(loop, map.image);
    auto values = I::shape_features(loop, I::registered_surface(loop, order.ordered(loop, map)), {},
                                    method.coarsest_scale / 2, monitor);
    for(I::Host_array<double>& of_feature : values)
      of_feature = order.by_number(of_feature);
    return values;
  };
  const auto f = features(a), g = features(b);
  const SP::Spherical_locator<Mesh> locator(b.mesh, b.map());
  const std::size_t n = a.sphere.size();
  std::vector<Vector> place(n, Vector(0, 0, 0));
  std::vector<double> difference(n, 0), weight(n, 0);
  for(std::size_t i = 0; i < n; ++i) {
    const auto [face, share] = locator.locate(r.sphere[i]);
    const auto h = b.mesh.halfedge(face);
    const std::array<std::size_t, 3> corner = {b.mesh.source(h).idx(), b.mesh.target(h).idx(),
                                               b.mesh.target(b.mesh.next(h)).idx()};
    std::vector<double> value(f.size(), 0);
    for(std::size_t c = 0; c < 3; ++c) {
      const I::vec3 p = of_b.point[corner[c]];
      place[i] = place[i] + share[c] * Vector(p.x, p.y, p.z);
      for(std::size_t k = 0; k < f.size(); ++k)
        value[k] += share[c] * g[k][corner[c]];
    }
    for(std::size_t k = 0; k < f.size(); ++k)
      difference[i] += (k == 0 ? method.stretch_weight : method.curvature_weight) * std::pow(value[k] - f[k][i], 2);
  }
  double mismatch = 0, stretching = 0, surface = 0;
  for(const auto& t : a.soup.faces) {
    // the linear map between the triangles: in orthonormal frames of both the matrix to * from^-1
    const auto plane = [](const Vector& u, const Vector& v) { // u = (a, 0), v = (b, c)
      const double length = std::sqrt(u.squared_length()), along = u * v / length;
      return std::array<double, 3>{length, along, std::sqrt((std::max)(0., v.squared_length() - along * along))};
    };
    const auto from_point = [&](std::size_t k) {
      const I::vec3 p = of_a.point[t[k]];
      return Vector(p.x, p.y, p.z);
    };
    const auto [a1, b1, c1] = plane(from_point(1) - from_point(0), from_point(2) - from_point(0));
    const auto [a2, b2, c2] = plane(place[t[1]] - place[t[0]], place[t[2]] - place[t[0]]);
    const double m00 = a2 / a1, m01 = (b2 - m00 * b1) / c1, m11 = c2 / c1, det = m00 * m11;
    const double square_sum = m00 * m00 + m01 * m01 + m11 * m11;
    const double bounded = (std::max)(det, 0.2); // where triangles nearly fold the energy stays finite
    if(square_sum < 900)
      stretching += a1 * c1 / 2 * square_sum * (1 + 1 / (bounded * bounded));
    for(std::size_t i : t)
      mismatch += a1 * c1 / 6 * difference[i];
    surface += a1 * c1 / 2;
  }
  CHECK(surface == Approx(4 * std::acos(-1.)));
  CHECK(r.result.mismatch == Approx(std::sqrt(mismatch / surface)).epsilon(1e-6));
  CHECK(r.result.stretching == Approx(stretching / surface).epsilon(1e-6));
  CHECK(r.result.stretching > 4);
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
  for(double unit : {1e-170, 1e160}) { // of the masses
    std::map<Vertex, Point> same;
    const auto in_unit = [&](Vertex v) { return unit * mass.at(v); };
    CHECK(SP::moebius_centred_map(a.mesh, a.map(), Readable_map<Vertex, double>{in_unit},
                                  Writable_map<Vertex, Point>{&same}) < 1e-12);
  }
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
    return SP::register_maps(a.both(), b.both(), Read_write_map<Vertex, Point>{&out}, SP::Registration(),
                             std::vector<SP::Landmark_pair<Mesh, Mesh>>(), parameters);
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
  CHECK(fractions[fractions.size() / 2] < 0.9);
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
  const SP::Registration_result r =
    SP::register_maps(CGAL::Parallel_tag(), a.both(), b.both(), Read_write_map<Vertex, Point>{&on_several}, method);
  REQUIRE(r);
  CHECK(r.iterations >= 3);
  const Sphere on_one = registered(a, b, method).sphere;
  REQUIRE(on_several.size() == on_one.size());
  CHECK(std::all_of(on_several.begin(), on_several.end(),
                    [&](const auto& p) { return p.second == on_one[static_cast<std::size_t>(p.first.idx())]; }));
  CHECK(mean_distance(on_one, round.points) > 1e-3);
}
#endif
