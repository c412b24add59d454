// SPDX-License-Identifier: GPL-3.0-or-later
// Eigenfunctions of the Laplacian: of the definition, and where they are known.

#include "helpers/arrays.h"

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/kernel_signatures.h>
#include <CGAL/Spherical_parameterization/internal/spectrum/laplacian_spectrum.h>
#include <CGAL/Spherical_parameterization/Indexed_triangle_mesh.h>
#include <CGAL/Spherical_parameterization/laplacian_eigenpairs.h>

#include <Eigen/Core>

#include <boost/property_map/function_property_map.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

using namespace test;
namespace SP = CGAL::Spherical_parameterization;

namespace {

constexpr double no_limit = std::numeric_limits<double>::infinity();
const I::Host_loop one_core;

/// The cotangent Laplacian of a mesh, and a third of the areas of the faces at every vertex.
struct Surface {
  I::Weighted_graph laplacian;
  I::Host_array<double> mass;
};

Surface surface_of(const Plain_mesh& mesh)
{
  const std::size_t n = mesh.point.size();
  std::vector<std::map<int, double>> weight(n);
  Surface surface;
  surface.mass.assign(n, 0);
  for(const std::array<int, 3>& f : mesh.face)
    for(int k = 0; k < 3; ++k) {
      const int i = f[k], j = f[(k + 1) % 3], apex = f[(k + 2) % 3];
      const vec3 a = I::sub(mesh.point[i], mesh.point[apex]), b = I::sub(mesh.point[j], mesh.point[apex]);
      const double twice_area = I::norm(I::outer(a, b));
      weight[i][j] += I::inner(a, b) / twice_area / 2;
      weight[j][i] += I::inner(a, b) / twice_area / 2;
      surface.mass[i] += twice_area / 6;
    }
  for(const auto& row : weight) {
    for(const auto& [j, w] : row) {
      surface.laplacian.target.push_back(j);
      surface.laplacian.weight.push_back(w);
    }
    surface.laplacian.offset.push_back(static_cast<int>(surface.laplacian.target.size()));
  }
  return surface;
}

/// A sphere whose points are pushed to and fro: no symmetry is left.
Plain_mesh bumpy(int level)
{
  Plain_mesh mesh = octasphere(level);
  for(vec3& p : mesh.point)
    p = I::scale(1 + 0.2 * std::sin(3 * p.x + 1) + 0.1 * std::cos(5 * p.y + p.z + 2), p);
  return mesh;
}

SP::Laplacian_eigenpairs spectrum_of(const Surface& surface, int number)
{
  I::Monitor monitor(no_limit, nullptr, false);
  return I::laplacian_spectrum(one_core, surface.laplacian, surface.mass, number, monitor);
}

const double* function(const SP::Laplacian_eigenpairs& s, int k)
{
  return s.functions.data() + static_cast<std::size_t>(k) * s.number_of_vertices;
}

/// sum of mass f g
double product(const SP::Laplacian_eigenpairs& s, const double* f, const double* g)
{
  double sum = 0;
  for(int i = 0; i < int(s.number_of_vertices); ++i)
    sum += s.mass[i] * f[i] * g[i];
  return sum;
}

} // namespace

TEST_CASE("eigenfunctions are orthonormal, and solve the equation", "[spectrum]")
{
  const int level = GENERATE(3, 4), number = GENERATE(1, 2, 30, 60); // dense matrices, and Lanczos iteration
  Plain_mesh mesh = bumpy(level);
  const double length = GENERATE(1, 30); // of long bodies the first bases are too small
  for(vec3& p : mesh.point)
    p.z *= length;
  const Surface surface = surface_of(mesh);
  const SP::Laplacian_eigenpairs s = spectrum_of(surface, number);
  REQUIRE(s.value.size() == std::size_t(number));
  CHECK(s.value[0] == 0);
  CHECK(std::is_sorted(s.value.begin(), s.value.end()));
  double largest_product = 0, largest_residual = 0;
  for(int k = 0; k < number; ++k) {
    const double* const u = function(s, k);
    for(int l = 0; l <= k; ++l)
      largest_product = std::max(largest_product, std::abs(product(s, u, function(s, l)) - (k == l)));
    for(int i = 0; i < int(s.number_of_vertices); ++i) {
      double lu = 0;
      for(int e = surface.laplacian.offset[i]; e < surface.laplacian.offset[i + 1]; ++e)
        lu += surface.laplacian.weight[e] * (u[i] - u[surface.laplacian.target[e]]);
      largest_residual = std::max(largest_residual, std::abs(lu - s.value[k] * s.mass[i] * u[i]));
    }
    const double longest =
      *std::max_element(u, u + s.number_of_vertices, [](double a, double b) { return std::abs(a) < std::abs(b); });
    CHECK(longest > 0);
  }
  CHECK(largest_product < 1e-9);
  CHECK(largest_residual < 1e-10);
}

TEST_CASE("no eigenvalue is missed: the first ones are those of the whole matrix", "[spectrum]")
{
  const Surface surface = surface_of(GENERATE(0, 1) == 0 ? octasphere(3) : bumpy(3));
  const int few = 12, n = static_cast<int>(surface.mass.size());
  REQUIRE(n >= 3 * few + 100); // by iteration
  const SP::Laplacian_eigenpairs first = spectrum_of(surface, few), all = spectrum_of(surface, n);
  for(int k = 0; k < few; ++k)
    CHECK(first.value[k] == Approx(all.value[k]).margin(1e-8));
}

TEST_CASE("machines whose caches have other sizes find the same bits", "[spectrum]")
{
  const Surface surface = surface_of(bumpy(GENERATE(3, 4))); // dense matrices, and Lanczos iteration
  const int number = 200;
  std::ptrdiff_t l1 = 0, l2 = 0, l3 = 0;
  Eigen::internal::manage_caching_sizes(Eigen::GetAction, &l1, &l2, &l3);
  Eigen::setCpuCacheSizes(1 << 14, 1 << 18, 1 << 20);
  const SP::Laplacian_eigenpairs small = spectrum_of(surface, number);
  Eigen::setCpuCacheSizes(1 << 17, 1 << 22, 1 << 26);
  const SP::Laplacian_eigenpairs large = spectrum_of(surface, number);
  Eigen::setCpuCacheSizes(l1, l2, l3);
  CHECK((small.value == large.value));
  CHECK((small.functions == large.functions));
}

TEST_CASE("the sphere has the eigenvalues l (l + 1), each 2 l + 1 times", "[spectrum]")
{
  const SP::Laplacian_eigenpairs s = spectrum_of(surface_of(octasphere(5)), 36);
  int k = 0;
  for(int l = 0; l < 6; ++l)
    for(int m = -l; m <= l; ++m, ++k)
      CHECK(s.value[k] == Approx(l * (l + 1)).epsilon(0.02).margin(1e-8));
}

TEST_CASE("eigenpairs of a mesh are in its units, and signatures follow from them", "[spectrum]")
{
  const double size = GENERATE(1., 1e-3, 250., 1e7);
  Plain_mesh ball = octasphere(4);
  std::vector<std::array<double, 3>> points;
  for(const vec3& p : ball.point)
    points.push_back({size * p.x + 2, size * p.y, size * p.z});
  const SP::Indexed_triangle_mesh mesh(points, ball.face);
  const SP::Laplacian_eigenpairs pairs = SP::laplacian_eigenpairs(mesh, 16);
  REQUIRE(pairs.number() == 16);
  for(std::size_t k = 0; k < 16; ++k) {
    const double l = std::floor(std::sqrt(double(k)));
    CHECK(pairs.value[k] * size * size == Approx(l * (l + 1)).epsilon(0.02).margin(1e-8));
    double square = 0;
    for(std::size_t i = 0; i < pairs.number_of_vertices; ++i)
      square += pairs.mass[i] * pairs.function(k, i) * pairs.function(k, i);
    CHECK(square == Approx(1));
  }
  // After a long time the heat is everywhere; whole eigenspaces of a ball are the same at all vertices.
  const double area = std::accumulate(pairs.mass.begin(), pairs.mass.end(), 0.);
  CHECK(area == Approx(16 * std::atan(1.) * size * size).epsilon(0.01));
  const std::vector<double> heat = SP::heat_kernel_signature(pairs, {0.5 * size * size, 100 * size * size});
  const std::vector<double> wave = SP::wave_kernel_signature(pairs, 10);
  REQUIRE(heat.size() == 2 * pairs.number_of_vertices);
  REQUIRE(wave.size() == 10 * pairs.number_of_vertices);
  const double expected = (1 + 3 * std::exp(-1.) + 5 * std::exp(-3.) + 7 * std::exp(-6.)) / area;
  for(std::size_t i = 0; i < pairs.number_of_vertices; ++i) {
    CHECK(heat[i] == Approx(expected).epsilon(0.05));
    CHECK(heat[pairs.number_of_vertices + i] == Approx(1 / area));
    CHECK(wave[i] * area == Approx(1).epsilon(0.1));
  }
  for(double value : SP::wave_kernel_signature(pairs, 4000)) // most are far from all eigenvalues
    CHECK(std::isfinite(value));
  CHECK_THROWS_AS(SP::laplacian_eigenpairs(mesh, 0), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::laplacian_eigenpairs(mesh, pairs.number_of_vertices + 1), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::wave_kernel_signature(pairs, 1), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::heat_kernel_signature(pairs, {std::numeric_limits<double>::infinity()}),
                  CGAL::Precondition_exception);
}

TEST_CASE("eigenpairs are of the points that the mesh had when it was read", "[spectrum]")
{
  typedef SP::Indexed_triangle_mesh::Vertex_index Vertex;
  const Plain_mesh ball = octasphere(3);
  std::vector<std::array<double, 3>> points;
  for(const vec3& p : ball.point)
    points.push_back({p.x, p.y, p.z});
  const SP::Indexed_triangle_mesh mesh(points, ball.face);
  const auto point_map = boost::make_function_property_map<Vertex>(
    [&](Vertex v) -> const std::array<double, 3>& { return points[static_cast<std::size_t>(v.idx())]; });
  int calls = 0;
  const auto move = [&](double) {
    for(std::array<double, 3>& p : points)
      p = {2 * p[0], p[1] + 1, 0.5 * p[2]};
    return ++calls < 1000;
  };
  const SP::Laplacian_eigenpairs expected = SP::laplacian_eigenpairs(mesh, 9);
  const SP::Laplacian_eigenpairs pairs =
    SP::laplacian_eigenpairs(mesh, 9, CGAL::parameters::vertex_point_map(point_map).callback(move));
  CHECK(calls > 1);
  CHECK(pairs.value == expected.value);
}

TEST_CASE("the wave kernel signature of one eigenspace is the same at all vertices of a regular shape", "[spectrum]")
{
  const Surface surface = surface_of(octasphere(0));
  const SP::Laplacian_eigenpairs pairs = spectrum_of(surface, 4); // 0, and one eigenvalue three times
  REQUIRE(pairs.value[3] == Approx(pairs.value[1]));
  const double area = std::accumulate(pairs.mass.begin(), pairs.mass.end(), 0.);
  for(double value : SP::wave_kernel_signature(pairs, 3))
    CHECK(value * area == Approx(1));
}

TEST_CASE("the energies of the wave kernel signature ascend within the spectrum, however few", "[spectrum]")
{
  std::vector<double> value = {0};
  for(int k = 1; k < 40; ++k)
    value.push_back(k);
  for(std::size_t number : {2, 10, 20, 40, 100}) {
    const auto filters = I::wave_kernel_filters(value, number);
    double before = -1;
    for(const std::vector<double>& filter : filters) {
      double at = 0; // the mean of the logarithm
      for(std::size_t k = 1; k < value.size(); ++k)
        at += filter[k] * std::log(value[k]);
      CHECK(at > before);
      before = at;
    }
  }
}

TEST_CASE("sizes whose squares are no numbers have no spectrum", "[spectrum]")
{
  const double size = GENERATE(1e-200, 1e-120, 1e120, 1e200);
  const Plain_mesh ball = octasphere(3);
  std::vector<std::array<double, 3>> points;
  for(const vec3& p : ball.point)
    points.push_back({size * p.x, size * p.y, size * p.z});
  const SP::Indexed_triangle_mesh mesh(points, ball.face);
  SP::Error_code code = SP::Error_code::OK;
  try {
    const SP::Laplacian_eigenpairs pairs = SP::laplacian_eigenpairs(mesh, 4);
    CHECK(pairs.value[1] * size * size == Approx(2).epsilon(0.1));
  } catch(const SP::Error& error) {
    code = error.code();
  }
  CHECK(code == (size == 1e-200 || size == 1e200 ? SP::Error_code::NON_FINITE_COORDINATE : SP::Error_code::OK));
}

TEST_CASE("what has no spectrum is refused, and callback and time limit end it", "[spectrum]")
{
  Surface surface = surface_of(bumpy(4));
  const auto code_of = [&](I::Monitor& monitor) {
    try {
      I::laplacian_spectrum(one_core, surface.laplacian, surface.mass, 40, monitor);
    } catch(const CGAL::Spherical_parameterization::Error& error) {
      return error.code();
    }
    return CGAL::Spherical_parameterization::Error_code::OK;
  };
  using CGAL::Spherical_parameterization::Error_code;
  int calls = 0, last = (std::numeric_limits<int>::max)();
  const auto ask = [&](double) { return ++calls < last; };
  I::Monitor unlimited(no_limit, ask, false);
  CHECK(code_of(unlimited) == Error_code::OK);
  CHECK(calls > 10);
  last = calls / 2;
  calls = 0;
  I::Monitor stopped(no_limit, ask, false);
  CHECK(code_of(stopped) == Error_code::INTERRUPTED);
  CHECK(calls == last);
  I::Monitor over(0, nullptr, false);
  CHECK(code_of(over) == Error_code::INTERRUPTED);
  surface.mass[17] = 0;
  CHECK(code_of(unlimited) == Error_code::DEGENERATE_FACE);
}
