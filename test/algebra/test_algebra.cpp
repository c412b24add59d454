// SPDX-License-Identifier: GPL-3.0-or-later
// Rotations, small symmetric systems, boxes and histograms, by what defines them.

#include "helpers/arrays.h"

#include <CGAL/Spherical_parameterization/internal/algebra/Bounding_box.h>
#include <CGAL/Spherical_parameterization/internal/algebra/Nearest_rows.h>
#include <CGAL/Spherical_parameterization/internal/algebra/histogram.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/algebra/symmetric_solver.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

using namespace test;

namespace {

double distance(vec3 a, vec3 b) { return I::norm(I::sub(a, b)); }

double determinant(const I::Matrix_3& r)
{
  const auto row = [&](int i) { return vec3{r[i][0], r[i][1], r[i][2]}; };
  return I::inner(row(0), I::outer(row(1), row(2)));
}

} // namespace

TEST_CASE("rotations keep lengths and orientation, their axis, and turn by their angle", "[algebra]")
{
  Random random;
  for(int trial = 0; trial < 100; ++trial) {
    const vec3 axis = random.unit_vector(), p = random.vector();
    const double angle = random.number(0, I::pi);
    const I::Matrix_3 r = I::rotation_about(I::scale(angle, axis));
    CHECK(determinant(r) == Approx(1));
    CHECK(I::norm(I::rotated(r, p)) == Approx(I::norm(p)));
    CHECK(distance(I::rotated(r, axis), axis) < 1e-14);
    const vec3 across = I::unit(I::tangent(p, axis));
    const vec3 expected = I::add_scaled(I::scale(std::cos(angle), across), std::sin(angle), I::outer(axis, across));
    CHECK(distance(I::rotated(r, across), expected) < 1e-14);
    const I::Matrix_3 other = I::rotation_about(random.vector());
    CHECK(distance(I::rotated(I::product(r, other), p), I::rotated(r, I::rotated(other, p))) < 1e-14);
    const double length = random.number(0.1, 10); // of a quaternion does not matter
    const std::array<double, 4> q = {random.number(), random.number(), random.number(), random.number()};
    const std::array<double, 4> longer = {length * q[0], length * q[1], length * q[2], length * q[3]};
    CHECK(distance(I::rotated(I::rotation_of_quaternion(q), p), I::rotated(I::rotation_of_quaternion(longer), p)) <
          1e-14);
  }
  CHECK(distance(I::rotated(I::rotation_about({0, 0, 0}), {1, 2, 3}), {1, 2, 3}) == 0);
}

TEST_CASE("the best rotation is found again, and no small one betters it", "[algebra]")
{
  Random random;
  for(int trial = 0; trial < 50; ++trial) {
    Positions from(10), to(10);
    const I::Matrix_3 r = I::rotation_about(I::scale(3, random.vector()));
    const double noise = trial % 2 ? 0.3 : 0;
    for(std::size_t k = 0; k < from.size(); ++k) {
      from[k] = random.unit_vector();
      to[k] = I::add_scaled(I::rotated(r, from[k]), noise, random.vector());
    }
    const I::Matrix_3 best = I::best_rotation(from, to);
    CHECK(determinant(best) == Approx(1));
    const auto products = [&](const I::Matrix_3& rotation) {
      double sum = 0;
      for(std::size_t k = 0; k < from.size(); ++k)
        sum += I::inner(to[k], I::rotated(rotation, from[k]));
      return sum;
    };
    for(int k = 0; k < 20; ++k)
      CHECK(products(I::product(I::rotation_about(I::scale(0.01, random.vector())), best)) <= products(best) + 1e-13);
    if(noise == 0)
      for(std::size_t k = 0; k < from.size(); ++k)
        CHECK(distance(I::rotated(best, from[k]), to[k]) < 1e-13);
  }
}

TEST_CASE("symmetric systems, definite or not, are solved; nothing comes out along what vanishes", "[algebra]")
{
  Random random;
  for(int trial = 0; trial < 100; ++trial) {
    I::Symmetric_solver<6>::Matrix a;
    I::Symmetric_solver<6>::Vector b;
    for(int i = 0; i < 6; ++i) {
      b[i] = random.number();
      for(int j = 0; j <= i; ++j)
        a[i][j] = a[j][i] = random.number() + (i == j ? (i % 2 ? 4 : -5) + 3 * i : 0);
    }
    I::Symmetric_solver<6>::Matrix lower = a;
    for(int i = 0; i < 6; ++i)
      for(int j = i + 1; j < 6; ++j)
        lower[i][j] = std::numeric_limits<double>::quiet_NaN(); // is not read
    const auto x = I::Symmetric_solver<6>(lower).solve(b);
    for(int i = 0; i < 6; ++i)
      CHECK(std::inner_product(x.begin(), x.end(), a[i].begin(), 0.) == Approx(b[i]).margin(1e-10));
  }
  const I::Symmetric_solver<3> singular({{{2, 0, 0}, {0, 0, 0}, {0, 0, 4}}});
  CHECK(singular.solve({2, 1, 2}) == std::array<double, 3>{1, 0, 0.5});
}

TEST_CASE("boxes hold their points, and do not overflow", "[algebra]")
{
  Random random;
  Positions points(100);
  for(vec3& p : points)
    p = {random.number(-1, 3), random.number(5, 6), random.number(-9, -1)};
  const I::Bounding_box box(points);
  for(const vec3& p : points)
    for(double offset : {p.x - box.centre().x, p.y - box.centre().y, p.z - box.centre().z})
      CHECK(std::abs(offset) <= box.half_size() * (1 + 1e-15));
  CHECK(box.half_size() == Approx(4).epsilon(0.1));
  constexpr double most = std::numeric_limits<double>::max();
  const I::Bounding_box huge(Positions{{-most, 0, 0}, {most, 0, 0}});
  CHECK((huge.half_size() == most && huge.centre().x == 0));
  CHECK(I::Bounding_box(Positions{{most / 2, 0, 0}, {most, 0, 0}}).centre().x == 0.75 * most);
  CHECK(I::Bounding_box(Positions{{1, 2, 3}}).half_size() == 1);
}

TEST_CASE("histograms count all weight, what lies outside in the end bins, and shares move smoothly", "[algebra]")
{
  I::Histogram bins(4, 0, 2);
  for(double value : {-1., 0.1, 0.4, 0.6, 1.9, 2., 7.})
    bins.add(value, 0.5);
  CHECK(bins.shares() == std::vector<double>{3. / 7, 1. / 7, 0, 3. / 7});

  for(double value = -0.3; value < 2.3; value += 0.01) {
    I::Histogram smooth(4, 0, 2);
    smooth.add_interpolated(value, 3);
    const std::vector<double> shares = smooth.shares();
    CHECK(std::accumulate(shares.begin(), shares.end(), 0.) == Approx(1));
    double mean = 0;
    for(int k = 0; k < 4; ++k) {
      CHECK((shares[k] >= 0 && shares[k] <= 1));
      mean += shares[k] * (0.25 + 0.5 * k);
    }
    CHECK(mean == Approx(std::clamp(value, 0.25, 1.75)));
  }
}

TEST_CASE("vectors of any length are scaled to the box of size one", "[algebra]")
{
  for(double size : {1e-300, 1e-3, 1., 1e300}) {
    const vec3 p = I::scaled_to_unit_box({size, -3 * size, 2 * size});
    CHECK(distance(p, {1 / 3., -1, 2 / 3.}) < 1e-15);
  }
  CHECK(distance(I::scaled_to_unit_box({0, 0, 0}), {0, 0, 0}) == 0);
}

TEST_CASE("the nearest row is that of all comparisons, and the first of several", "[algebra]")
{
  const int number = GENERATE(1, 15, 16, 17, 250), others = GENERATE(1, 4, 7), columns = GENERATE(1, 6, 33);
  std::minstd_rand random;
  const auto digits = [&](int n) { // few different numbers: sums have no rounding, and there are ties
    std::vector<float> result(n);
    for(float& x : result)
      x = static_cast<float>(random() % 3);
    return result;
  };
  const std::vector<float> row = digits(number * columns), other = digits(others * columns);
  int calls = 0;
  const auto check = [&](int r, int nearest, float square) {
    ++calls;
    int first = 0;
    float least = std::numeric_limits<float>::infinity();
    for(int s = 0; s < number; ++s) {
      float sum = 0;
      for(int k = 0; k < columns; ++k)
        sum += std::pow(other[r * columns + k] - row[s * columns + k], 2.F);
      if(sum < least) {
        least = sum;
        first = s;
      }
    }
    CHECK(nearest == first);
    CHECK(square == least);
  };
  I::Nearest_rows(row.data(), number, columns).for_each_row_of(other.data(), others, check);
  CHECK(calls == others);
}
