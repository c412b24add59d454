// SPDX-License-Identifier: GPL-3.0-or-later
// The formulas of the verbs, against finite differences and against what they are for.

#include "helpers/arrays.h"

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/moebius/moebius.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

using namespace test;

namespace {

typedef I::Host_backend<I::Host_loop> Host;

struct Bench {
  Host host{I::Host_loop()};
  Plain_mesh mesh = octasphere(2);
  int n = int(mesh.point.size());
  std::shared_ptr<I::Weighted_graph> graph = std::make_shared<I::Weighted_graph>();
  I::Shared_graph a = graph;
  Positions v{mesh.point}, d{mesh.point};
  I::Host_array<double> mass;

  Bench()
  {
    Random random;
    const auto neighbours = mesh.neighbours();
    for(int i = 0; i < n; ++i) {
      for(int j : neighbours[i]) {
        graph->target.push_back(j);
        graph->weight.push_back(1.2 + std::sin(i + j));
      }
      graph->offset.push_back(int(graph->target.size()));
      mass.push_back(random.number(0.5, 2));
      v[i] = I::unit(I::add_scaled(v[i], 0.2, random.vector()));
      d[i] = I::tangent(random.vector(), v[i]);
    }
    graph->update_diagonal({});
  }

  /// Along the geodesics that leave v with the velocities d
  Positions moved(double t) const
  {
    Positions w = v;
    for(int i = 0; i < n; ++i) {
      const double angle = t * I::norm(d[i]);
      w[i] = I::add_scaled(I::scale(std::cos(angle), v[i]), std::sin(angle) / I::norm(d[i]), d[i]);
    }
    return w;
  }

  /// 1/p sum w |v_i - v_j|^p
  double energy(double p, const Positions& w) const
  {
    double sum = 0;
    for(int i = 0; i < n; ++i)
      for(int k = graph->offset[i]; k < graph->offset[i + 1]; ++k)
        sum += graph->weight[k] * std::pow(I::norm(I::sub(w[i], w[graph->target[k]])), p) / 2;
    return sum / p;
  }

  vec3 centroid(const Positions& w) const
  {
    vec3 sum = {0, 0, 0};
    for(int i = 0; i < n; ++i)
      sum = I::add_scaled(sum, mass[i], w[i]);
    return sum;
  }
};

} // namespace

TEST_CASE("gradient and curvature are the derivatives of the spring energy along geodesics", "[formulas]")
{
  Bench t;
  const double p = GENERATE(2., 2.5, 3., 4.2);
  CAPTURE(p);
  const vec3 mu = {0.3, -0.2, 0.5};
  Positions g = t.host.vectors(t.n);
  I::Host_array<double> density = t.host.scalars(t.n);
  const auto sums = t.host.gradient(t.a, p, t.v, g, density);
  CHECK(sums[0] / p == Approx(t.energy(p, t.v)));
  vec3 total = {0, 0, 0};
  double slope = 0;
  for(int i = 0; i < t.n; ++i) {
    total = I::add(total, g[i]);
    slope += I::inner(g[i], t.d[i]);
    CHECK(std::abs(I::inner(g[i], t.v[i])) < 1e-13);
  }
  CHECK(sums[1] == Approx(total.x));
  CHECK(sums[2] == Approx(total.y));
  CHECK(sums[3] == Approx(total.z));
  if(p == 2)
    CHECK(t.host.energy(t.a, t.v) == Approx(t.energy(2, t.v)));

  const double h = 1e-4;
  const auto lagrangian = [&](double s) { return t.energy(p, t.moved(s)) - I::inner(mu, t.centroid(t.moved(s))); };
  CHECK(slope == Approx((t.energy(p, t.moved(h)) - t.energy(p, t.moved(-h))) / (2 * h)).epsilon(1e-6));
  auto d = t.host.steps(t.n);
  for(int i = 0; i < t.n; ++i)
    d[i] = I::to_float4(t.d[i]);
  const auto curvature = t.host.curvature(t.a, p, t.mass, mu, t.v, d, density);
  const double expected = (lagrangian(h) - 2 * lagrangian(0) + lagrangian(-h)) / (h * h);
  CHECK(curvature[0] == Approx(expected).epsilon(1e-5));
  vec3 push = {0, 0, 0};
  double squares = 0;
  for(int i = 0; i < t.n; ++i) {
    squares += t.mass[i] * I::inner(t.d[i], t.d[i]);
    push = I::add_scaled(push, t.mass[i] * I::inner(t.d[i], t.d[i]), t.v[i]);
  }
  CHECK(curvature[1] == Approx(squares));
  CHECK(curvature[2] == Approx(push.x));
  CHECK(curvature[4] == Approx(push.z));
}

TEST_CASE("a boost keeps spheres, angles and orientation, and is x - 2 P_x c to first order", "[formulas]")
{
  Random random;
  for(int trial = 0; trial < 100; ++trial) {
    const vec3 c = I::scale(random.number(0, 0.8), random.unit_vector()), x = random.unit_vector();
    CHECK(I::norm(I::boost(x, c)) == Approx(1));
    CHECK(I::norm(I::sub(I::boost(I::boost(x, c), I::scale(-1, c)), x)) < 1e-13);
    // conformal: small tangents keep their ratio and their angle
    const vec3 s = I::unit(I::tangent(random.vector(), x)), t = I::outer(x, s);
    const double h = 1e-6;
    const auto image = [&](vec3 at) { return I::boost(I::unit(I::add_scaled(x, h, at)), c); };
    const vec3 here = I::boost(x, c), a = I::sub(image(s), here), b = I::sub(image(t), here);
    CHECK(I::norm(a) == Approx(I::norm(b)).epsilon(1e-4));
    CHECK(std::abs(I::inner(a, b)) < 1e-4 * I::inner(a, a));
    CHECK(I::inner(here, I::outer(a, b)) > 0);
    const vec3 small = I::scale(1e-6, c);
    CHECK(I::norm(I::sub(I::boost(x, small), I::add_scaled(x, -2, I::tangent(small, x)))) < 1e-11);
  }
}

TEST_CASE("moments, balance and tilt bring the centroid to the centre", "[formulas]")
{
  Bench t;
  const I::Moments moments = t.host.moments(t.mass, t.v);
  const vec3 centroid = t.centroid(t.v);
  CHECK(I::norm(I::sub(I::first_moment(moments), centroid)) < 1e-12);
  double total = 0;
  for(double m : t.mass)
    total += m;
  CHECK(I::total_mass(moments) == Approx(total));
  // the motion of the centroid under a small boost
  const vec3 c = {1e-6, -2e-6, 3e-6};
  Positions w = t.host.vectors(t.n);
  const I::Moments after = t.host.transform(t.mass, c, t.v, w);
  const vec3 back = I::solve(I::boost_matrix(moments), I::sub(I::first_moment(moments), I::first_moment(after)));
  CHECK(I::norm(I::sub(I::scale(0.5, back), c)) < 1e-11);

  I::Host_array<double> tilted = t.host.scalars(t.n);
  const I::Moments balanced = t.host.tilt_masses(t.mass, I::balancing_tilt(moments), t.v, tilted);
  CHECK(I::norm(I::first_moment(balanced)) < 1e-10 * total);

  Positions v = t.v;
  for(vec3& p : v) // far off
    p = I::boost(p, {0.5, 0.6, -0.2});
  I::centre(t.host, t.mass, 1e-12, v, w);
  CHECK(I::norm(t.centroid(v)) < 1e-11 * total);
}

TEST_CASE("Moebius transformations are found from the points that they move, three or more", "[formulas]")
{
  Random random;
  for(int count : {3, 4, 10}) {
    Positions from, to;
    const vec3 c = {0.3, -0.2, 0.4};
    const I::Matrix_3 rotation = I::rotation_about({1, 2, 0.5});
    const auto moved = [&](vec3 p) { return I::rotated(rotation, I::boost(p, c)); };
    for(int k = 0; k < count; ++k) {
      from.push_back(random.unit_vector());
      to.push_back(moved(from.back()));
    }
    const I::Moebius_alignment align(from, to);
    for(int k = 0; k < 10; ++k) {
      const vec3 p = random.unit_vector();
      CHECK(I::norm(I::sub(align(p), moved(p))) < 1e-8);
    }
  }
}

TEST_CASE("smoothing steps and residuals belong to one matrix", "[formulas]")
{
  Bench t;
  for(int i = 0; i < t.n; ++i)
    t.graph->excess.push_back(0.1 + 0.01 * i);
  t.graph->update_diagonal({});
  Positions x = t.v, b = t.d, y = t.host.vectors(t.n), r = y, ax = y, zero = y;
  const double product = t.host.multiply(t.a, x, ax);
  CHECK(product == Approx(t.host.dot(x, ax)));
  t.host.residual(t.a, b, x, r);
  t.host.smooth(t.a, 0.7, b, x, y);
  Positions start = zero, from_zero = zero;
  t.host.start_smoothing(t.a, 0.7, b, start);
  t.host.smooth(t.a, 0.7, b, zero, from_zero);
  for(int i = 0; i < t.n; ++i) {
    double sum = t.graph->excess[i];
    for(int k = t.graph->offset[i]; k < t.graph->offset[i + 1]; ++k)
      sum += t.graph->weight[k];
    vec3 expected = I::scale(sum, x[i]);
    for(int k = t.graph->offset[i]; k < t.graph->offset[i + 1]; ++k)
      expected = I::add_scaled(expected, -t.graph->weight[k], x[t.graph->target[k]]);
    CHECK(I::norm(I::sub(ax[i], expected)) < 1e-12);
    CHECK(I::norm(I::sub(r[i], I::sub(b[i], ax[i]))) < 1e-12);
    CHECK(I::norm(I::sub(y[i], I::add_scaled(x[i], 0.7 / sum, r[i]))) < 1e-12);
    CHECK(I::norm(I::sub(start[i], from_zero[i])) < 1e-14);
  }
}

TEST_CASE("smoothing steps and residuals in floats are those in doubles, over the diagonal", "[formulas]")
{
  Bench t;
  for(int i = 0; i < t.n; ++i)
    t.graph->excess.push_back(0.1 + 0.01 * i);
  t.graph->update_diagonal({});
  const auto smoother = std::make_shared<const I::Weighted_smoother>(t.host.host_loop(), t.a);
  Positions r = t.host.vectors(t.n), y = r, start = r, second = r;
  t.host.residual(t.a, t.d, t.v, r);
  t.host.smooth(t.a, 0.7, t.d, t.v, y);
  t.host.start_smoothing(t.a, 0.7, t.d, start);
  t.host.smooth(t.a, 0.4, t.d, start, second);
  auto b = t.host.steps(t.n), x = t.host.steps(t.n), float_r = t.host.steps(t.n), float_y = t.host.steps(t.n),
       float_second = t.host.steps(t.n);
  for(int i = 0; i < t.n; ++i) {
    b[i] = I::to_float4(I::scale(t.graph->inverse_diagonal[i], t.d[i]));
    x[i] = I::to_float4(t.v[i]);
  }
  t.host.residual(smoother, b, x, float_r);
  t.host.smooth(smoother, 0.7, b, x, float_y);
  t.host.start_smoothing(smoother, 0.7, 0.4, b, float_second);
  const auto distance = [](const I::float4& p, vec3 q) { return I::norm(I::sub(I::to_vec3(p), q)); };
  constexpr double rounding = 1e-6;
  for(int i = 0; i < t.n; ++i) {
    CHECK(distance(float_r[i], I::scale(t.graph->inverse_diagonal[i], r[i])) < rounding);
    CHECK(distance(float_y[i], y[i]) < rounding);
    CHECK(distance(float_second[i], second[i]) < rounding);
  }
}

TEST_CASE("a sweep of the published method keeps its planes, and its residual vanishes where it stands", "[formulas]")
{
  Bench t;
  Positions u = t.v, w = t.host.vectors(t.n);
  for(int i = 0; i < t.n; ++i)
    u[i] = I::add(t.v[i], t.d[i]); // in the planes u . v = 1
  for(double omega : {0.5, 1., 1.3}) {
    t.host.jacobi_sweep(t.a, omega, t.v, u, w);
    for(int i = 0; i < t.n; ++i)
      CHECK(I::inner(w[i], t.v[i]) == Approx(1));
  }
  CHECK(t.host.saddle_point_residual2(t.a, t.v, u) > 0.01);
  for(int sweep = 0; sweep < 3000; ++sweep) {
    t.host.jacobi_sweep(t.a, 1, t.v, u, w);
    std::swap(u, w);
  }
  CHECK(t.host.saddle_point_residual2(t.a, t.v, u) < 1e-20);
  double residual2 = 0;
  for(int i = 0; i < t.n; ++i) {
    vec3 sum = {0, 0, 0};
    for(int k = t.graph->offset[i]; k < t.graph->offset[i + 1]; ++k)
      sum = I::add_scaled(sum, t.graph->weight[k], t.v[t.graph->target[k]]);
    residual2 += std::pow(I::norm(I::sub(t.v[i], I::unit(sum))), 2);
  }
  CHECK(t.host.barycentric_residual2(t.a, t.v) == Approx(residual2));
}
