// SPDX-License-Identifier: GPL-3.0-or-later
// Orientation, areas, degree and certificate alone: against integers, and on maps made by hand.

#include "helpers/arrays.h"

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>

using namespace test;

namespace {

typedef std::array<std::int64_t, 3> Integers;

__extension__ typedef __int128 Large_integer;

/// \pre below 2^40
Large_integer determinant(const Integers& a, const Integers& b, const Integers& c)
{
  Large_integer sum = 0;
  for(int k = 0; k < 3; ++k) {
    const int m = (k + 1) % 3, n = (k + 2) % 3;
    sum += a[k] * (static_cast<Large_integer>(b[m]) * c[n] - static_cast<Large_integer>(b[n]) * c[m]);
  }
  return sum;
}

vec3 scaled(const Integers& a, int exponent)
{
  return {std::ldexp(double(a[0]), exponent), std::ldexp(double(a[1]), exponent), std::ldexp(double(a[2]), exponent)};
}

I::Certificate certify(const Plain_mesh& mesh) { return I::certify(I::Host_loop(), mesh.face, mesh.point); }

/// (r, phi, z) -> (r, k phi, z)
Plain_mesh wound(Plain_mesh mesh, int k)
{
  for(vec3& p : mesh.point) {
    const double r = std::hypot(p.x, p.y), angle = k * std::atan2(p.y, p.x);
    p = {r * std::cos(angle), r * std::sin(angle), p.z};
  }
  return mesh;
}

} // namespace

TEST_CASE("orientation is the sign of the determinant, however small that is", "[predicates]")
{
  Random random;
  const auto integer = [&](double bound) { return static_cast<std::int64_t>(random.number(-bound, bound)); };
  std::array<int, 3> count = {0, 0, 0};
  for(int trial = 0; trial < 20000; ++trial) {
    const double bound = trial % 2 ? 1e11 : 30;
    Integers a, b, c;
    for(int k = 0; k < 3; ++k) {
      a[k] = integer(bound);
      b[k] = integer(bound);
    }
    const std::int64_t s = integer(4), t = integer(4);
    for(int k = 0; k < 3; ++k) // near the plane of a and b
      c[k] = s * a[k] + t * b[k] + (trial % 3 == 0 ? 0 : integer(1.99));
    const Large_integer exact = determinant(a, b, c);
    const int expected = (exact > 0) - (exact < 0);
    ++count[expected + 1];
    // a power of two each does not change the sign, nor does an even permutation
    const vec3 p = scaled(a, -37), q = scaled(b, -40 + trial % 7), r = scaled(c, -38);
    const double value = std::ldexp(static_cast<double>(exact), -37 - 40 + trial % 7 - 38);
    CHECK(std::abs(I::accurate_determinant(p, q, r) - value) <= 1e-6 * std::abs(value));
    CHECK(std::abs(I::exact_determinant(p, q, r) - value) <= 1e-15 * std::abs(value));
    CAPTURE(trial, expected);
    CHECK(I::orientation(p, q, r) == expected);
    CHECK(I::orientation(q, r, p) == expected);
    CHECK(I::orientation(q, p, r) == -expected);
    CHECK(I::sign_of_exact_determinant(p, q, r) == expected);
    CHECK(I::is_positively_oriented(p, q, r) == (expected > 0));
  }
  CHECK((count[0] > 1000 && count[1] > 1000 && count[2] > 1000));
}

TEST_CASE("determinants of what is not finite are not finite", "[predicates]")
{
  const double infinity = std::numeric_limits<double>::infinity();
  for(const double x : {infinity, -infinity, std::nan("")})
    CHECK_FALSE(std::isfinite(I::accurate_determinant({.5, .5, .7}, {x, 1, 1}, {0, 1, -1})));
}

TEST_CASE("the exact determinant is that of Boost's integers, for doubles of any size", "[predicates]")
{
  typedef boost::multiprecision::cpp_int Integer;
  const auto integer = [](double x) { // x * 2^1074
    int exponent;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const int shift = exponent - 53 + 1074;
    return Integer(shift < 0 ? Integer(mantissa) / (Integer(1) << -shift) : Integer(mantissa) << shift);
  };
  const auto expected_sign = [&](vec3 a, vec3 b, vec3 c) {
    const auto minor = [&](double p, double q, double r, double s) {
      return Integer(integer(p) * integer(s) - integer(q) * integer(r));
    };
    return Integer(integer(a.x) * minor(b.y, b.z, c.y, c.z) + integer(a.y) * minor(b.z, b.x, c.z, c.x) +
                   integer(a.z) * minor(b.x, b.y, c.x, c.y))
      .sign();
  };
  Random random;
  const double largest = (std::numeric_limits<double>::max)();
  std::array<int, 3> count = {0, 0, 0};
  for(int trial = 0; trial < 2000; ++trial) {
    const auto number = [&]() -> double {
      switch(trial % 4) {
      case 0: return random.number(-1, 1);
      case 1: return std::ldexp(random.number(-1, 1), static_cast<int>(random.number(-1074, 1024)));
      case 2: return std::floor(random.number(-4, 4)) * std::numeric_limits<double>::denorm_min();
      default: return random.number(-1, 1) > 0 ? largest : -largest;
      }
    };
    const vec3 a = {number(), number(), number()}, b = {number(), number(), number()};
    vec3 c = trial % 3 == 0 ? I::scale(-0.5, a) : vec3{number(), number(), number()};
    if(trial % 6 == 0)
      c.y = std::nextafter(c.y, 0);
    const int expected = expected_sign(a, b, c);
    ++count[expected + 1];
    CAPTURE(trial, expected);
    for(const int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
      std::fesetround(mode);
      const int sign = I::sign_of_exact_determinant(a, b, c), opposite = I::sign_of_exact_determinant(b, a, c);
      std::fesetround(FE_TONEAREST);
      CHECK(sign == expected);
      CHECK(opposite == -expected);
    }
  }
  CHECK((count[0] > 300 && count[1] > 300 && count[2] > 300));
}

TEST_CASE("orientation does not underflow", "[predicates]")
{
  const double least = std::numeric_limits<double>::denorm_min();
  CHECK(I::orientation({1, 0, 0}, {0, least, 0}, {0, 0, least}) == 1);
  CHECK(I::orientation({least, 0, 0}, {0, 0, least}, {0, least, 0}) == -1);
  CHECK(I::orientation({1, 0, 0}, {1, least, 0}, {1, 0, least}) == 1);
  CHECK(I::orientation({1, 0, 0}, {1, least, 0}, {1, 2 * least, 0}) == 0);
}

TEST_CASE("exact barycentric coordinates lead back to the direction, however small the triangle", "[predicates]")
{
  Random random;
  for(double size : {1., 1e-6, 1e-12}) {
    for(int trial = 0; trial < 200; ++trial) {
      const vec3 at = random.unit_vector();
      const std::array<vec3, 3> v = {I::unit(I::add_scaled(at, size, random.vector())),
                                     I::unit(I::add_scaled(at, size, random.vector())),
                                     I::unit(I::add_scaled(at, size, random.vector()))};
      if(!I::is_positively_oriented(v[0], v[1], v[2]))
        continue;
      const vec3 q = I::add(I::add_scaled(I::scale(0.2, v[0]), 0.3, v[1]), I::scale(0.5, v[2]));
      const std::array<double, 3> w = I::exact_barycentric_coordinates(v, q);
      CHECK(w[0] + w[1] + w[2] == Approx(1).epsilon(1e-15));
      vec3 p = {0, 0, 0};
      for(int k = 0; k < 3; ++k)
        p = I::add_scaled(p, w[k], v[k]);
      CHECK(I::norm(I::sub(I::unit(p), I::unit(q))) < 1e-15);
      if(size == 1) {
        CHECK(w[0] == Approx(0.2));
        CHECK(w[1] == Approx(0.3));
      }
    }
  }
  // beyond a side its corner does not count
  const std::array<vec3, 3> octant = {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}};
  CHECK(I::exact_barycentric_coordinates(octant, {3, 5, -2}) == std::array<double, 3>{0.5, 5. / 6, 0});
}

TEST_CASE("spherical areas add up, up to half the sphere and down to rounding", "[predicates]")
{
  CHECK(I::spherical_area({1, 0, 0}, {0, 1, 0}, {0, 0, 1}) == Approx(I::pi / 2));
  CHECK(I::spherical_area({0, 1, 0}, {1, 0, 0}, {0, 0, 1}) == Approx(-I::pi / 2));
  // the triangle of three directions just above the equator is the northern half, but for a bit
  const auto above = [](double angle) { return I::unit({std::cos(angle), std::sin(angle), 1e-4}); };
  CHECK(I::spherical_area(above(0), above(2), above(4)) == Approx(2 * I::pi).epsilon(1e-3));
  Random random;
  for(double size : {2., 0.1, 0.04, 1e-3, 1e-7}) // on both sides of where the series begins
    for(int trial = 0; trial < 50; ++trial) {
      const vec3 at = random.unit_vector();
      const auto corner = [&] { return I::unit(I::add_scaled(at, size / 2, random.vector())); };
      const vec3 a = corner(), b = corner(), c = corner(), d = I::unit(I::add(a, I::add(b, c)));
      const double whole = I::spherical_area(a, b, c);
      const double parts = I::spherical_area(a, b, d) + I::spherical_area(b, c, d) + I::spherical_area(c, a, d);
      CHECK(whole == Approx(parts).epsilon(1e-9).margin(1e-10 * size * size));
      const double flat = I::inner(at, I::outer(I::sub(b, a), I::sub(c, a))) / 2;
      if(size < 0.01)
        CHECK(whole == Approx(flat).epsilon(0.01).margin(1e-10 * size * size));
    }
  double sum = 0;
  const Plain_mesh sphere = octasphere(3);
  for(const auto& [i, j, k] : sphere.face)
    sum += I::spherical_area(sphere.point[i], sphere.point[j], sphere.point[k]);
  CHECK(sum == Approx(4 * I::pi));
}

TEST_CASE("a certificate counts flips and coverings, and asks for both", "[predicates]")
{
  const Plain_mesh sphere = octasphere(3);
  const I::Certificate good = certify(sphere);
  CHECK((good.flipped_faces == 0 && good.degree == 1 && good.is_valid()));
  double area = 4, edge = 4;
  for(const std::array<int, 3>& f : sphere.face) {
    area = std::min(area, I::spherical_area(sphere.point[f[0]], sphere.point[f[1]], sphere.point[f[2]]));
    for(int k = 0; k < 3; ++k)
      edge = std::min(edge, I::norm(I::sub(sphere.point[f[k]], sphere.point[f[(k + 1) % 3]])));
  }
  CHECK(good.smallest_area == Approx(area));
  CHECK(good.smallest_edge == Approx(edge));

  Plain_mesh mirrored = sphere;
  for(vec3& p : mirrored.point)
    p.x = -p.x;
  const I::Certificate bad = certify(mirrored);
  CHECK((bad.flipped_faces == sphere.face.size() && bad.degree == -1 && !bad.is_valid()));
  CHECK(bad.smallest_area == Approx(area));

  Plain_mesh folded = sphere; // a vertex beyond its ring: flips do not change the degree
  folded.point[7] = I::unit(I::add_scaled(folded.point[7], 0.5, I::sub(folded.point[0], folded.point[7])));
  folded.point[7] = I::scale(-1, folded.point[7]);
  const I::Certificate flipped = certify(folded);
  CHECK((flipped.flipped_faces > 0 && !flipped.is_valid()));

  Plain_mesh unknown = sphere;
  unknown.point[7].y = std::numeric_limits<double>::quiet_NaN();
  CHECK(certify(unknown).flipped_faces == 6);
  CHECK_FALSE(certify(unknown).is_valid());

  Plain_mesh point = sphere;
  std::fill(point.point.begin(), point.point.end(), vec3{0, 0, 1});
  CHECK((certify(point).degree == 0 && certify(point).flipped_faces == sphere.face.size()));
}

TEST_CASE("without a flipped face, but twice round the axis: degree 2, and not valid", "[predicates]")
{
  // a double cover branched at the poles: a cone of eight faces over twice round, and its mirror image below
  const int k = GENERATE(2, 3);
  Plain_mesh cover;
  const int sides = 5 * k;
  for(int i = 0; i < sides; ++i) {
    const double angle = 2 * I::pi * i * k / sides;
    cover.point.push_back({std::cos(angle), std::sin(angle), 0});
  }
  cover.point.push_back({0, 0, 1});
  cover.point.push_back({0, 0, -1});
  for(int i = 0; i < sides; ++i) {
    const int next = (i + 1) % sides;
    cover.face.push_back({i, next, sides});
    cover.face.push_back({next, i, sides + 1});
  }
  const I::Certificate certificate = certify(cover);
  CHECK(certificate.flipped_faces == 0);
  CHECK(certificate.degree == k);
  CHECK_FALSE(certificate.is_valid());
  CHECK(certify(wound(octasphere(4), k)).degree == k);
  CHECK(certify(wound(octasphere(4), -k)).degree == -k);
}

TEST_CASE("degrees are counted where no border is", "[predicates]")
{
  // a face with a corner, or a side, in the first directions that are tried
  for(int tried = 0; tried < 3; ++tried) {
    Plain_mesh sphere = octasphere(1);
    const vec3 direction = I::unit(I::direction_of_degree(tried));
    const vec3 x = I::unit(I::tangent({0, 0, 1}, direction)), y = I::outer(direction, x);
    for(vec3& p : sphere.point)
      p = I::add(I::add(I::scale(p.x, x), I::scale(p.y, y)), I::scale(p.z, direction));
    sphere.point[4] = direction; // to the last bit
    CHECK(certify(sphere).degree == 1);
  }
  const vec3 q = I::direction_of_degree(0);
  const vec3 a = {1, 0, 0}, b = {0, 1, 0}, c = {0, 0, 1};
  CHECK(I::covering(a, b, c, q) == 1);
  CHECK(I::covering(b, a, c, q) == -1);
  CHECK(I::covering(a, b, c, I::scale(-1, q)) == 0);
  CHECK(I::covering(a, b, I::scale(-1, c), q) == 0);
  CHECK(I::covering(a, b, c, {1, 1, 0}) == I::on_border);
  CHECK(I::covering(a, b, c, a) == I::on_border);
  CHECK(I::covering(a, b, c, {1, -1, 0}) == 0);
}
