// SPDX-License-Identifier: GPL-3.0-or-later
// The hierarchy piece by piece, against dense matrices.

#include "helpers/arrays.h"

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Float_cycle.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/Multigrid.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <set>

using namespace test;

namespace {

typedef std::vector<std::vector<double>> Dense;

std::shared_ptr<I::Weighted_graph> graph_of(const Plain_mesh& mesh, bool has_excess, const std::set<int>& fixed = {})
{
  const auto graph = std::make_shared<I::Weighted_graph>();
  const auto neighbours = mesh.neighbours();
  for(int i = 0; i < int(neighbours.size()); ++i) {
    for(int j : neighbours[i]) {
      graph->target.push_back(j);
      graph->weight.push_back(1 + 0.5 * std::sin(i + j) + 0.3 * std::cos(3. * i * j));
    }
    graph->offset.push_back(int(graph->target.size()));
    if(has_excess)
      graph->excess.push_back(0.01 + 0.1 * std::abs(std::sin(i)));
  }
  std::vector<char> is_fixed(neighbours.size(), 0);
  for(int i : fixed)
    is_fixed[i] = 1;
  graph->update_diagonal(is_fixed);
  return graph;
}

/// Two poles over a polygon
Plain_mesh bipyramid(int sides)
{
  Plain_mesh mesh;
  mesh.point.resize(sides + 2); // the graph does not depend on them
  for(int i = 0; i < sides; ++i) {
    mesh.face.push_back({i, (i + 1) % sides, sides});
    mesh.face.push_back({(i + 1) % sides, i, sides + 1});
  }
  return mesh;
}

Dense dense(const I::Weighted_graph& a)
{
  Dense m(a.size(), std::vector<double>(a.size(), 0));
  for(int i = 0; i < a.size(); ++i) {
    m[i][i] = a.excess.empty() ? 0 : a.excess[i];
    for(int k = a.offset[i]; k < a.offset[i + 1]; ++k) {
      m[i][i] += a.weight[k];
      m[i][a.target[k]] -= a.weight[k];
    }
  }
  return m;
}

Dense dense(const I::Sparse_matrix& a, int columns)
{
  Dense m(a.rows(), std::vector<double>(columns, 0));
  for(int i = 0; i < a.rows(); ++i)
    for(int k = a.offset[i]; k < a.offset[i + 1]; ++k)
      m[i][a.column[k]] += a.value[k];
  return m;
}

Dense transposed(const Dense& a)
{
  Dense t(a[0].size(), std::vector<double>(a.size()));
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t j = 0; j < a[i].size(); ++j)
      t[j][i] = a[i][j];
  return t;
}

Dense product(const Dense& a, const Dense& b)
{
  Dense c(a.size(), std::vector<double>(b[0].size(), 0));
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t k = 0; k < b.size(); ++k)
      for(std::size_t j = 0; j < b[k].size(); ++j)
        c[i][j] += a[i][k] * b[k][j];
  return c;
}

double difference(const Dense& a, const Dense& b)
{
  double largest = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    for(std::size_t j = 0; j < a[i].size(); ++j)
      largest = std::max(largest, std::abs(a[i][j] - b[i][j]));
  return largest;
}

typedef I::Host_backend<I::Host_loop> Host;

Positions random_vectors(int n, unsigned seed)
{
  Random random(seed);
  Positions x(n);
  for(vec3& p : x)
    p = random.vector();
  return x;
}

/// so that components sum to zero
Positions without_mean(Positions x)
{
  vec3 sum = {0, 0, 0};
  for(const vec3& p : x)
    sum = I::add(sum, p);
  for(vec3& p : x)
    p = I::add_scaled(p, -1. / double(x.size()), sum);
  return x;
}

} // namespace

TEST_CASE("aggregates cover all vertices but the fixed ones, and are connected and small", "[multigrid]")
{
  const Plain_mesh mesh = octasphere(4);
  const std::set<int> fixed = {3, 77, 500};
  const auto graph = graph_of(mesh, false, fixed);
  const I::Aggregates aggregates = I::aggregate(I::Host_loop(), *graph, 0.07);
  const int n = graph->size();
  CHECK(aggregates.count() < n / 4);
  CHECK(aggregates.count() > n / 40);
  std::vector<std::vector<int>> members(aggregates.count());
  for(int i = 0; i < n; ++i) {
    const int of = aggregates.of_vertex[i];
    CHECK((of == -1) == (fixed.count(i) > 0));
    REQUIRE(of < aggregates.count());
    if(of >= 0)
      members[of].push_back(i);
  }
  for(const std::vector<int>& m : members) {
    REQUIRE_FALSE(m.empty());
    std::set<int> met = {m[0]};
    for(std::size_t round = 0; round < m.size(); ++round)
      for(int i : std::set<int>(met))
        for(int k = graph->offset[i]; k < graph->offset[i + 1]; ++k)
          if(aggregates.of_vertex[graph->target[k]] == aggregates.of_vertex[i])
            met.insert(graph->target[k]);
    CHECK(met.size() == m.size());
  }
}

TEST_CASE("prolongation is a damped Jacobi step after piecewise constants, and keeps constants", "[multigrid]")
{
  const bool has_excess = GENERATE(false, true);
  const auto graph = graph_of(octasphere(3), has_excess);
  const I::Aggregates aggregates = I::aggregate(I::Host_loop(), *graph, 0.07);
  constexpr double omega = 0.6;
  const Dense p = dense(I::smoothed_prolongation(I::Host_loop(), *graph, aggregates, omega), aggregates.count());
  const Dense a = dense(*graph);
  const int n = graph->size();
  Dense tentative(n, std::vector<double>(aggregates.count(), 0));
  for(int i = 0; i < n; ++i)
    tentative[i][aggregates.of_vertex[i]] = 1;
  Dense step = a;
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      step[i][j] = (i == j) - omega * graph->inverse_diagonal[i] * a[i][j];
  CHECK(difference(p, product(step, tentative)) < 1e-14);
  if(!has_excess)
    for(const std::vector<double>& row : p)
      CHECK(std::accumulate(row.begin(), row.end(), 0.) == Approx(1));
}

TEST_CASE("the prolongation does not smooth at poles of a high degree", "[multigrid]")
{
  constexpr int sides = 300;
  const auto graph = graph_of(bipyramid(sides), false);
  const I::Aggregates aggregates = I::aggregate(I::Host_loop(), *graph, 0.07);
  const I::Sparse_matrix p = I::smoothed_prolongation(I::Host_loop(), *graph, aggregates, 0.6);
  for(int pole : {sides, sides + 1}) {
    REQUIRE(p.offset[pole + 1] - p.offset[pole] == 1);
    CHECK(p.column[p.offset[pole]] == aggregates.of_vertex[pole]);
    CHECK(p.value[p.offset[pole]] == 1);
  }
}

TEST_CASE("prolongation and restriction by smoothing steps are those of the matrix", "[multigrid]")
{
  const bool has_excess = GENERATE(false, true);
  const auto fixed = GENERATE(std::set<int>{}, std::set<int>{5, 100});
  const I::Shared_graph graph = graph_of(octasphere(4), has_excess, fixed);
  const Host backend;
  const auto aggregates = std::make_shared<const I::Aggregates>(I::aggregate(I::Host_loop(), *graph, 0.07));
  const int n = graph->size(), count = aggregates->count();
  constexpr double omega = 0.6;
  const I::Sparse_matrix p = I::smoothed_prolongation(I::Host_loop(), *graph, *aggregates, omega);
  const Positions x = random_vectors(count, 1), r = random_vectors(n, 2), zero(n, vec3{0, 0, 0});
  Positions step(n), left(n), coarse(count), corrected = zero, smoothed(n);
  backend.start_smoothing(graph, omega, r, step);
  backend.residual(graph, r, step, left);
  backend.restrict(aggregates, left, coarse);
  backend.correct(aggregates, x, corrected);
  backend.smooth(graph, omega, zero, corrected, smoothed);
  Positions restricted(count, vec3{0, 0, 0});
  for(int i = 0; i < n; ++i) {
    vec3 sum = {0, 0, 0};
    for(int k = p.offset[i]; k < p.offset[i + 1]; ++k) {
      sum = I::add_scaled(sum, p.value[k], x[p.column[k]]);
      restricted[p.column[k]] = I::add_scaled(restricted[p.column[k]], p.value[k], r[i]);
    }
    CHECK(I::norm(I::sub(smoothed[i], sum)) < 1e-14);
  }
  for(int c = 0; c < count; ++c)
    CHECK(I::norm(I::sub(coarse[c], restricted[c])) < 1e-12);
}

TEST_CASE("coarse matrices are Galerkin products, on any number of threads", "[multigrid]")
{
  const bool has_excess = GENERATE(false, true), on_all_cores = GENERATE(false, true);
  const std::set<int> fixed = has_excess ? std::set<int>{5, 100} : std::set<int>{};
  const I::Host_loop loop(on_all_cores);
  const auto graph = graph_of(octasphere(4), has_excess, fixed);
  const I::Aggregates aggregates = I::aggregate(loop, *graph, 0.07);
  const I::Sparse_matrix p = I::smoothed_prolongation(loop, *graph, aggregates, 0.6);
  const I::Sparse_matrix r = I::transposed(loop, p, aggregates.count());
  const Dense dense_p = dense(p, aggregates.count());
  CHECK(difference(dense(r, graph->size()), transposed(dense_p)) == 0);
  for(int i = 0; i < r.rows(); ++i)
    CHECK(std::is_sorted(r.column.begin() + r.offset[i], r.column.begin() + r.offset[i + 1]));
  const I::Weighted_graph coarse = I::galerkin_product(loop, *graph, p, r, !has_excess);
  const Dense expected = product(transposed(dense_p), product(dense(*graph), dense_p));
  const Dense found = dense(coarse);
  CHECK(difference(found, expected) < 1e-12);
  CHECK(coarse.excess.empty() == !has_excess);
  for(int i = 0; i < coarse.size(); ++i)
    CHECK(coarse.diagonal(i) == Approx(expected[i][i]));
}

TEST_CASE("dropping weak edges keeps row sums and symmetry", "[multigrid]")
{
  const auto graph = graph_of(octasphere(3), true);
  for(int i = 0; i < graph->size(); ++i) // every fifth edge is next to nothing
    for(int k = graph->offset[i]; k < graph->offset[i + 1]; ++k)
      graph->weight[k] *= (i + graph->target[k]) % 5 ? 1 : 1e-4;
  graph->update_diagonal({});
  I::Weighted_graph fewer = *graph;
  I::drop_weak_edges(I::Host_loop(), 0.01, fewer);
  CHECK(fewer.target.size() < 0.85 * graph->target.size());
  CHECK(fewer.excess == graph->excess);
  const Dense m = dense(fewer);
  for(int i = 0; i < fewer.size(); ++i) {
    CHECK(fewer.inverse_diagonal[i] == Approx(1 / m[i][i])); // no weight is negative
    for(int j = 0; j < fewer.size(); ++j)
      CHECK(m[i][j] == m[j][i]);
  }
}

TEST_CASE("the spectral radius is known from above, and not by much", "[multigrid]")
{
  const bool has_negative_weights = GENERATE(false, true);
  const auto graph = graph_of(octasphere(3), false);
  if(has_negative_weights) {
    for(int i = 0; i < graph->size(); ++i)
      for(int k = graph->offset[i]; k < graph->offset[i + 1]; ++k)
        if((i + graph->target[k]) % 11 == 0)
          graph->weight[k] = -0.2;
    graph->update_diagonal({});
    I::drop_weak_edges(I::Host_loop(), 0, *graph); // none; it scales the steps
  }
  const Dense a = dense(*graph);
  for(std::size_t i = 0; i < a.size(); ++i) { // Gershgorin's bound, which the scale of the steps keeps at 2
    double sum = 0;
    for(double entry : a[i])
      sum += std::abs(entry);
    CHECK(graph->inverse_diagonal[i] * sum < 2 + 1e-12);
  }
  std::vector<double> x(a.size());
  for(std::size_t i = 0; i < x.size(); ++i)
    x[i] = std::sin(double(i * i));
  double radius = 0;
  for(int round = 0; round < 500; ++round) {
    std::vector<double> y(x.size(), 0);
    double square = 0;
    for(std::size_t i = 0; i < x.size(); ++i) {
      for(std::size_t j = 0; j < x.size(); ++j)
        y[i] += graph->inverse_diagonal[i] * a[i][j] * x[j];
      square += y[i] * y[i];
    }
    radius = std::sqrt(square);
    for(std::size_t i = 0; i < x.size(); ++i)
      x[i] = y[i] / radius;
  }
  const double estimate = I::spectral_radius(*graph);
  CHECK(radius <= 2);
  CHECK(estimate > 0.98 * radius);
  CHECK(estimate < 1.3 * radius);
}

TEST_CASE("the smoother damps the upper part of the spectrum, and amplifies nothing", "[multigrid]")
{
  for(double radius : {1.5, 1.9, 2.6}) {
    const auto [first, second] = I::chebyshev_gains(radius);
    double largest = 0;
    for(double eigenvalue = 0; eigenvalue <= 1.05 * radius; eigenvalue += 0.01) {
      const double factor = std::abs((1 - first * eigenvalue) * (1 - second * eigenvalue));
      CHECK(factor <= 1);
      if(eigenvalue > 1.05 * radius / 6)
        largest = std::max(largest, factor);
    }
    CHECK(largest < 0.35); // of degree 2, on [1/6, 1]: 1 / T_2(7/5)
  }
}

TEST_CASE("dense inverses are inverses, and those of singular matrices on what sums to zero", "[multigrid]")
{
  const bool has_excess = GENERATE(false, true);
  const std::set<int> fixed = has_excess ? std::set<int>{0, 17} : std::set<int>{};
  const auto graph = graph_of(octasphere(2), has_excess, fixed);
  const int n = graph->size();
  const I::Host_array<double> inverse = I::dense_inverse(*graph, !has_excess);
  Dense m = dense(*graph), x(n, std::vector<double>(n));
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j) {
      x[i][j] = inverse[std::size_t(i) * n + j];
      if(fixed.count(i) || fixed.count(j)) {
        CHECK(x[i][j] == 0);
        m[i][j] = 0;
      }
    }
  CHECK(difference(x, transposed(x)) == 0);
  Dense expected(n, std::vector<double>(n));
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      expected[i][j] = (i == j && !fixed.count(i)) - (has_excess ? 0 : 1. / n);
  Dense found = product(m, x);
  CHECK(difference(found, expected) < 1e-12);
}

TEST_CASE("a cycle is symmetric and positive", "[multigrid]")
{
  const bool has_excess = GENERATE(false, true);
  const int kind =
    GENERATE(0, 1, 2); // 1: with fixed vertices; 2: with poles, at which the prolongation is not smoothed
  const std::set<int> fixed = kind == 1 ? std::set<int>{1, 50, 800} : std::set<int>{};
  const Host host{I::Host_loop()};
  const auto graph = graph_of(kind == 2 ? bipyramid(3000) : octasphere(5), has_excess, fixed);
  I::Multigrid<Host> multigrid(host, graph);
  REQUIRE(multigrid.number_of_levels() > 2);
  for(unsigned seed = 1; seed < 5; ++seed) {
    Positions b = random_vectors(graph->size(), seed), c = random_vectors(graph->size(), seed + 10);
    if(!has_excess && kind != 1) {
      b = without_mean(b);
      c = without_mean(c);
    }
    for(int i : fixed)
      b[i] = c[i] = {0, 0, 0};
    Positions x(b.size()), y(c.size());
    multigrid.apply(0, b, x);
    multigrid.apply(0, c, y);
    CHECK(host.dot(x, c) == Approx(host.dot(b, y)).epsilon(1e-9).margin(1e-9));
    CHECK(host.dot(x, b) > 0);
  }
}

TEST_CASE("a cycle in floats is that in doubles, whatever the unit of the weights", "[multigrid]")
{
  const Host host{I::Host_loop()};
  const int kind = GENERATE(0, 1, 2); // singular, with excess, with fixed vertices
  const double unit = GENERATE(1., 1e-200, 1e200), least = GENERATE(1e-10, 1.);
  CAPTURE(kind, unit, least);
  const std::set<int> fixed = kind == 2 ? std::set<int>{1, 50, 800} : std::set<int>{};
  const auto graph = graph_of(kind == 0 ? bipyramid(3000) : octasphere(5), kind == 1, fixed);
  for(double& w : graph->weight)
    w *= unit;
  for(double& e : graph->excess)
    e *= unit * least;
  graph->update_diagonal({});
  for(int i : fixed)
    graph->inverse_diagonal[i] = 0;
  I::Multigrid<Host> multigrid(host, graph);
  I::Float_cycle<Host> cycle(host, multigrid);
  Positions right = without_mean(random_vectors(graph->size(), 1)), x(right.size());
  for(int i : fixed)
    right[i] = {0, 0, 0};
  auto b = host.steps(graph->size()), y = host.steps(graph->size()), float_x = host.steps(graph->size());
  for(int i = 0; i < graph->size(); ++i) {
    right[i] = I::scale(unit, right[i]);
    b[i] = I::to_float4(I::scale(graph->inverse_diagonal[i], right[i]));
  }
  multigrid.apply(0, right, x);
  cycle.apply(0, b, y, float_x);
  double largest = 0, error = 0; // but for the constants, which a matrix that is as good as singular leaves open
  const vec3 left_open = I::sub(I::to_vec3(float_x[7]), x[7]);
  for(int i = 0; i < graph->size(); ++i)
    if(!fixed.count(i)) {
      const vec3 difference = I::sub(I::to_vec3(float_x[i]), x[i]);
      error = (std::max)(error, I::norm(kind == 2 ? difference : I::sub(difference, left_open)));
      largest = (std::max)(largest, I::norm(x[i]));
    } else
      CHECK(I::norm(I::to_vec3(float_x[i])) == 0);
  CHECK(largest > 0);
  CHECK(error < 1e-4 * largest);
}

TEST_CASE("the set-up of a hierarchy hears a limit at each level", "[multigrid]")
{
  const Host host{I::Host_loop()};
  const auto graph = graph_of(octasphere(5), false);
  int calls = 0, most = 0;
  I::Monitor all(
    std::numeric_limits<double>::infinity(), [&](double) { return ++calls > 0; }, false);
  const auto levels = static_cast<int>(I::Multigrid<Host>(host, graph, &all).number_of_levels());
  REQUIRE(levels > 2);
  CHECK(calls == levels - 1); // the last one is not coarsened
  I::Monitor some(
    std::numeric_limits<double>::infinity(), [&](double) { return ++most < 2; }, false);
  CHECK_THROWS_AS(I::Multigrid<Host>(host, graph, &some), CGAL::Spherical_parameterization::Error);
  CHECK(most == 2);
}

TEST_CASE("conjugate gradients solve, in few steps, and no fixed vertex moves", "[multigrid]")
{
  const int kind = GENERATE(0, 1, 2); // singular, with excess, with fixed vertices
  const Host host{I::Host_loop()};
  const std::set<int> fixed = kind == 2 ? std::set<int>{1, 50, 800} : std::set<int>{};
  const auto graph = graph_of(octasphere(5), kind == 1, fixed);
  I::Multigrid<Host> multigrid(host, graph);
  Positions b = random_vectors(graph->size(), 1);
  if(kind == 0)
    b = without_mean(b);
  for(int i : fixed)
    b[i] = {0, 0, 0};
  Positions x = host.vectors(graph->size()), r = x;
  I::Monitor monitor;
  const std::size_t steps = I::conjugate_gradients(host, multigrid, 0, b, 1e-10, monitor, 0, x);
  CHECK(steps < 25);
  host.residual(graph, b, x, r);
  for(int i : fixed) {
    CHECK((x[i].x == 0 && x[i].y == 0 && x[i].z == 0));
    r[i] = {0, 0, 0};
  }
  CHECK(host.dot(r, r) < 1e-14 * host.dot(b, b));
}
