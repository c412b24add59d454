// SPDX-License-Identifier: GPL-3.0-or-later
// The distortion of faces and stars, and steps of single vertices, alone.

#include "helpers/arrays.h"

#include <CGAL/Spherical_parameterization/internal/relaxation/Distortion.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Star.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Patch.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace test;

namespace {

/// Six faces round the point 0 of a plane, of a wobbly ring.
struct Flat_star {
  std::vector<std::array<double, 2>> ring;

  /// \param dent  by which every other radius is shortened: the kernel is then far smaller than the star
  explicit Flat_star(unsigned seed, double dent = 1)
  {
    Random random(seed);
    for(int k = 0; k < 6; ++k) {
      const double radius = random.number(0.7, 1.4) * (k % 2 == 1 ? dent : 1),
                   angle = (k + random.number(-0.3, 0.3)) * 1.0471975511965976;
      ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
  }

  I::Star on_sphere(vec3 centre, double size, double bend = 0) const
  {
    const I::Tangents at = I::tangents_at(centre);
    const auto place = [&](std::size_t k) {
      const auto& [s, t] = ring[k % 6];
      return I::unit(I::add(centre, at.combined({size * (s + bend * t * t), size * (t - bend * s)})));
    };
    const auto source = [&](std::size_t k) { return vec3{ring[k % 6][0], ring[k % 6][1], 0}; };
    I::Star star;
    for(std::size_t k = 0; k < 6; ++k)
      star.emplace_back(place(k), place(k + 1),
                        I::face_metric({0, 0, 0}, source(k), source(k + 1), I::Metric_bounds{1e6, 1e-30}), size * size);
    return star;
  }
};

} // namespace

TEST_CASE("the distortion is 4 for isometries and more for all else, and its derivatives are its own", "[star]")
{
  for(double theta : {0., 0.5, 1., 1.7, 3.}) {
    CAPTURE(theta);
    const I::Distortion distortion(theta);
    // D = (s^2 + t^2) psi(s t)
    CHECK(2 * distortion.value(1) == Approx(4));
    for(double s : {0.3, 0.9, 1., 1.4, 5.})
      for(double t : {0.2, 1., 1.1, 3.}) {
        const double angle = (s * s + t * t) / (2 * s * t), area = (s * t + 1 / (s * t)) / 2;
        CHECK((s * s + t * t) * distortion.value(s * t) == Approx(4 * angle * std::pow(area, theta)));
      }
    for(double ratio : {0.1, 0.7, 1., 2., 9.}) {
      const auto psi = distortion.psi(ratio);
      const double h = 1e-5 * ratio;
      CHECK(psi.value == Approx(distortion.value(ratio)));
      const auto ahead = distortion.psi(ratio + h), behind = distortion.psi(ratio - h);
      CHECK(psi.first == Approx((ahead.value - behind.value) / (2 * h)).epsilon(1e-6).margin(1e-8));
      CHECK(psi.second == Approx((ahead.first - behind.first) / (2 * h)).epsilon(1e-6).margin(1e-8));
    }
    CHECK(distortion.with_share_of_area(0.5).value(2) == I::Distortion(theta / 2).value(2));
  }
}

TEST_CASE("the untangling energy is finite beyond a flip, and its derivatives are its own", "[star]")
{
  const double e = 0.3;
  const I::Untangling_energy energy(e);
  double previous = std::numeric_limits<double>::infinity();
  for(double ratio : {-20., -3., -0.5, -0.01, 0., 0.01, 0.5, 2.}) {
    const auto psi = energy.psi(ratio), phi = energy.phi(ratio, psi);
    const double chi = (ratio + std::sqrt(e * e + ratio * ratio)) / 2;
    CHECK(psi.value == Approx(1 / chi).epsilon(1e-9));
    CHECK(psi.value < previous); // the less flipped the better
    previous = psi.value;
    const double h = 1e-6;
    const auto psi_ahead = energy.psi(ratio + h), psi_behind = energy.psi(ratio - h);
    CHECK(psi.first == Approx((psi_ahead.value - psi_behind.value) / (2 * h)).epsilon(1e-5));
    CHECK(psi.second == Approx((psi_ahead.first - psi_behind.first) / (2 * h)).epsilon(1e-4).margin(1e-4));
    const auto ahead = energy.phi(ratio + h, psi_ahead), behind = energy.phi(ratio - h, psi_behind);
    CHECK(phi.first == Approx((ahead.value - behind.value) / (2 * h)).epsilon(1e-4).margin(1e-6));
    CHECK(phi.second == Approx((ahead.first - behind.first) / (2 * h)).epsilon(1e-4).margin(1e-3));
  }
}

TEST_CASE("the metric of a triangle: cotangents and area; bad ones are improved, and no more than that", "[star]")
{
  Random random;
  for(int trial = 0; trial < 200; ++trial) {
    const vec3 a = random.vector(), b = random.vector(), c = I::sub(b, a);
    const I::Face_metric metric = I::face_metric({0, 0, 0}, a, b, {1e6, 1e-30});
    const double twice_area = I::norm(I::outer(a, b));
    CHECK(metric.twice_area == Approx(twice_area).epsilon(1e-6));
    CHECK(metric.cotangent[0] == Approx(I::inner(a, b) / twice_area).epsilon(1e-6).margin(1e-9));
    CHECK(metric.cotangent[1] == Approx(-I::inner(a, c) / twice_area).epsilon(1e-6).margin(1e-9));
    CHECK(metric.cotangent[2] == Approx(I::inner(b, c) / twice_area).epsilon(1e-6).margin(1e-9));
  }
  const auto check_angles = [](const I::Face_metric& m) { // of a triangle: their sum is pi
    const auto& [x, y, z] = m.cotangent;
    CHECK(x * y + y * z + z * x == Approx(1));
  };
  const I::Metric_bounds bounds = {10, 1e-3};
  for(double height : {0.5, 0.05, 1e-3, 0.}) {
    const I::Face_metric needle = I::face_metric({0, 0, 0}, {1, 0, 0}, {0.3, height, 0}, bounds);
    check_angles(needle);
    CHECK(needle.twice_area >= height * (1 - 1e-12));
    const double least = 0.8660254 / 10; // of the sides 1: at most ten times as long as wide
    CHECK(needle.twice_area >= 0.5 * least);
    CHECK(needle.twice_area <= std::max(height, 2 * least) * (1 + 1e-9));
  }
  const I::Face_metric point = I::face_metric({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, bounds);
  check_angles(point);
  CHECK(point.twice_area == Approx(2 * bounds.area));
  CHECK(I::face_metric({0, 0, 0}, {1e-3, 0, 0}, {0, 1e-3, 0}, bounds).twice_area == Approx(2 * bounds.area));
}

TEST_CASE("tangents are orthonormal and right-handed, at the poles, too", "[star]")
{
  Random random;
  for(int trial = 0; trial < 100; ++trial) {
    const vec3 x = trial == 0 ? vec3{0, 0, 1} : trial == 1 ? vec3{0, 0, -1} : random.unit_vector();
    const I::Tangents at = I::tangents_at(x);
    CHECK(I::norm(at.s) == Approx(1));
    CHECK(std::abs(I::inner(at.s, x)) < 1e-15);
    CHECK(I::norm(I::sub(I::outer(at.s, at.t), x)) < 1e-14);
  }
}

TEST_CASE("an isometric star has energy 4 per area of its source, and no trial is called valid that is not", "[star]")
{
  const vec3 centre = I::unit({0.2, -0.3, 0.9});
  for(double theta : {0., 1., 2.}) {
    const I::Distortion distortion(theta);
    const double size = 1e-3;
    const I::Star star = Flat_star(3).on_sphere(centre, size);
    double area = 0;
    for(const I::Star_face& f : star)
      area += f.twice_area / 2;
    CHECK(I::Star_trial(distortion, star, centre).energy == Approx(4 * area).epsilon(1e-3));
    CHECK(I::is_valid_centre(star, centre));
    for(double away : {0.5, 1.5, 3.}) {
      const vec3 x = I::unit(I::add(centre, I::tangents_at(centre).combined({size * away, 0})));
      const I::Star_trial trial(distortion, star, x);
      CHECK(I::is_valid_trial(trial, star, x) == I::is_valid_centre(star, x));
      CHECK(std::isfinite(I::Star_trial(distortion, star, x).energy) == I::is_valid_centre(star, x));
    }
  }
}

TEST_CASE("a step lowers the energy by what it says; the last one is at a minimum", "[star]")
{
  const vec3 centre = I::unit({0.2, -0.3, -0.9});
  for(double theta : {0., 1., 1.6})
    for(double size : {0.3, 1e-2, 1e-6}) {
      CAPTURE(theta, size);
      const I::Distortion distortion(theta);
      const I::Star star = Flat_star(5).on_sphere(centre, size, 0.3);
      const I::Tangents at = I::tangents_at(centre);
      vec3 x = I::unit(I::add(centre, at.combined({0.3 * size, -0.25 * size})));
      REQUIRE(I::is_valid_centre(star, x));
      double before = I::Star_trial(distortion, star, x).energy, energy = 0;
      int steps = 0;
      for(;; ++steps) {
        const double gain = I::relax_centre(distortion, star, x, energy);
        CHECK(energy == Approx(I::Star_trial(distortion, star, x).energy).epsilon(1e-9));
        CHECK(gain == Approx(before - energy).margin(1e-9 * before));
        CHECK(I::is_valid_centre(star, x));
        before = energy;
        if(gain <= 1e-12 * energy)
          break;
        REQUIRE(steps < 30);
      }
      CHECK(steps <= 8); // Newton's method
      for(int k = 0; k < 12; ++k) {
        const I::Planar away = {1e-3 * size * std::cos(k), 1e-3 * size * std::sin(k)};
        CHECK(I::Star_trial(distortion, star, I::unit(I::add(x, I::tangents_at(x).combined(away)))).energy >=
              energy * (1 - 1e-12));
      }
    }
}

TEST_CASE("near its minimum a step squares the distance, on a star that is no plane, too", "[star]")
{
  const vec3 centre = I::unit({0.2, -0.3, -0.9});
  for(double theta : {0., 1.})
    for(double size : {0.8, 0.3}) {
      CAPTURE(theta, size);
      const I::Distortion distortion(theta);
      const I::Star star = Flat_star(5).on_sphere(centre, size, 0.2);
      vec3 minimum = centre;
      double energy = 0;
      for(int steps = 0; steps < 20; ++steps)
        I::relax_centre(distortion, star, minimum, energy);
      const double away = 1e-3 * size;
      for(int k = 0; k < 6; ++k) {
        const I::Planar step = {away * std::cos(k), away * std::sin(k)};
        vec3 x = I::unit(I::add(minimum, I::tangents_at(minimum).combined(step)));
        I::relax_centre(distortion, star, x, energy);
        CHECK(I::norm(I::sub(x, minimum)) < 0.02 * away);
      }
    }
}

TEST_CASE("solve_positive: Newton's direction where that descends, and always a descent", "[star]")
{
  Random random;
  for(int trial = 0; trial < 500; ++trial) {
    const double a = random.number(), b = random.number(), c = random.number();
    const I::Planar g = {random.number(), random.number()};
    const I::Planar step = I::solve_positive(a, b, c, g);
    CHECK(I::inner(step, g) < 0);
    if(a > 0 && a * c - b * b > 0.01) {
      CHECK(a * step.s + b * step.t == Approx(-g.s).margin(1e-9));
      CHECK(b * step.s + c * step.t == Approx(-g.t).margin(1e-9));
    } else if(a * c - b * b < -0.05) { // |H|^2 = H^2
      const I::Planar h = {a * step.s + b * step.t, b * step.s + c * step.t};
      CHECK(I::inner(h, h) == Approx(I::inner(g, g)));
    }
  }
}

TEST_CASE("the kernel point of a dented star sees its whole ring", "[star]")
{
  const vec3 at = I::unit({-0.4, 0.1, 0.6});
  for(double size : {0.5, 1e-3, 1e-9})
    for(unsigned seed = 1; seed < 50; ++seed) {
      const I::Star star = Flat_star(seed, 0.25).on_sphere(at, size);
      REQUIRE(I::is_valid_centre(star, at));
      CHECK(I::is_valid_centre(star, I::kernel_point(star, at)));
    }
}

TEST_CASE("a vertex is inserted where it sees its ring, from a centre on the border of the kernel", "[star]")
{
  const vec3 at = I::unit({-0.4, 0.1, 0.6});
  for(double size : {0.5, 1e-3, 1e-9})
    for(unsigned seed = 1; seed < 20; ++seed) {
      I::Star star = Flat_star(seed).on_sphere(at, size);
      const vec3 corner = star[0].j; // the vertex that the new one was collapsed into: a corner of the ring
      const vec3 inside = I::kernel_point(star, corner);
      CHECK(I::norm(I::sub(inside, at)) < 4 * size);
      vec3 x = {0, 0, 0};
      REQUIRE(I::insert_vertex(I::Distortion(1), star, corner, 6, x));
      CHECK(I::is_valid_centre(star, x));
      CHECK(I::norm(x) == Approx(1));
      double area = 0;
      for(const I::Star_face& f : star)
        area += f.twice_area / 2;
      CHECK(I::Star_trial(I::Distortion(1), star, x).energy < 6 * area);
    }
}
