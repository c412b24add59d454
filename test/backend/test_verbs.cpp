// SPDX-License-Identifier: GPL-3.0-or-later
// Every verb of every parallel backend against the sequential one, on random graphs: the same to the last bit.

#include "helpers/policies.h"

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/coarsening.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point_impl.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

using namespace CGAL::Spherical_parameterization::internal;

namespace {

typedef Host_array<vec3> Positions;
typedef Host_array<double> Numbers;
typedef Backend<CGAL::Sequential_tag> Reference;

/// Numbers with all bits in use.
class Random {
public:
  double number(double low = -1, double high = 1) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  int index(int n) { return std::uniform_int_distribution<int>(0, n - 1)(engine_); }
  vec3 vector() { return {number(), number(), number()}; }
  Positions vectors(int n)
  {
    Positions x(n);
    for(vec3& p : x)
      p = vector();
    return x;
  }
  Positions unit_vectors(int n)
  {
    Positions x = vectors(n);
    for(vec3& p : x)
      p = unit(p);
    return x;
  }
  Numbers positive(int n)
  {
    Numbers x(n);
    for(double& s : x)
      s = number(0.1, 2);
    return x;
  }

private:
  std::mt19937 engine_{20111};
};

/// A ring with random chords, and a few fixed vertices. One vertex alone has no edge, and is fixed.
Weighted_graph random_graph(int n, bool has_excess, Random& random)
{
  std::vector<std::vector<int>> neighbours(n);
  const auto connect = [&](int i, int j) {
    if(i != j) {
      neighbours[i].push_back(j);
      neighbours[j].push_back(i);
    }
  };
  for(int i = 0; i < n; ++i) {
    connect(i, (i + 1) % n);
    connect(i, random.index(n));
  }
  Weighted_graph graph;
  std::vector<char> is_fixed(n, 0);
  for(int i = 0; i < n; ++i) {
    for(int j : neighbours[i]) {
      graph.target.push_back(j);
      graph.weight.push_back(random.number(0.1, 3));
    }
    graph.offset.push_back(static_cast<int>(graph.target.size()));
    is_fixed[i] = n == 1 || random.index(10) == 0;
  }
  if(has_excess)
    graph.excess = random.positive(n);
  graph.update_diagonal(is_fixed);
  return graph;
}

/// Of n vertices, some in none.
Aggregates random_aggregates(int n, int count, Random& random)
{
  Aggregates result;
  for(int i = 0; i < n; ++i)
    result.of_vertex.push_back(random.index(count + 1) - 1);
  list_members(count, result);
  return result;
}

std::uint64_t bits(double x)
{
  std::uint64_t result = 0;
  std::memcpy(&result, &x, sizeof result);
  return result;
}

std::size_t count_different_bits(const double* a, const double* b, std::size_t n)
{
  std::size_t count = 0;
  for(std::size_t i = 0; i < n; ++i)
    count += bits(a[i]) != bits(b[i]);
  return count;
}

/// Runs verbs on both backends and compares everything that they write and return.
template <class Policy>
class Comparison {
public:
  typedef Backend<Policy> Tested;

  Comparison(const Policy& policy, const Weighted_graph& graph)
    : reference_{Reference(CGAL::Sequential_tag()), graph}, tested_{Tested(policy), graph}
  {}

  /// Calls `verb(backend, matrix, mass, x...)` on both, `x` being the input on that backend; `verb` returns what is to
  /// be compared, as a tuple of vectors of positions and numbers.
  template <class Verb>
  void operator()(const char* name, const Positions& x, const Positions& y, const Numbers& mass, Verb verb)
  {
    INFO(name << ", " << x.size() << " vertices");
    const auto expected = reference_.call(verb, x, y, mass);
    const auto got = tested_.call(verb, x, y, mass);
    REQUIRE(expected.vectors.size() == got.vectors.size());
    for(std::size_t k = 0; k < got.vectors.size(); ++k) {
      REQUIRE(expected.vectors[k].size() == got.vectors[k].size());
      if(!got.vectors[k].empty())
        CHECK(count_different_bits(&expected.vectors[k][0].x, &got.vectors[k][0].x, 3 * got.vectors[k].size()) == 0);
    }
    REQUIRE(expected.numbers.size() == got.numbers.size());
    for(std::size_t k = 0; k < got.numbers.size(); ++k)
      CHECK(expected.numbers[k] == got.numbers[k]);
  }

private:
  struct Outcome {
    std::vector<Positions> vectors;
    Numbers numbers;
  };

public:
  /// What a verb is given, and where it leaves what it wrote.
  template <class B>
  struct Bench {
    const B& backend;
    const typename B::Matrix& a;
    typename B::Vectors x, y, z, w;
    typename B::Scalars mass, scratch;
    Outcome outcome;

    void wrote(const typename B::Vectors& v) { outcome.vectors.push_back(backend.download(v)); }
    /// By sums over them
    void wrote(const typename B::Steps& v)
    {
      const int size = static_cast<int>(v.size());
      returned(backend.direction_products(a, mass, backend.vectors(size), v, v, v));
    }
    /// Divided by the diagonal
    typename B::Steps steps_of(const typename B::Vectors& v) const
    {
      const int size = static_cast<int>(v.size());
      typename B::Steps result = backend.steps(size);
      backend.balance_gradient(a, backend.scalars(size), {0, 0, 0}, v, v, backend.steps(size), result);
      return result;
    }
    void returned(double s) { outcome.numbers.push_back(s); }
    template <std::size_t K>
    void returned(const std::array<double, K>& s)
    {
      outcome.numbers.insert(outcome.numbers.end(), s.begin(), s.end());
    }
  };

private:
  template <class B>
  struct Side {
    Side(B b, const Weighted_graph& graph)
      : backend(std::move(b)), matrix(backend.upload(std::make_shared<const Weighted_graph>(graph)))
    {}
    B backend;
    typename B::Matrix matrix;

    template <class Verb>
    Outcome call(Verb verb, const Positions& x, const Positions& y, const Numbers& mass) const
    {
      const int n = static_cast<int>(x.size());
      Bench<B> bench = {backend,
                        matrix,
                        backend.upload(x),
                        backend.upload(y),
                        backend.upload(y),
                        backend.vectors(n),
                        backend.upload(mass),
                        backend.scalars(n),
                        {}};
      verb(bench);
      return bench.outcome;
    }
  };

  Side<Reference> reference_;
  Side<Tested> tested_;
};

} // namespace

TEST_CASE("powers are those of the C library, but for rounding", "[verbs]")
{
  Random random;
  for(const double y : {0., 1., -1., 0.5, 2., 30., -2.75, 0.1, 2.3, -0.7, 100.})
    for(int i = 0; i < 2000; ++i) {
      const double x = std::exp2(random.number(-6, 6));
      CAPTURE(x, y);
      const double expected = std::pow(x, y);
      const double bound = std::ldexp(3 + std::abs(y) + std::abs(std::log(expected)), -52);
      CHECK(std::abs(power(x, y) / expected - 1) <= bound);
    }
  const double least = std::numeric_limits<double>::denorm_min(), most = (std::numeric_limits<double>::max)();
  CHECK(power(least, 0.3) == Approx(std::pow(least, 0.3)).epsilon(1e-13));
  CHECK(power(most, 0.3) == Approx(std::pow(most, 0.3)).epsilon(1e-13));
  CHECK(power(2, -1070.3) == Approx(std::exp2(-1070.3)).epsilon(0.1)); // with few digits
  for(const double y : {2., 2.1, 1e300}) {
    CHECK(power(most, y) == std::numeric_limits<double>::infinity());
    CHECK(power(least, y) == 0);
    CHECK(power(most, -y) == 0);
    CHECK(power(1, y) == 1);
  }
}

TEMPLATE_LIST_TEST_CASE("every verb does the same on every backend, bit by bit", "[verbs]", test::Parallel_policies)
{
  auto policy = test::some_policy<TestType>();
  if(!policy)
    return;
  const bool is_as_on_gpu = GENERATE(false, true);
  if(is_as_on_gpu && !test::treat_as_gpu(*policy))
    return;
  const char* const size = std::getenv("LARGEST_GRAPH"); // smaller where kernels are simulated
  const int largest = size ? std::atoi(size) : 100001;
  const int n = GENERATE_COPY(0, 1, 63, 64, 65, 1023, 1024, 1025, largest);
  const bool has_excess = GENERATE(false, true);
  Random random;
  const Weighted_graph graph = random_graph(n, has_excess, random);
  const Positions x = random.unit_vectors(n), y = random.vectors(n);
  const Numbers mass = random.positive(n);
  const double alpha = random.number(), beta = random.number();
  const vec3 mu = random.vector(), omega = random.vector();
  Comparison<TestType> compare(*policy, graph);
  const auto check = [&](const char* name, auto verb) { compare(name, x, y, mass, verb); };

  check("memory", [](auto& t) {
    t.wrote(t.x);
    t.wrote(t.w);
    std::swap(t.x, t.y);
    t.w = std::move(t.x);
    t.wrote(t.w);
    t.wrote(t.y);
  });
  check("copy", [](auto& t) {
    t.backend.copy(t.x, t.w);
    t.wrote(t.w);
  });
  check("dot", [](auto& t) { t.returned(t.backend.dot(t.x, t.y)); });
  check("multiply", [](auto& t) {
    t.returned(t.backend.multiply(t.a, t.x, t.w));
    t.wrote(t.w);
  });
  check("descend", [&](auto& t) {
    t.backend.descend(alpha, t.x, t.y, t.z, t.w);
    t.wrote(t.z);
    t.wrote(t.w);
  });
  check("conjugate", [&](auto& t) {
    t.backend.conjugate(beta, t.x, t.y);
    t.wrote(t.y);
  });
  check("energy", [](auto& t) { t.returned(t.backend.energy(t.a, t.x)); });
  check("residual", [](auto& t) {
    t.backend.residual(t.a, t.y, t.x, t.w);
    t.wrote(t.w);
  });
  check("start_smoothing", [&](auto& t) {
    t.backend.start_smoothing(t.a, alpha, t.x, t.w);
    t.wrote(t.w);
  });
  check("smooth", [&](auto& t) {
    t.backend.smooth(t.a, alpha, t.x, t.y, t.w);
    t.wrote(t.w);
  });
  for(double p : {2., 2.1, 3., 4.5})
    check("gradient, curvature", [&](auto& t) {
      t.returned(t.backend.gradient(t.a, p, t.x, t.w, t.scratch));
      t.wrote(t.w);
      t.returned(t.backend.curvature(t.a, p, t.mass, mu, t.x, t.steps_of(t.y), t.scratch));
    });
  check("spring_masses", [&](auto& t) {
    t.backend.spring_masses(t.a, t.x, t.scratch);
    t.returned(t.backend.moments(t.scratch, t.y));
    t.returned(t.backend.tilt_masses(t.mass, mu, t.x, t.scratch));
    t.returned(t.backend.moments(t.scratch, t.y));
  });
  check("moments", [&](auto& t) { t.returned(t.backend.moments(t.mass, t.x)); });
  check("balance_gradient", [&](auto& t) {
    auto b = t.backend.steps_in(t.w);
    t.returned(t.backend.balance_gradient(t.a, t.mass, mu, t.x, t.y, t.steps_of(t.z), b));
    t.wrote(b);
  });
  check("direction_products", [](auto& t) {
    const auto d = t.steps_of(t.z);
    t.returned(t.backend.direction_products(t.a, t.mass, t.x, t.steps_of(t.y), d, d));
  });
  check("next_direction", [&](auto& t) {
    auto d = t.steps_of(t.z);
    t.backend.next_direction(beta, mu, omega, t.x, t.steps_of(t.y), d);
    t.wrote(d);
  });
  check("retract", [&](auto& t) {
    t.returned(t.backend.retract(t.mass, alpha, scale(0.1, mu), t.x, t.steps_of(t.y), t.w));
    t.wrote(t.w);
  });
  check("transform", [&](auto& t) {
    t.returned(t.backend.transform(t.mass, scale(0.5, mu), t.x, t.w));
    t.wrote(t.w);
  });
  check("jacobi_sweep", [&](auto& t) {
    t.backend.jacobi_sweep(t.a, 0.9, t.x, t.y, t.w);
    t.wrote(t.w);
  });
  check("gauss_seidel_sweep", [&](auto& t) {
    t.backend.gauss_seidel_sweep(t.a, t.backend.colouring(greedy_colouring(graph)), 1.3, t.x, t.y);
    t.wrote(t.y);
  });
  check("saddle_point_residual2", [](auto& t) { t.returned(t.backend.saddle_point_residual2(t.a, t.x, t.y)); });
  check("normalize", [](auto& t) {
    t.backend.normalize(t.a, t.y, t.x);
    t.wrote(t.x);
  });
  check("barycentric_residual2", [](auto& t) { t.returned(t.backend.barycentric_residual2(t.a, t.x)); });

  const auto aggregates = std::make_shared<const Aggregates>(random_aggregates(n, (n + 3) / 4, random));
  const Positions coarse = random.vectors((n + 3) / 4);
  check("correct, restrict", [&](auto& t) {
    const auto of = t.backend.upload(aggregates);
    auto c = t.backend.upload(coarse);
    t.backend.correct(of, c, t.y);
    t.wrote(t.y);
    t.backend.restrict(of, t.x, c);
    t.wrote(c);
  });
  if(n < 100) {
    const Numbers dense = random.positive(n * n);
    check("multiply_dense", [&](auto& t) {
      t.backend.multiply_dense(t.backend.upload(dense), t.x, t.w);
      t.wrote(t.w);
    });
  }

  const auto smoother =
    std::make_shared<const Weighted_smoother>(Host_loop(false), std::make_shared<Weighted_graph>(graph));
  Host_array<float> share;
  for(double one : random.positive(n))
    share.push_back(static_cast<float>(one));
  check("a cycle in floats", [&](auto& t) {
    const auto a = t.backend.upload(smoother, t.a);
    const auto of = t.backend.upload(aggregates);
    const auto shares = t.backend.upload(share);
    const auto b = t.steps_of(t.y);
    auto of_vertices = t.steps_of(t.x), of_aggregates = t.backend.steps((n + 3) / 4);
    t.backend.start_smoothing(a, alpha, beta, b, of_vertices);
    t.wrote(of_vertices);
    auto smooth = t.backend.steps(n);
    t.backend.smooth(a, alpha, b, of_vertices, smooth);
    t.wrote(smooth);
    t.backend.residual(a, b, smooth, of_vertices);
    t.wrote(of_vertices);
    t.backend.restrict(of, shares, of_vertices, of_aggregates);
    t.wrote(of_aggregates);
    t.backend.correct(of, of_aggregates, smooth);
    t.wrote(smooth);
  });
  if(n < 100) {
    const Numbers dense = random.positive(n * n);
    check("multiply_dense in floats", [&](auto& t) {
      auto result = t.backend.steps(n);
      t.backend.multiply_dense(t.backend.upload(dense), t.a, t.steps_of(t.x), result);
      t.wrote(result);
    });
  }
}
