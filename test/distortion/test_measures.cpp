// SPDX-License-Identifier: GPL-3.0-or-later
// The measures per face of measure_distortion.h against singular values from a library, and their summary.

#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace test;

namespace {

using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

/// A face in coordinates of its plane: columns are two edges.
Eigen::Matrix2d in_plane(const Point& a, const Point& b, const Point& c)
{
  const Vector e = b - a, g = c - a, x = e / std::sqrt(e.squared_length()), n = CGAL::cross_product(e, g);
  const Vector y = CGAL::cross_product(n, x) / std::sqrt(n.squared_length());
  Eigen::Matrix2d columns;
  columns << e * x, g * x, e * y, g * y;
  return columns;
}

struct Expected {
  std::vector<double> dilatation, energy, length_change, area_weight, angle;
};

/// By singular value decomposition.
Expected expected(const Soup& soup, const Sphere& sphere)
{
  double source = 0, target = 0;
  std::vector<Eigen::Vector2d> singular;
  Expected result;
  for(const auto& f : soup.faces) {
    const Eigen::Matrix2d p = in_plane(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]);
    const Eigen::Matrix2d v = in_plane(sphere[f[0]], sphere[f[1]], sphere[f[2]]);
    source += p.determinant() / 2;
    target += v.determinant() / 2;
    singular.push_back(Eigen::JacobiSVD<Eigen::Matrix2d>(v * p.inverse()).singularValues());
    result.area_weight.push_back(p.determinant() / 2);
    double sum = 0;
    for(std::size_t k = 0; k < 3; ++k) {
      const auto angle = [&](const Vector& a, const Vector& b) {
        return std::acos(a * b / std::sqrt(a.squared_length() * b.squared_length()));
      };
      const Point &o = soup.points[f[k]], &a = soup.points[f[(k + 1) % 3]], &b = soup.points[f[(k + 2) % 3]];
      const Vector n = sphere[f[k]] - CGAL::ORIGIN; // the angle of great circles is that of their planes
      const Vector first = CGAL::cross_product(n, sphere[f[(k + 1) % 3]] - CGAL::ORIGIN);
      const Vector second = CGAL::cross_product(n, sphere[f[(k + 2) % 3]] - CGAL::ORIGIN);
      sum += std::abs(angle(first, second) - angle(a - o, b - o));
    }
    result.angle.push_back(sum / 3);
  }
  for(const Eigen::Vector2d& s : singular) {
    const Eigen::Vector2d t = s * std::sqrt(source / target);
    result.dilatation.push_back(s[0] / s[1]);
    result.energy.push_back(t[0] * t[0] + t[1] * t[1] + 1 / (t[0] * t[0]) + 1 / (t[1] * t[1]));
    result.length_change.push_back(std::max(t[0], 1 / t[1]));
  }
  return result;
}

} // namespace

TEST_CASE("dilatation, symmetric Dirichlet energy and angles against a decomposition", "[measures]")
{
  const Soup soup = spiky_star(3, 1);
  Settings settings;
  settings.weights = Weights::BARYCENTRIC;
  const Sphere sphere = solve_or_throw(soup, settings);
  const Mesh mesh = make_mesh(soup);
  const Expected e = expected(soup, sphere);
  std::map<Face, double> dilatation, energy, angle;
  const auto [d_min, d_max] = SP::face_dilatation(mesh, on(sphere), Writable_map<Face, double>{&dilatation});
  const auto [e_min, e_max] = SP::face_symmetric_dirichlet(mesh, on(sphere), Writable_map<Face, double>{&energy});
  const auto [a_min, a_max] = SP::face_angle_distortion(mesh, on(sphere), Writable_map<Face, double>{&angle});
  for(Face f : faces(mesh)) {
    CHECK(dilatation.at(f) == Approx(e.dilatation[f]).epsilon(1e-7));
    CHECK(energy.at(f) == Approx(e.energy[f]).epsilon(1e-9));
    CHECK(angle.at(f) == Approx(e.angle[f]).margin(1e-9));
  }
  CHECK(d_min == Approx(*std::min_element(e.dilatation.begin(), e.dilatation.end())).epsilon(1e-7));
  CHECK(d_max == Approx(*std::max_element(e.dilatation.begin(), e.dilatation.end())).epsilon(1e-7));
  CHECK(e_min >= 4);
  CHECK(e_max > 10);
  CHECK(a_min >= 0);
  CHECK(a_max < std::acos(-1.));
  CHECK(d_min >= 1);

  const SP::Distortion_summary summary = SP::distortion_summary(mesh, on(sphere));
  double total = 0, mean = 0;
  for(std::size_t f = 0; f < e.energy.size(); ++f) {
    total += e.area_weight[f];
    mean += e.area_weight[f] * e.energy[f];
  }
  CHECK(summary.symmetric_dirichlet.mean == Approx(mean / total).epsilon(1e-9));
  CHECK(summary.symmetric_dirichlet.min == e_min);
  CHECK(summary.symmetric_dirichlet.max == e_max);
  CHECK(summary.spherical_symmetric_dirichlet.mean == Approx(mean / total).epsilon(0.2)); // fine triangles
  CHECK(summary.spherical_symmetric_dirichlet.mean != summary.symmetric_dirichlet.mean);
  CHECK(summary.degenerate_faces == 0);

  std::map<Face, double> change;
  const Readable_map<Vertex, Point> seven_times = {
    [&](const Vertex& v) { return CGAL::ORIGIN + 7 * (sphere[v] - CGAL::ORIGIN); }};
  const SP::Length_changes changes = SP::face_length_changes(mesh, seven_times, Writable_map<Face, double>{&change});
  double large = 0;
  for(Face f : faces(mesh)) {
    CHECK(change.at(f) == Approx(e.length_change[f]).epsilon(1e-7));
    large += change.at(f) > SP::Length_changes::large ? e.area_weight[f] : 0;
  }
  CHECK(changes.factor.max == Approx(*std::max_element(e.length_change.begin(), e.length_change.end())).epsilon(1e-7));
  CHECK(large > 0);
  CHECK(changes.share_of_large == Approx(large / total).epsilon(1e-9));
}

TEST_CASE("lengths of faces without area do not change, and those of faces that lose theirs change without bound",
          "[measures]")
{
  Soup soup = icosphere(1);
  Sphere images = soup.points;
  soup.points[soup.faces[0][0]] = soup.points[soup.faces[0][1]];
  images[soup.faces[7][0]] = images[soup.faces[7][1]];
  const Mesh mesh = make_mesh(soup);
  std::map<Face, double> change;
  const SP::Length_changes changes = SP::face_length_changes(mesh, on(images), Writable_map<Face, double>{&change});
  CHECK(change.at(Face(0)) == 1);
  CHECK(change.at(Face(7)) == std::numeric_limits<double>::infinity());
  CHECK(changes.factor.max == std::numeric_limits<double>::infinity());
  CHECK(changes.factor.median < SP::Length_changes::large);
  CHECK(changes.share_of_large < 0.2);
}

TEST_CASE("an isometry of the inscribed polyhedron has energy 4 and dilatation 1, at any size and place", "[measures]")
{
  const Soup sphere = icosphere(2);
  const auto rotation = random_rotation(1);
  const double size = GENERATE(1., 1e-150, 1e150, 1e-3), shift = GENERATE(0., 1e6);
  const Soup soup = transformed(sphere, [&](const Point& p) {
    const Point q = test::apply(rotation, p);
    return Point(size * (q.x() + shift), size * (q.y() - shift), size * q.z());
  });
  const Mesh mesh = make_mesh(soup);
  const SP::Distortion_summary s = SP::distortion_summary(mesh, on(sphere.points));
  CAPTURE(size, shift);
  const double tolerance = shift > 0 ? 1e-4 : 1e-7;
  CHECK(s.symmetric_dirichlet.max == Approx(4).epsilon(tolerance));
  CHECK(s.symmetric_dirichlet.min == Approx(4).epsilon(tolerance));
  CHECK(s.dilatation.max == Approx(1).epsilon(tolerance));
  std::map<Face, double> change;
  CHECK(SP::face_length_changes(mesh, on(sphere.points), Writable_map<Face, double>{&change}).factor.max ==
        Approx(1).epsilon(std::sqrt(tolerance)));
  CHECK(std::abs(s.log_area_stretch.mean) < 0.01); // spherical triangles are a little larger than flat ones
  CHECK(s.log_area_stretch.deviation < 0.02);
  CHECK(s.angle_distortion.max < 0.02);
}

TEST_CASE("measures per vertex are means over faces", "[measures]")
{
  const Soup soup = bumpy_sphere(2);
  const Sphere sphere = icosphere(2).points;
  const Mesh mesh = make_mesh(soup);
  std::map<Face, double> of_face;
  std::map<Vertex, double> of_vertex, stretch;
  SP::face_log_area_stretch(mesh, on(sphere), Writable_map<Face, double>{&of_face});
  const auto range = SP::mean_over_faces(mesh, Readable_map<Face, double>{[&](Face f) { return of_face.at(f); }},
                                         Writable_map<Vertex, double>{&of_vertex});
  CHECK(range == SP::vertex_log_area_stretch(mesh, on(sphere), Writable_map<Vertex, double>{&stretch}));
  CHECK(of_vertex == stretch);
}

TEST_CASE("quantiles count faces by their area", "[measures]")
{
  SP::internal::Host_array<double> values, weights;
  for(int k = 100; k > 0; --k) {
    values.push_back(k);
    weights.push_back(1);
  }
  values.insert(values.end(), {1000, -1}); // half of all, and nothing
  weights.insert(weights.end(), {100, 0});
  const SP::Distribution d = SP::internal::distribution(SP::internal::Host_loop(), values, weights);
  CHECK(d.min == 1);
  CHECK(d.max == 1000);
  CHECK(d.percentile_1 == 2);
  CHECK(d.percentile_5 == 10);
  CHECK(d.median == 100);
  CHECK(d.percentile_95 == 1000);
  CHECK(d.percentile_99 == 1000);
  CHECK(d.mean == Approx((5050 + 100000) / 200.));
}

TEST_CASE("where a value is infinite, so are mean and deviation", "[measures]")
{
  const double infinity = std::numeric_limits<double>::infinity();
  SP::internal::Host_array<double> values, weights;
  values.insert(values.end(), {1, 2, infinity});
  weights.insert(weights.end(), {1, 1, 1});
  const SP::Distribution d = SP::internal::distribution(SP::internal::Host_loop(), values, weights);
  CHECK(d.mean == infinity);
  CHECK(d.deviation == infinity);
  CHECK(d.median == 2);
}

TEST_CASE("quantiles of many values are those of the sorted ones", "[measures]")
{
  const int n = GENERATE(1, 2, 100, 5000, 100000);
  const int different = GENERATE(1, 3, 1000000); // values
  std::mt19937 random(n);
  SP::internal::Host_array<double> values(n), weights(n);
  std::vector<std::pair<double, double>> sorted;
  double total = 0;
  for(int i = 0; i < n; ++i) {
    values[i] = std::exp(double(random() % different) / different * 50);
    weights[i] = 1 + random() % 8; // whole numbers, whose sums are exact
    if(i % 7 == 1)
      values[i] = std::numeric_limits<double>::infinity();
    if(i % 5 == 2)
      weights[i] = 0;
    if(weights[i] > 0)
      sorted.emplace_back(values[i], weights[i]);
    total += weights[i];
  }
  std::sort(sorted.begin(), sorted.end());
  const auto quantile = [&](double share) {
    double sum = 0;
    for(const auto& [value, weight] : sorted)
      if((sum += weight) >= share * total)
        return value;
    return sorted.back().first;
  };
  CAPTURE(n, different);
  const SP::Distribution d = SP::internal::distribution(SP::internal::Host_loop(), values, weights);
  CHECK(d.min == sorted.front().first);
  CHECK(d.percentile_1 == quantile(.01));
  CHECK(d.percentile_5 == quantile(.05));
  CHECK(d.median == quantile(.5));
  CHECK(d.percentile_95 == quantile(.95));
  CHECK(d.percentile_99 == quantile(.99));
  CHECK(d.max == sorted.back().first);
}

TEST_CASE("faces without area do not count", "[measures]")
{
  const Soup soup = coincident_points();
  const Mesh mesh = make_mesh(soup);
  Settings settings;
  settings.weights = Weights::BARYCENTRIC;
  const Sphere sphere = solve_or_throw(soup, settings);
  const SP::Distortion_summary s = SP::distortion_summary(mesh, on(sphere));
  CHECK(s.degenerate_faces == 2);
  CHECK(std::isfinite(s.dilatation.max));
  CHECK(std::isfinite(s.symmetric_dirichlet.mean));
  std::map<Face, double> dilatation;
  CHECK(SP::face_dilatation(mesh, on(sphere), Writable_map<Face, double>{&dilatation}).second ==
        std::numeric_limits<double>::infinity());
}

TEST_CASE("small faces are measured as large ones are", "[measures]")
{
  const Soup sphere = icosphere(3);
  const auto dilatations = [&sphere](int exponent) {
    const Mesh mesh = make_mesh(transformed(sphere, [exponent](const Point& p) { // the lower half, round the origin
      const double scale = p.z() > 0 ? 1 : std::ldexp(1, exponent);
      return Point(scale * p.x(), 2 * scale * p.y(), scale * p.z());
    }));
    std::map<Face, double> result;
    SP::face_dilatation(mesh, on(sphere.points), Writable_map<Face, double>{&result});
    for(std::size_t f = 0; f < sphere.faces.size(); ++f)
      if(std::any_of(sphere.faces[f].begin(), sphere.faces[f].end(),
                     [&](std::size_t v) { return sphere.points[v].z() > 0; }))
        result.erase(Face(static_cast<unsigned>(f)));
    return result;
  };
  CHECK(dilatations(0).size() > 100);
  CHECK((dilatations(0) == dilatations(-40)));
}

TEST_CASE("means over faces: a vertex without faces, and a boundary, are errors", "[measures]")
{
  std::map<Vertex, double> mean;
  const Writable_map<Vertex, double> means = {&mean};
  const Readable_map<Face, double> one = {[](Face) { return 1.; }};
  CHECK_THROWS_AS(SP::mean_over_faces(make_mesh(isolated_vertex()), one, means), SP::Error);
  CHECK_THROWS_AS(SP::mean_over_faces(make_mesh(open_sphere(2)), one, means), SP::Error);
  CHECK(mean.empty());
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("measures are the same bits on several threads", "[measures]")
{
  const CGAL::Parallel_tag several;
  const Mesh mesh = make_mesh(bumpy_sphere(6)), round = make_mesh(icosphere(6));
  const auto sphere = round.points();
  const auto check = [&](const auto& measure) {
    std::map<Face, double> a, b;
    CHECK(measure(CGAL::Sequential_tag(), Writable_map<Face, double>{&a}) ==
          measure(several, Writable_map<Face, double>{&b}));
    CHECK(a == b);
  };
  check([&](auto policy, auto map) { return SP::face_log_area_stretch(policy, mesh, sphere, map); });
  check([&](auto policy, auto map) { return SP::face_angle_distortion(policy, mesh, sphere, map); });
  check([&](auto policy, auto map) { return SP::face_dilatation(policy, mesh, sphere, map); });
  check([&](auto policy, auto map) { return SP::face_symmetric_dirichlet(policy, mesh, sphere, map); });
  check([&](auto policy, auto map) {
    const SP::Distribution factor = SP::face_length_changes(policy, mesh, sphere, map).factor;
    return std::pair(factor.median, factor.deviation);
  });
  std::map<Vertex, double> a, b;
  SP::vertex_log_area_stretch(mesh, sphere, Writable_map<Vertex, double>{&a});
  SP::vertex_log_area_stretch(several, mesh, sphere, Writable_map<Vertex, double>{&b});
  CHECK(a == b);
  CHECK(SP::number_of_flipped_faces(several, mesh, sphere) == 0);
  CHECK(SP::degree_of_map(several, mesh, sphere) == 1);
  const SP::Distortion_summary x = SP::distortion_summary(mesh, sphere),
                               y = SP::distortion_summary(several, mesh, sphere);
  for(const auto member : {&SP::Distortion_summary::log_area_stretch, &SP::Distortion_summary::angle_distortion,
                           &SP::Distortion_summary::dilatation, &SP::Distortion_summary::symmetric_dirichlet,
                           &SP::Distortion_summary::spherical_symmetric_dirichlet}) {
    CHECK((x.*member).mean == (y.*member).mean);
    CHECK((x.*member).deviation == (y.*member).deviation);
    CHECK((x.*member).percentile_95 == (y.*member).percentile_95);
  }
}
#endif
