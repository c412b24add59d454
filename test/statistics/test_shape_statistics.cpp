// SPDX-License-Identifier: GPL-3.0-or-later
// shape_statistics.h

#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/harmonic_alignment.h>
#include <CGAL/Spherical_parameterization/harmonic_grids.h>
#include <CGAL/Spherical_parameterization/shape_atlas.h>
#include <CGAL/Spherical_parameterization/shape_statistics.h>
#include <CGAL/Spherical_parameterization/spherical_harmonics.h>

#include <CGAL/tags.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

using namespace test;

namespace {

using SP::Shape_points;
using Coefficients = SP::Harmonic_coefficients;
using Shapes = std::vector<Shape_points>;

const CGAL::Sequential_tag one_core;

constexpr double pi = 3.14159265358979323846;

Shape_points points_of(const Soup& soup)
{
  Shape_points shape;
  for(const Point& p : soup.points)
    shape.push_back({p.x(), p.y(), p.z()});
  return shape;
}

Shape_points random_shape(std::size_t vertices, std::mt19937& random)
{
  std::normal_distribution<double> normal;
  Shape_points shape(vertices);
  for(auto& p : shape)
    for(double& x : p)
      x = normal(random);
  return shape;
}

/// The mean over the vertices of the inner product.
double inner(const Shape_points& a, const Shape_points& b, const std::vector<double>& weights)
{
  double sum = 0, all = 0;
  for(std::size_t j = 0; j < a.size(); ++j) {
    const double w = weights.empty() ? 1 : weights[j];
    all += w;
    for(std::size_t c = 0; c < 3; ++c)
      sum += w * a[j][c] * b[j][c];
  }
  return sum / all;
}

void add(Shape_points& a, double factor, const Shape_points& b)
{
  for(std::size_t j = 0; j < a.size(); ++j)
    for(std::size_t c = 0; c < 3; ++c)
      a[j][c] += factor * b[j][c];
}

double distance(Shape_points a, const Shape_points& b, const std::vector<double>& weights = {})
{
  add(a, -1, b);
  return std::sqrt(inner(a, a, weights));
}

/// Shapes of which everything is known: the mean, modes that are orthonormal, and scores whose mean is 0.
struct Known {
  Shape_points mean;
  std::vector<Shape_points> modes;
  std::vector<std::vector<double>> scores; ///< by shape
  std::vector<double> variances;
  Shapes shapes;
};

Known known_set(int shapes, const std::vector<double>& deviations, const std::vector<double>& weights,
                std::size_t vertices)
{
  std::mt19937 random(1);
  Known known;
  known.mean = random_shape(vertices, random);
  for(const double deviation : deviations) { // Gram and Schmidt
    Shape_points mode = random_shape(vertices, random);
    for(const Shape_points& other : known.modes)
      add(mode, -inner(mode, other, weights), other);
    const double length = std::sqrt(inner(mode, mode, weights));
    add(mode, 1 / length - 1, Shape_points(mode));
    known.modes.push_back(mode);
    known.variances.push_back(deviation * deviation * shapes / (shapes - 1.));
  }
  for(int i = 0; i < shapes; ++i) { // waves of different lengths
    std::vector<double> row;
    for(std::size_t k = 0; k < deviations.size(); ++k)
      row.push_back(deviations[k] * std::sqrt(2.) * std::cos(2 * pi * (k + 1.) * (i + .3) / shapes));
    Shape_points shape = known.mean;
    for(std::size_t k = 0; k < row.size(); ++k)
      add(shape, row[k], known.modes[k]);
    known.scores.push_back(row);
    known.shapes.push_back(shape);
  }
  return known;
}

/// Random shapes near a body without symmetry, all in poses and places of their own.
Shapes scattered_set(int shapes, double noise, unsigned seed)
{
  std::mt19937 random(seed);
  const Shape_points body = points_of(bumpy_sphere(2));
  Shapes set;
  for(int i = 0; i < shapes; ++i) {
    Shape_points shape = body;
    add(shape, noise, random_shape(body.size(), random));
    const auto rows = random_rotation(seed + i);
    for(auto& p : shape) {
      const Point q = test::apply(rows, Point(p[0], p[1], p[2]));
      p = {q.x() + i, q.y() - 2 * i, q.z() + 3};
    }
    set.push_back(shape);
  }
  return set;
}

std::vector<double> variances_of(Shapes shapes, const SP::Procrustes& method = {})
{
  SP::align_shapes(one_core, shapes, method);
  return SP::shape_statistics(one_core, shapes).variances;
}

std::vector<double> random_weights(std::size_t vertices)
{
  std::mt19937 random(5);
  std::vector<double> weights(vertices);
  for(double& w : weights)
    w = std::uniform_real_distribution<double>(0, 3)(random);
  weights[7] = 0;
  return weights;
}

} // namespace

TEST_CASE("a set made from known modes gives these modes, variances and scores back", "[statistics]")
{
  const bool is_weighted = GENERATE(false, true);
  const std::size_t vertices = GENERATE(20, 3000); // one block of rows, many
  const std::vector<double> weights = is_weighted ? random_weights(vertices) : std::vector<double>();
  const Known known = known_set(11, {2, 1, .01, 1e-5}, weights, vertices);
  const auto found = SP::shape_statistics(one_core, known.shapes, weights);
  CHECK(distance(found.mean, known.mean, weights) < 1e-12);
  REQUIRE(found.variances.size() == 4);
  CHECK(found.total_variance ==
        Approx(std::accumulate(known.variances.begin(), known.variances.end(), 0.)).epsilon(1e-12));
  for(std::size_t k = 0; k < 4; ++k) {
    const double rounding = 1e-13 * std::sqrt(known.variances[0] / known.variances[k]);
    CHECK(found.variances[k] == Approx(known.variances[k]).epsilon(10 * rounding));
    CHECK(inner(found.modes[k], found.modes[k], weights) == Approx(1).epsilon(10 * rounding));
    const double sign = inner(found.modes[k], known.modes[k], weights) < 0 ? -1 : 1;
    Shape_points difference = found.modes[k];
    add(difference, -sign, known.modes[k]);
    CHECK(std::sqrt(inner(difference, difference, weights)) < 10 * rounding);
    double longest = 0;
    for(std::size_t i = 0; i < known.shapes.size(); ++i) {
      CHECK(found.scores[i][k] == Approx(sign * known.scores[i][k]).margin(1e-12));
      longest = std::abs(found.scores[i][k]) > std::abs(longest) ? found.scores[i][k] : longest;
    }
    CHECK(longest > 0);
  }
  for(std::size_t i = 0; i < known.shapes.size(); ++i)
    CHECK(distance(SP::shape_of_scores(found, found.scores[i]), known.shapes[i], weights) < 1e-12);
}

TEST_CASE("fewer modes are the first ones, and the total variance stays", "[statistics]")
{
  const Known known = known_set(7, {3, 2, 1}, {}, 30);
  const auto all = SP::shape_statistics(one_core, known.shapes),
             some = SP::shape_statistics(one_core, known.shapes, {}, 2);
  CHECK(some.modes.size() == 2);
  CHECK(some.scores[0].size() == 2);
  CHECK(some.variances == std::vector<double>(all.variances.begin(), all.variances.begin() + 2));
  CHECK(some.total_variance == all.total_variance);
  CHECK(SP::shape_statistics(one_core, known.shapes, {}, 0).modes.empty());
}

TEST_CASE("more shapes than coordinates have no more modes than coordinates", "[statistics]")
{
  std::mt19937 random(3);
  Shapes shapes;
  for(int i = 0; i < 50; ++i)
    shapes.push_back(random_shape(4, random));
  const auto found = SP::shape_statistics(one_core, shapes);
  CHECK(found.variances.size() == 12);
  CHECK(std::accumulate(found.variances.begin(), found.variances.end(), 0.) == Approx(found.total_variance));
}

TEST_CASE("equal shapes, and one alone, have no modes", "[statistics]")
{
  const Shape_points shape = points_of(icosphere(1));
  for(int n : {1, 5}) {
    const auto found = SP::shape_statistics(one_core, Shapes(n, shape));
    CHECK(found.modes.empty());
    CHECK(found.total_variance < 1e-28);
    CHECK(distance(found.mean, shape) < 1e-15);
  }
  const std::vector<double> errors = SP::left_out_errors(one_core, Shapes(3, shape));
  REQUIRE(errors.size() == 1); // without a mode
  CHECK(errors[0] < 1e-15);
}

TEST_CASE("shapes have no more leave-out errors than modes", "[statistics]")
{
  const Shapes shapes = scattered_set(50, 0.2, 3);
  Shapes few(shapes.size(), Shape_points(3));
  for(std::size_t i = 0; i < shapes.size(); ++i)
    std::copy_n(shapes[i].begin(), 3, few[i].begin());
  CHECK(SP::shape_statistics(one_core, few).modes.size() == 9);
  CHECK(SP::left_out_errors(one_core, few).size() == 10);
}

TEST_CASE("far from the origin modes stay orthonormal", "[statistics]")
{
  Shapes shapes = scattered_set(12, 1e-3, 4);
  for(std::size_t i = 0; i < shapes.size(); ++i) // the first mode is much longer than the others
    for(auto& p : shapes[i]) {
      p[0] *= 1 + double(i);
      p[1] += 1 << 20;
    }
  const auto found = SP::shape_statistics(one_core, shapes);
  REQUIRE(found.modes.size() == 11);
  for(std::size_t k = 0; k < found.modes.size(); ++k)
    for(std::size_t l = 0; l <= k; ++l) {
      double product = 0;
      for(std::size_t v = 0; v < shapes[0].size(); ++v)
        for(std::size_t c = 0; c < 3; ++c)
          product += found.modes[k][v][c] * found.modes[l][v][c] / double(shapes[0].size());
      CHECK(product == Approx(k == l ? 1 : 0).margin(1e-6));
    }
}

TEST_CASE("a shape without size is not scaled up, wherever it is", "[statistics]")
{
  for(double place : {0., 1., 0.1}) {
    Shapes shapes = scattered_set(4, 0.2, 5);
    for(auto& p : shapes[1])
      p = {place, place, place};
    SP::Procrustes method;
    method.scale = true;
    CHECK(SP::align_shapes(one_core, shapes, method).motions[1].scale == 1);
    CHECK((shapes[1] == Shape_points(shapes[1].size(), {0, 0, 0})));
  }
}

TEST_CASE("rotating, moving and reordering shapes changes nothing but the order", "[statistics]")
{
  Shapes still = scattered_set(8, 0.05, 10);
  SP::Procrustes_alignment alignment;
  Shapes aligned = still;
  alignment = SP::align_shapes(one_core, aligned);
  REQUIRE(alignment.has_converged);
  const auto expected = SP::shape_statistics(one_core, aligned);
  REQUIRE(expected.variances.size() == 7);
  // what noise there is: the poses are gone
  CHECK(alignment.deviation == Approx(0.05 * std::sqrt(3.)).epsilon(0.1));

  Shapes moved = still;
  for(std::size_t i = 0; i < moved.size(); ++i) {
    const auto rows = random_rotation(static_cast<unsigned>(100 + i));
    for(auto& p : moved[i]) {
      const Point q = test::apply(rows, Point(p[0], p[1], p[2]));
      p = {q.x() + 5, q.y(), q.z() - double(i)};
    }
  }
  std::rotate(moved.begin(), moved.begin() + 3, moved.end());
  std::swap(moved[0], moved[5]);
  const std::vector<double> found = variances_of(moved);
  REQUIRE(found.size() == expected.variances.size());
  for(std::size_t k = 0; k < found.size(); ++k)
    CHECK(found[k] == Approx(expected.variances[k]).epsilon(1e-7));
}

TEST_CASE("the motions of an alignment lead to the aligned shapes, and the first keeps its rotation", "[statistics]")
{
  const bool scale = GENERATE(false, true);
  const Shapes before = scattered_set(5, 0.1, 20);
  Shapes after = before;
  const auto alignment = SP::align_shapes(one_core, after, SP::Procrustes{true, scale});
  CHECK(alignment.motions[0].rotation == SP::Similarity().rotation);
  for(std::size_t i = 0; i < before.size(); ++i) {
    const SP::Similarity& motion = alignment.motions[i];
    CHECK((motion.scale == 1) == !scale);
    for(std::size_t j = 0; j < before[i].size(); ++j)
      for(std::size_t a = 0; a < 3; ++a) {
        double x = motion.translation[a];
        for(std::size_t b = 0; b < 3; ++b)
          x += motion.scale * motion.rotation[a][b] * before[i][j][b];
        CHECK(after[i][j][a] == Approx(x).margin(1e-12));
      }
  }
}

TEST_CASE("no small rotation of a shape brings the set closer together", "[statistics]")
{
  Shapes shapes = scattered_set(6, 0.2, 30);
  SP::align_shapes(one_core, shapes);
  const double least = SP::shape_statistics(one_core, shapes).total_variance;
  for(std::size_t i = 0; i < shapes.size(); ++i)
    for(int axis = 0; axis < 3; ++axis)
      for(double angle : {-1e-3, 1e-3}) {
        Shapes changed = shapes;
        for(auto& p : changed[i]) {
          double &x = p[(axis + 1) % 3], &y = p[(axis + 2) % 3];
          const double turned = std::cos(angle) * x - std::sin(angle) * y;
          y = std::sin(angle) * x + std::cos(angle) * y;
          x = turned;
        }
        CHECK(SP::shape_statistics(one_core, changed).total_variance > least);
      }
}

TEST_CASE("with scaling, sizes are no differences", "[statistics]")
{
  Shapes shapes(4, points_of(bumpy_sphere(1)));
  for(std::size_t i = 0; i < shapes.size(); ++i)
    for(auto& p : shapes[i])
      for(double& x : p)
        x *= 1. + double(i);
  CHECK(variances_of(shapes).size() == 1);
  SP::Procrustes method;
  method.scale = true;
  const auto alignment = SP::align_shapes(one_core, shapes, method);
  CHECK(alignment.deviation < 1e-14);
  CHECK(alignment.motions[0].scale == Approx(std::sqrt(30. / 4)));
}

TEST_CASE("errors of the left out are those of statistics of the others", "[statistics]")
{
  const int groups = GENERATE(0, 3);
  std::mt19937 random(8);
  Shapes shapes;
  for(int i = 0; i < 7; ++i)
    shapes.push_back(random_shape(40, random));
  const std::vector<double> weights = random_weights(40);
  const std::vector<double> errors = SP::left_out_errors(one_core, shapes, weights, groups);
  REQUIRE(errors.size() == (groups == 0 ? 6 : 4));
  std::vector<double> square(errors.size(), 0);
  for(std::size_t i = 0; i < shapes.size(); ++i) {
    Shapes others;
    for(std::size_t j = 0; j < shapes.size(); ++j)
      if(groups == 0 ? j != i : j % 3 != i % 3)
        others.push_back(shapes[j]);
    const auto statistics = SP::shape_statistics(one_core, others, weights);
    Shape_points rest = shapes[i];
    add(rest, -1, statistics.mean);
    for(std::size_t k = 0; k < errors.size(); ++k) {
      if(k > 0 && k <= statistics.modes.size())
        add(rest, -inner(rest, statistics.modes[k - 1], weights), statistics.modes[k - 1]);
      square[k] += inner(rest, rest, weights) / 7;
    }
  }
  for(std::size_t k = 0; k < errors.size(); ++k)
    CHECK(errors[k] == Approx(std::sqrt(square[k])).epsilon(1e-10));
}

TEST_CASE("of two shapes everything is known of the quality of the model", "[statistics]")
{
  const Known known = known_set(2, {2}, {}, 30);
  const SP::Model_quality quality = SP::model_quality(one_core, known.shapes, {}, 0, 20000, 7);
  const double half = distance(known.shapes[0], known.shapes[1]) / 2, variance = 2 * half * half;
  CHECK(quality.compactness.size() == 2);
  CHECK(quality.compactness[0] == 0);
  CHECK(quality.compactness[1] == Approx(variance));
  REQUIRE(quality.generalization.size() == 1);
  CHECK(quality.generalization[0] == Approx(2 * half));
  CHECK(quality.specificity[0] == Approx(half)); // the mean
  CHECK(quality.specificity_error[0] < 1e-12);
  // | |b| - half | for normal b of that variance: E |b| - half + 2 E (half - |b|)+
  const double sigma = std::sqrt(variance), t = half / sigma;
  const double density = std::exp(-t * t / 2) / std::sqrt(2 * pi), within = std::erf(t / std::sqrt(2.));
  const double below = half * within - 2 * sigma * (1 / std::sqrt(2 * pi) - density);
  const double expected = sigma * std::sqrt(2 / pi) - half + 2 * below;
  CHECK(std::abs(quality.specificity[1] - expected) < 4 * quality.specificity_error[1]);
  CHECK(quality.specificity_error[1] < 0.01 * quality.specificity[1]);
}

TEST_CASE("compactness rises to the total variance, generalization falls, specificity is a distance", "[statistics]")
{
  std::mt19937 random(3);
  Shapes shapes;
  for(int i = 0; i < 8; ++i)
    shapes.push_back(random_shape(40, random));
  const std::vector<double> weights = GENERATE(std::vector<double>(), std::vector<double>(40, 3.));
  const SP::Model_quality quality = SP::model_quality(one_core, shapes, weights);
  const auto statistics = SP::shape_statistics(one_core, shapes, weights);
  REQUIRE(quality.compactness.size() == 8);
  REQUIRE(quality.specificity.size() == 8);
  CHECK(quality.compactness[3] == Approx(statistics.variances[0] + statistics.variances[1] + statistics.variances[2]));
  CHECK(quality.compactness.back() == Approx(statistics.total_variance));
  CHECK(std::is_sorted(quality.compactness.begin(), quality.compactness.end()));
  CHECK(quality.generalization == SP::left_out_errors(one_core, shapes, weights));
  CHECK(std::is_sorted(quality.generalization.rbegin(), quality.generalization.rend()));
  double nearest = std::numeric_limits<double>::infinity();
  for(const Shape_points& shape : shapes)
    nearest = std::min(nearest, distance(shape, statistics.mean));
  CHECK(quality.specificity[0] == Approx(nearest));
  CHECK(*std::min_element(quality.specificity.begin(), quality.specificity.end()) > 0);
  // another seed is another sample of the same, and four times as many are twice as exact
  const SP::Model_quality other = SP::model_quality(one_core, shapes, weights, 0, 4000, 2);
  for(std::size_t k = 1; k < 8; ++k) {
    CHECK(other.specificity[k] != quality.specificity[k]);
    CHECK(std::abs(other.specificity[k] - quality.specificity[k]) < 4 * quality.specificity_error[k]);
    CHECK(other.specificity_error[k] == Approx(quality.specificity_error[k] / 2).epsilon(0.15));
  }
  CHECK_THROWS_AS(SP::model_quality(one_core, shapes, weights, 0, 1), CGAL::Precondition_exception);
}

TEST_CASE("one component is enough for shapes on a line", "[statistics]")
{
  const Known known = known_set(9, {1}, {}, 50);
  const std::vector<double> errors = SP::left_out_errors(one_core, known.shapes);
  REQUIRE(errors.size() == 2);
  CHECK(errors[0] == Approx(9. / 8)); // the mean of the others is farther away than that of all
  CHECK(errors[1] < 1e-13);
}

TEST_CASE("statistics of coefficients are those of the shapes, over the sphere", "[statistics]")
{
  constexpr int degree = 6;
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<Coefficients> coefficients;
  for(int i = 0; i < 6; ++i) {
    Coefficients c(degree, 3);
    for(double& x : c.values())
      x = normal(random);
    c(1, 1, 0) += 20; // about a sphere, so that there is one best rotation
    c(1, -1, 1) += 15;
    c(1, 0, 2) += 10;
    coefficients.push_back(c);
  }
  const auto grid = SP::Latitude_longitude_grid::gauss_legendre(2 * degree);
  std::vector<std::array<double, 3>> directions;
  std::vector<double> weights;
  for(int row = 0; row < grid.rows(); ++row)
    for(int column = 0; column < grid.columns(); ++column) {
      directions.push_back(grid.direction(row, column));
      weights.push_back(grid.weight(row));
    }
  const auto on_grid = [&](const Coefficients& c) {
    const std::vector<double> values = SP::harmonic_values(one_core, c, directions);
    Shape_points points;
    for(std::size_t j = 0; j < directions.size(); ++j)
      points.push_back({values[3 * j], values[3 * j + 1], values[3 * j + 2]});
    return points;
  };
  Shapes shapes;
  for(const Coefficients& c : coefficients)
    shapes.push_back(on_grid(c));
  const auto of_coefficients = SP::align_shapes(one_core, coefficients);
  const auto of_points = SP::align_shapes(one_core, shapes, {}, weights);
  CHECK(of_coefficients.deviation == Approx(of_points.deviation).epsilon(1e-10));
  for(std::size_t i = 0; i < shapes.size(); ++i)
    for(std::size_t a = 0; a < 3; ++a)
      CHECK(of_coefficients.motions[i].translation[a] == Approx(of_points.motions[i].translation[a]).margin(1e-8));
  const auto a = SP::shape_statistics(one_core, coefficients);
  const auto b = SP::shape_statistics(one_core, shapes, weights);
  REQUIRE(a.variances.size() == 5);
  REQUIRE(b.variances.size() == 5);
  CHECK(distance(on_grid(a.mean), b.mean) < 1e-8);
  for(std::size_t k = 0; k < 5; ++k) {
    CHECK(a.variances[k] == Approx(b.variances[k]).epsilon(1e-8));
    CHECK(distance(on_grid(a.modes[k]), b.modes[k]) < 1e-7);
  }
  const auto errors_a = SP::left_out_errors(one_core, coefficients);
  const auto errors_b = SP::left_out_errors(one_core, shapes, weights);
  for(std::size_t k = 0; k < errors_a.size(); ++k)
    CHECK(errors_a[k] == Approx(errors_b[k]).epsilon(1e-8));
}

TEST_CASE("the variance of the set is the mean of those of its vertices", "[statistics]")
{
  std::mt19937 random(4);
  Shapes shapes;
  for(int i = 0; i < 5; ++i)
    shapes.push_back(random_shape(100, random));
  const std::vector<double> variance = SP::vertex_variances(one_core, shapes);
  CHECK(std::accumulate(variance.begin(), variance.end(), 0.) / 100 ==
        Approx(SP::shape_statistics(one_core, shapes).total_variance));
  CHECK(SP::vertex_variances(one_core, {shapes[0]}) == std::vector<double>(100, 0.));
}

TEST_CASE("vertices count with their area, mean over the shapes", "[statistics]")
{
  const Soup soup = flat_octahedron(2);
  const Shape_points unit = points_of(soup);
  Shape_points larger = unit;
  add(larger, 1, unit);
  const std::vector<double> area = SP::mean_vertex_areas(one_core, make_mesh(soup), {unit, larger});
  CHECK(std::accumulate(area.begin(), area.end(), 0.) == Approx((1 + 4) / 2. * 8 * std::sqrt(3.) / 2));
  for(const double scale : {0x1p-280, 0x1p280}) { // squares of areas are beyond doubles
    Shapes scaled = {unit, larger};
    for(Shape_points& shape : scaled)
      for(auto& p : shape)
        for(double& x : p)
          x *= scale;
    const std::vector<double> other = SP::mean_vertex_areas(one_core, make_mesh(soup), scaled);
    for(std::size_t v = 0; v < area.size(); ++v)
      CHECK(other[v] == scale * scale * area[v]);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("statistics are the same bits on several threads", "[statistics]")
{
  const CGAL::Parallel_tag all_cores;
  std::mt19937 random(6);
  Shapes a;
  for(int i = 0; i < 5; ++i)
    a.push_back(random_shape(20000, random));
  Shapes b = a;
  CHECK(SP::align_shapes(one_core, a).deviation == SP::align_shapes(all_cores, b).deviation);
  CHECK(a == b);
  const auto of_a = SP::shape_statistics(one_core, a), of_b = SP::shape_statistics(all_cores, b);
  CHECK(of_a.variances == of_b.variances);
  CHECK(of_a.modes == of_b.modes);
  CHECK(SP::left_out_errors(one_core, a) == SP::left_out_errors(all_cores, b));
  const auto quality_a = SP::model_quality(one_core, a), quality_b = SP::model_quality(all_cores, b);
  CHECK(quality_a.compactness == quality_b.compactness);
  CHECK(quality_a.specificity == quality_b.specificity);
  CHECK(quality_a.specificity_error == quality_b.specificity_error);
  CHECK(SP::vertex_variances(one_core, a) == SP::vertex_variances(all_cores, b));
}
#endif

TEST_CASE("wrong sets of shapes are refused", "[statistics]")
{
  const Shape_points shape = points_of(icosphere(0));
  Shapes none, two = {shape, Shape_points(shape.begin(), shape.end() - 1)}, nan = {shape, shape};
  nan[1][3][2] = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(SP::shape_statistics(one_core, none), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::shape_statistics(one_core, two), CGAL::Precondition_exception);
  CHECK_THROWS_WITH(SP::align_shapes(one_core, nan), Catch::Contains("vertex 3 of shape 1"));
  for(const double scale : {1e160, 1e-160}) { // squares are beyond the numbers
    Shapes wild = {shape, shape};
    for(auto& point : wild[1])
      for(double& x : point)
        x *= scale;
    CHECK_THROWS_WITH(SP::align_shapes(one_core, wild),
                      Catch::Contains("shape 1") && Catch::Contains("scale the shapes"));
    CHECK_THROWS_AS(SP::mean_vertex_areas(one_core, make_mesh(icosphere(0)), wild), SP::Error);
  }
  const Shapes good(3, shape);
  CHECK_THROWS_AS(SP::shape_statistics(one_core, good, {1, 2}), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::shape_statistics(one_core, good, std::vector<double>(12, 0.)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::shape_statistics(one_core, good, std::vector<double>(12, -1.)), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::left_out_errors(one_core, Shapes{shape}), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::left_out_errors(one_core, good, {}, 4), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::shape_of_scores(SP::shape_statistics(one_core, good), {1.}), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::mean_vertex_areas(one_core, make_mesh(icosphere(1)), good), CGAL::Precondition_exception);
  const SP::Atlas_mesh atlas = SP::icosphere_of_atlas(0);
  for(const auto placement : {SP::Atlas_placement::AS_THEY_STAND, SP::Atlas_placement::RIGID}) {
    CHECK_THROWS_AS(SP::mean_shape(atlas, none, placement), CGAL::Precondition_exception);
    CHECK_THROWS_AS(SP::mean_shape(atlas, Shapes{two[1]}, placement), CGAL::Precondition_exception);
    CHECK_THROWS_AS(SP::mean_shape(atlas, nan, placement), SP::Error);
  }
  std::vector<Coefficients> unlike = {Coefficients(2, 3), Coefficients(3, 3)}, flat = {Coefficients(2, 2)};
  CHECK_THROWS_AS(SP::align_shapes(one_core, unlike), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::align_shapes(one_core, flat), CGAL::Precondition_exception);
}

TEST_CASE("without a policy statistics are those of one core", "[statistics]")
{
  std::mt19937 random(7);
  Shapes a = {random_shape(300, random), random_shape(300, random), random_shape(300, random)}, b = a;
  CHECK(SP::align_shapes(a).deviation == SP::align_shapes(one_core, b).deviation);
  CHECK((a == b));
  CHECK((SP::shape_statistics(a, std::vector<double>(), 1).modes == SP::shape_statistics(one_core, a, {}, 1).modes));
  CHECK(SP::left_out_errors(a) == SP::left_out_errors(one_core, a));
  CHECK(SP::vertex_variances(a) == SP::vertex_variances(one_core, a));
  const Soup soup = icosphere(1);
  CHECK(SP::mean_vertex_areas(make_mesh(soup), Shapes{points_of(soup)}) ==
        SP::mean_vertex_areas(one_core, make_mesh(soup), {points_of(soup)}));
}

TEST_CASE("callback and time limit end statistics, and shapes are where they were", "[statistics]")
{
  std::mt19937 random(8);
  Shapes shapes;
  for(int i = 0; i < 6; ++i)
    shapes.push_back(random_shape(200000, random));
  const auto is_interrupted = [](const SP::Error& e) { return e.code() == SP::Error_code::INTERRUPTED; };
  const auto check = [&](const auto& call, bool is_long) { // loops ask every 5 ms
    Shapes some = shapes;
    CHECK_THROWS_MATCHES(call(some, CGAL::parameters::maximum_running_time(0)), SP::Error,
                         Catch::Predicate<SP::Error>(is_interrupted));
    CHECK((some == shapes));
    if(!is_long)
      return;
    int called = 0;
    const auto say_no = [&](double fraction) {
      CHECK(fraction >= 0);
      CHECK(fraction <= 1);
      return ++called == 0;
    };
    CHECK_THROWS_MATCHES(call(some, CGAL::parameters::callback(say_no)), SP::Error,
                         Catch::Predicate<SP::Error>(is_interrupted));
    CHECK(called == 1);
    CHECK((some == shapes));
  };
  check([](Shapes& s, const auto& np) { SP::align_shapes(s, SP::Procrustes(), std::vector<double>(), np); }, false);
  check([](Shapes& s, const auto& np) { SP::shape_statistics(s, std::vector<double>(), 3, np); }, false);
  check([](Shapes& s, const auto& np) { SP::left_out_errors(s, std::vector<double>(), 0, np); }, true);
  check([](Shapes& s, const auto& np) { SP::vertex_variances(s, np); }, false);
}

TEST_CASE("an atlas is that of any FaceGraph", "[statistics]")
{
  std::vector<Mesh> meshes;
  std::vector<SP::Indexed_triangle_mesh> indexed;
  std::vector<Sphere> spheres;
  Settings settings;
  settings.method = SP::Isometric();
  for(double c : {1.6, 1.8, 2.1}) {
    const Soup soup = ellipsoid(1, 1.3, c, 3);
    meshes.push_back(make_mesh(soup));
    indexed.emplace_back(points_of(soup), soup.faces);
    spheres.push_back(solve_or_throw(soup, settings));
  }
  const auto atlas_of = [&](const auto& some) {
    typedef std::decay_t<decltype(some[0])> Any_mesh;
    typedef typename boost::graph_traits<Any_mesh>::vertex_descriptor Vertex;
    typedef Readable_map<Vertex, Point> Sphere_map;
    std::vector<decltype(SP::mapped_mesh(some[0], Sphere_map()))> maps;
    for(std::size_t i = 0; i < some.size(); ++i)
      maps.push_back(SP::mapped_mesh(
        some[i], Sphere_map{[&spheres, i](const Vertex& v) { return spheres[i][static_cast<std::size_t>(v.idx())]; }}));
    return SP::shape_atlas(maps, 0, 2, SP::icosphere_of_atlas(2));
  };
  const SP::Shape_atlas atlas = atlas_of(meshes), other = atlas_of(indexed);
  CHECK(atlas.refused.empty());
  CHECK((atlas.members == std::vector<std::size_t>{0, 1, 2}));
  CHECK(atlas.statistics.scores.size() == 3);
  CHECK((atlas.shapes == other.shapes));
  CHECK((atlas.statistics.modes == other.statistics.modes));
}

TEST_CASE("without sizes, a shape of any size tells the others how to turn alike", "[statistics]")
{
  const SP::Atlas_mesh atlas = SP::icosphere_of_atlas(2);
  Shapes small;
  for(double c : {1.3, 1.8, 2.1})
    small.push_back(points_of(ellipsoid(1, c * c / 2, c, 2)));
  Shapes large = small;
  for(auto& p : large[1])
    for(double& x : p)
      x *= 128;
  const auto ratios = [&](Shapes& shapes) {
    const auto motions = SP::place_shapes(one_core, atlas, shapes, SP::Atlas_placement::SIMILARITY).motions;
    return std::array<double, 2>{motions[0].scale / motions[2].scale, shapes[0][5][0] / shapes[2][7][2]};
  };
  const auto before = ratios(small), after = ratios(large);
  CHECK(after[0] == Approx(before[0]).epsilon(1e-9));
  CHECK(after[1] == Approx(before[1]).epsilon(1e-9));
}

TEST_CASE("coefficients that are not finite are no shapes", "[statistics]")
{
  std::vector<Coefficients> shapes(3, Coefficients(2, 3));
  shapes[1](1, 0, 2) = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(SP::shape_statistics(shapes), Catch::Contains("l = 1, m = 0 of function 2 of shape 1"));
  CHECK_THROWS_AS(SP::align_shapes(shapes), SP::Error);
  CHECK_THROWS_AS(SP::left_out_errors(shapes), SP::Error);
}
