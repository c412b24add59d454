// SPDX-License-Identifier: GPL-3.0-or-later
// transfer_properties.h and resample.h: data from one map to another.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/align_maps.h>
#include <CGAL/Spherical_parameterization/resample.h>
#include <CGAL/Spherical_parameterization/resampling_weights.h>
#include <CGAL/Spherical_parameterization/shape_statistics.h>
#include <CGAL/boost/graph/helpers.h>

#include <catch2/catch.hpp>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

using namespace test;

namespace {

using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;
using Locator = SP::Spherical_locator<Mesh>;

template <class Value>
Readable_map<Vertex, Value> of_vertex(std::function<Value(Vertex)> f)
{
  return {std::move(f)};
}

} // namespace

TEST_CASE("transfer to the same map gives every vertex its own value", "[transfer]")
{
  const Soup soup = spiky_star(3, 1);
  const Sphere sphere = solve_or_throw(soup);
  const Mesh mesh = make_mesh(soup);
  const auto on_sphere = of_vertex<Point>([&](Vertex v) { return sphere[v]; });
  std::map<Vertex, Point> points;
  SP::transfer_vertex_property(Locator(mesh, on_sphere), mesh.points(), mesh, on_sphere,
                               Writable_map<Vertex, Point>{&points});
  for(Vertex v : vertices(mesh))
    CHECK(points.at(v) == mesh.point(v));
}

TEST_CASE("values of all kinds are interpolated", "[transfer]")
{
  const Mesh coarse = make_mesh(icosphere(3)), fine = make_mesh(icosphere(4));
  const Locator locator(coarse, coarse.points());
  const auto value = [](const Point& p) { return 1 + 2 * p.x() - p.y() + 3 * p.z(); };
  std::map<Vertex, double> number;
  std::map<Vertex, float> single;
  std::map<Vertex, Vector> vector;
  std::map<Vertex, Eigen::Vector2d> pair;
  std::map<Vertex, std::array<float, 3>> array;
  SP::transfer_vertex_property(locator, of_vertex<double>([&](Vertex v) { return value(coarse.point(v)); }), fine,
                               fine.points(), Writable_map<Vertex, double>{&number});
  SP::transfer_vertex_property(locator, of_vertex<float>([&](Vertex v) { return float(value(coarse.point(v))); }), fine,
                               fine.points(), Writable_map<Vertex, float>{&single});
  SP::transfer_vertex_property(locator,
                               of_vertex<Vector>([&](Vertex v) { return 2 * (coarse.point(v) - CGAL::ORIGIN); }), fine,
                               fine.points(), Writable_map<Vertex, Vector>{&vector});
  SP::transfer_vertex_property(
    locator, of_vertex<Eigen::Vector2d>([&](Vertex v) { return Eigen::Vector2d(coarse.point(v).x(), 1); }), fine,
    fine.points(), Writable_map<Vertex, Eigen::Vector2d>{&pair});
  SP::transfer_vertex_property(locator, of_vertex<std::array<float, 3>>([&](Vertex v) {
                                 return std::array<float, 3>{1, float(value(coarse.point(v))), 2};
                               }),
                               fine, fine.points(), Writable_map<Vertex, std::array<float, 3>>{&array});
  for(Vertex v : vertices(fine)) {
    // the coarse vertices are among the fine ones, and the others are in the middle of an edge: a linear function is
    // off by the sagitta of that edge, 1 - cos(angle / 2)
    CHECK(number.at(v) == Approx(value(fine.point(v))).margin(0.03));
    CHECK(double(single.at(v)) == Approx(number.at(v)).margin(1e-5));
    CHECK((vector.at(v) - 2 * (fine.point(v) - CGAL::ORIGIN)).squared_length() < 4e-4);
    CHECK(pair.at(v)[1] == Approx(1).epsilon(1e-15));
    CHECK(array.at(v) == std::array<float, 3>{1, single.at(v), 2});
  }
  for(Vertex v : vertices(coarse)) // the first ones
    CHECK(number.at(v) == value(coarse.point(v)));
}

TEST_CASE("integers are rounded, not cut off", "[transfer]")
{
  const Mesh coarse = make_mesh(icosphere(3)), fine = make_mesh(icosphere(5));
  const Locator locator(coarse, coarse.points());
  using Colour = std::array<unsigned char, 3>;
  const auto nearby = of_vertex<Point>([&](Vertex v) { return coarse.point(v) + 1e-14 * Vector(1, -2, 3); });
  std::map<Vertex, int> number;
  std::map<Vertex, Colour> colour;
  SP::transfer_vertex_property(locator, of_vertex<int>([](Vertex v) { return int(v) % 10; }), coarse, nearby,
                               Writable_map<Vertex, int>{&number});
  SP::transfer_vertex_property(locator, of_vertex<Colour>([](Vertex v) {
                                 return Colour{0, 255, (unsigned char)(v)};
                               }),
                               coarse, nearby, Writable_map<Vertex, Colour>{&colour});
  constexpr auto most = std::numeric_limits<std::size_t>::max(); // "none", as a number
  std::map<Vertex, std::size_t> index;
  SP::transfer_vertex_property(locator, of_vertex<std::size_t>([](Vertex v) { return v < Vertex(99) ? most : 7; }),
                               coarse, coarse.points(), Writable_map<Vertex, std::size_t>{&index});
  for(Vertex v : vertices(coarse)) {
    CHECK(index.at(v) == (v < Vertex(99) ? most : 7));
    CHECK(number.at(v) == int(v) % 10);
    CHECK((colour.at(v) == Colour{0, 255, (unsigned char)(v)}));
  }
  SP::transfer_vertex_property(locator, of_vertex<int>([](Vertex v) { return int(v) % 2; }), fine, fine.points(),
                               Writable_map<Vertex, int>{&number});
  double mean = 0;
  for(Vertex v : vertices(fine))
    mean += double(number.at(v)) / double(num_vertices(fine));
  CHECK(mean == Approx(0.5).margin(0.06));
}

TEST_CASE("a value that is no number stays where it is", "[transfer]")
{
  const Mesh mesh = make_mesh(icosphere(3));
  const Locator locator(mesh, mesh.points());
  const Vertex bad(5);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::map<Vertex, double> number;
  std::map<Vertex, Eigen::Vector2d> pair;
  SP::transfer_vertex_property(locator, of_vertex<double>([&](Vertex v) { return v == bad ? nan : 1; }), mesh,
                               mesh.points(), Writable_map<Vertex, double>{&number});
  SP::transfer_vertex_property(
    locator, of_vertex<Eigen::Vector2d>([&](Vertex v) { return Eigen::Vector2d(v == bad ? nan : 1, 2); }), mesh,
    mesh.points(), Writable_map<Vertex, Eigen::Vector2d>{&pair});
  for(Vertex v : vertices(mesh)) {
    CHECK(std::isnan(number.at(v)) == (v == bad));
    CHECK(std::isnan(pair.at(v)[0]) == (v == bad));
  }
}

TEST_CASE("what is constant stays so, at the ends of the range, too", "[transfer]")
{
  const Mesh coarse = make_mesh(icosphere(1)), fine = make_mesh(icosphere(4));
  const Locator locator(coarse, coarse.points());
  const auto direction = of_vertex<Point>([&](Vertex v) { // weights that rounding keeps from adding up to 1
    const Point& p = fine.point(v);
    return Point(p.x(), 2 * p.y(), 3 * p.z());
  });
  const double largest = (std::numeric_limits<double>::max)();
  std::map<Vertex, int> number;
  std::map<Vertex, Point> points;
  SP::transfer_vertex_property(locator, of_vertex<int>([](Vertex) { return 7; }), fine, direction,
                               Writable_map<Vertex, int>{&number});
  SP::transfer_vertex_property(locator, of_vertex<Point>([=](Vertex) { return Point(largest, -largest, 0.1); }), fine,
                               direction, Writable_map<Vertex, Point>{&points});
  for(Vertex v : vertices(fine)) {
    CHECK(number.at(v) == 7);
    CHECK(points.at(v) == Point(largest, -largest, 0.1));
  }
}

TEST_CASE("labels of faces are transferred as they are", "[transfer]")
{
  const Mesh coarse = make_mesh(icosphere(3)), fine = make_mesh(icosphere(4));
  std::map<Face, int> labels;
  SP::transfer_face_property(Locator(coarse, coarse.points()),
                             Readable_map<Face, int>{[](Face f) { return int(f.idx()); }}, fine, fine.points(),
                             Writable_map<Face, int>{&labels});
  std::map<int, int> count;
  for(const auto& entry : labels)
    ++count[entry.second];
  CHECK(labels.size() == fine.number_of_faces());
  CHECK(count.size() == coarse.number_of_faces());
  for(const auto& entry : count)
    CHECK(entry.second == 4); // the four that a coarse face was cut into
}

TEST_CASE("transfer_segment_labels: a segment gets the label of most of its area, and keeps its boundary", "[transfer]")
{
  const Mesh coarse = make_mesh(icosphere(3)), fine = make_mesh(icosphere(4));
  const auto centre = [](const Mesh& mesh, Face f) {
    Vector sum(0, 0, 0);
    for(const Vertex v : vertices_around_face(halfedge(f, mesh), mesh))
      sum = sum + (mesh.point(v) - CGAL::ORIGIN);
    return sum;
  };
  const auto labels =
    Readable_map<Face, std::string>{[&](Face f) { return std::string(centre(coarse, f).x() < 0 ? "left" : "right"); }};
  // four segments, whose boundary is nearly that of the labels
  const auto segments = Readable_map<Face, int>{[&](Face f) {
    const Vector c = centre(fine, f);
    return (c.x() + 0.2 * c.z() < 0 ? 0 : 1) + (c.y() < 0 ? 10 : 20);
  }};
  std::map<Face, std::string> result, of_faces;
  const Locator locator(coarse, coarse.points());
  SP::transfer_segment_labels(locator, labels, fine, fine.points(), segments, Writable_map<Face, std::string>{&result});
  SP::transfer_face_property(locator, labels, fine, fine.points(), Writable_map<Face, std::string>{&of_faces});
  CHECK(result != of_faces);
  for(const Face f : fine.faces())
    CHECK(result.at(f) == (get(segments, f) % 10 == 0 ? "left" : "right"));
}

namespace {

/// Of the vertices on the surface.
std::vector<double> areas_of(const Mesh& mesh)
{
  SP::Shape_points points;
  for(const Point& p : mesh.points())
    points.push_back({p.x(), p.y(), p.z()});
  return SP::mean_vertex_areas(mesh, std::vector<SP::Shape_points>{points});
}

template <class Rows>
Sphere turned(const Mesh& mesh, const Rows& rows)
{
  Sphere images;
  for(const Point& p : mesh.points())
    images.push_back(test::apply(rows, p));
  return images;
}

void check_rows(const SP::Resampling_weights& weights)
{
  for(std::size_t i = 0; i < weights.size(); ++i) {
    double sum = 0;
    for(std::size_t k = weights.begin[i]; k < weights.begin[i + 1]; ++k) {
      CHECK(weights.weight[k] > 0);
      CHECK((k == weights.begin[i] || weights.vertex[k - 1] < weights.vertex[k]));
      sum += weights.weight[k];
    }
    CHECK(sum == Approx(1).epsilon(1e-12));
  }
}

std::vector<double> noise(std::size_t n)
{
  std::mt19937 random(5);
  std::vector<double> values(n);
  for(double& x : values)
    x = double(random()) / 4294967296. - 0.5;
  return values;
}

} // namespace

TEST_CASE("linear weights interpolate as transfer does, and labels go to the largest of them", "[resample]")
{
  const Mesh from = make_mesh(bumpy_sphere(3)), round = make_mesh(icosphere(3)), to = make_mesh(icosphere(4));
  const auto turn = random_rotation(2);
  const Sphere images = turned(to, turn);
  const Locator locator(from, round.points());
  const SP::Resampling_weights weights = SP::linear_resampling(locator, images);
  REQUIRE(weights.size() == to.number_of_vertices());
  check_rows(weights);
  const std::vector<double> values = noise(from.number_of_vertices()), means = weights.means(values);
  std::map<Vertex, double> expected;
  SP::transfer_vertex_property(locator, of_vertex<double>([&](Vertex v) { return values[v]; }), to,
                               of_vertex<Point>([&](Vertex v) { return images[v]; }),
                               Writable_map<Vertex, double>{&expected});
  for(Vertex v : vertices(to))
    CHECK(means[v] == Approx(expected.at(v)).margin(1e-11));
  const std::vector<double> constant(values.size(), 0.1);
  CHECK(weights.means(constant) == std::vector<double>(weights.size(), 0.1));

  std::vector<int> number(values.size()), half;
  for(Vertex v : vertices(from)) {
    number[v] = int(v.idx());
    half.push_back(from.point(v).x() > 0 ? 1 : -1);
  }
  const std::vector<int> nearest = weights.nearest(number), majority = weights.majorities(half);
  CHECK(weights.majorities(number) == nearest); // where all labels differ
  for(std::size_t i = 0; i < weights.size(); ++i) {
    double of_nearest = 0, largest = 0, sum = 0;
    for(std::size_t k = weights.begin[i]; k < weights.begin[i + 1]; ++k) {
      of_nearest += weights.vertex[k] == nearest[i] ? weights.weight[k] : 0;
      largest = std::max(largest, weights.weight[k]);
      sum += half[weights.vertex[k]] * weights.weight[k];
    }
    CHECK(of_nearest == Approx(largest).margin(1e-11));
    CHECK(majority[i] * sum > -1e-11);
  }
}

TEST_CASE("resampling that preserves areas passes no vertex over", "[resample]")
{
  const Mesh fine = make_mesh(bumpy_sphere(4)), fine_round = make_mesh(icosphere(4));
  const Mesh coarse = make_mesh(bumpy_sphere(2)), coarse_round = make_mesh(icosphere(2));
  const auto turn = random_rotation(2);
  const Sphere images = turned(coarse_round, turn);
  const Locator from(fine, fine_round.points()), to(coarse, of_vertex<Point>([&](Vertex v) { return images[v]; }));
  const std::vector<double> fine_areas = areas_of(fine), coarse_areas = areas_of(coarse);
  const auto down = SP::area_preserving_resampling(from, fine_round.points(), fine_areas, to, images, coarse_areas);
  check_rows(down);
  std::vector<char> is_used(fine.number_of_vertices(), 0);
  for(int v : down.vertex)
    is_used[std::size_t(v)] = 1;
  CHECK(std::count(is_used.begin(), is_used.end(), 0) == 0);
  // Integrals are kept: what a vertex gives away, with the areas of those that get it, is its own area, nearly. Linear
  // weights give what a few vertices have.
  const auto lost = [&](const SP::Resampling_weights& weights) {
    std::vector<double> left = fine_areas;
    for(std::size_t i = 0; i < weights.size(); ++i)
      for(std::size_t k = weights.begin[i]; k < weights.begin[i + 1]; ++k)
        left[std::size_t(weights.vertex[k])] -= weights.weight[k] * coarse_areas[i];
    double sum = 0;
    for(const double area : left)
      sum += std::abs(area);
    return sum / std::accumulate(fine_areas.begin(), fine_areas.end(), 0.);
  };
  CHECK(lost(down) < 0.3);
  CHECK(lost(SP::linear_resampling(from, images)) > 1);

  // towards a finer mesh linear weights pass nothing over, and areas change them but a little
  const auto up = SP::area_preserving_resampling(to, images, coarse_areas, from, fine_round.points(), fine_areas);
  const auto up_linear = SP::linear_resampling(to, fine_round.points());
  check_rows(up);
  CHECK(up.means(std::vector<double>(coarse.number_of_vertices(), 0.1)) == std::vector<double>(up.size(), 0.1));
  CHECK(up.vertex.size() == Approx(double(up_linear.vertex.size())).epsilon(0.05));

  // a surface without areas is interpolated linearly
  const auto flat = SP::area_preserving_resampling(from, fine_round.points(), std::vector<double>(fine_areas.size(), 0),
                                                   to, images, coarse_areas);
  CHECK(flat.weight == SP::linear_resampling(from, images).weight);
  CHECK_THROWS_AS(SP::area_preserving_resampling(from, fine_round.points(), coarse_areas, to, images, coarse_areas),
                  CGAL::Precondition_exception);

  // a vertex without area gives nothing
  std::vector<double> areas = fine_areas, values(areas.size(), 1);
  areas[7] = 0;
  values[7] = std::numeric_limits<double>::quiet_NaN();
  const auto without = SP::area_preserving_resampling(from, fine_round.points(), areas, to, images, coarse_areas);
  check_rows(without);
  CHECK(without.means(values) == std::vector<double>(without.size(), 1));
}

TEST_CASE("majorities of long rows, and values that are missing", "[resample]")
{
  SP::Resampling_weights weights; // one row
  for(int v = 0; v < 1000000; ++v) {
    weights.vertex.push_back(v);
    weights.weight.push_back(1e-6);
  }
  weights.begin.push_back(weights.vertex.size());
  std::vector<int> labels(weights.vertex.size());
  for(std::size_t v = 0; v < labels.size(); ++v)
    labels[v] = v % 7 == 0 ? 1 : v % 7 < 4 ? 2 : 3; // 3/7 each of the last two, and 2 has what is left over
  CHECK(weights.majorities(labels) == std::vector<int>{2});

  SP::Resampling_weights tie;
  tie.vertex = {0, 1, 2};
  tie.weight = {0.25, 0.5, 0.25};
  tie.begin = {0, 3};
  CHECK(tie.majorities(std::vector<int>{7, 8, 7}) == std::vector<int>{7}); // the first of two that have a half each

  labels.pop_back();
  CHECK_THROWS_AS(weights.majorities(labels), CGAL::Precondition_exception);
  CHECK_THROWS_AS(weights.nearest(labels), CGAL::Precondition_exception);
  CHECK_THROWS_AS(weights.means(std::vector<double>(3)), CGAL::Precondition_exception);
}

TEST_CASE("to its own sphere a mesh keeps its values, in both ways", "[resample]")
{
  const Mesh mesh = make_mesh(bumpy_sphere(3)), round = make_mesh(icosphere(3));
  const Locator locator(mesh, round.points());
  const std::vector<double> values = noise(mesh.number_of_vertices()), areas = areas_of(mesh);
  CHECK(SP::linear_resampling(locator, round.points()).means(values) == values);
  const auto weights = SP::area_preserving_resampling(locator, round.points(), areas, locator, round.points(), areas);
  CHECK(weights.means(values) == values);
  CHECK(weights.majorities(values) == values);
}

TEST_CASE("vertices that were removed do not count", "[resample]")
{
  const Mesh mesh = make_mesh(icosphere(2));
  Mesh with_garbage = mesh;
  with_garbage.remove_vertex(with_garbage.add_vertex(Point(1, 2, 3)));
  REQUIRE(num_vertices(with_garbage) > with_garbage.number_of_vertices());
  std::vector<Point> images;
  for(Vertex v : vertices(mesh))
    images.push_back(mesh.point(v));
  const auto weights = [&](const Mesh& m) {
    const Locator locator(m, m.points());
    const SP::Shape_points shape(images.size(), {1, 2, 3});
    CHECK(SP::mean_vertex_areas(m, std::vector<SP::Shape_points>{shape}).size() == images.size());
    const std::vector<double> areas(images.size(), 1);
    return SP::area_preserving_resampling(locator, images, areas, locator, images, areas).weight;
  };
  CHECK((weights(with_garbage) == weights(mesh)));
}

TEST_CASE("icospheres", "[resample]")
{
  for(int level = 0; level < 5; ++level) {
    Mesh mesh;
    SP::make_icosphere(level, mesh, mesh.points());
    const std::size_t power = std::size_t(1) << (2 * level);
    CHECK(mesh.number_of_vertices() == 10 * power + 2);
    CHECK(mesh.number_of_faces() == 20 * power);
    CHECK(CGAL::is_closed(mesh));
    CHECK(mesh.is_valid());
    const Soup soup = make_soup(mesh);
    CHECK(count_flipped_faces(soup, soup.points) == 0);
    CHECK(degree(soup, soup.points) == 1);
    CHECK(count_vertices_off_sphere(soup.points) == 0);
  }
  Mesh mesh;
  CHECK_THROWS_AS(SP::make_icosphere(-1, mesh, mesh.points()), CGAL::Precondition_exception);
  CHECK_THROWS_AS(SP::make_icosphere(SP::largest_icosphere_level + 1, mesh, mesh.points()),
                  CGAL::Precondition_exception);
}

TEST_CASE("a resampled shape consists of points of the shape, and converges to it", "[resample]")
{
  const Soup soup = dumbbell(3);
  Settings settings;
  settings.weights = Weights::BARYCENTRIC;
  const Sphere sphere = solve_or_throw(soup, settings);
  Mesh shape = make_mesh(soup);
  const Locator locator(shape, of_vertex<Point>([&](Vertex v) { return sphere[v]; }));
  const auto area = [](const Mesh& mesh) {
    double sum = 0;
    for(Face f : faces(mesh)) {
      const auto h = mesh.halfedge(f);
      sum += std::sqrt(CGAL::squared_area(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)),
                                          mesh.point(mesh.target(mesh.next(h)))));
    }
    return sum;
  };
  double error = 1;
  for(int level : {2, 3, 4, 5}) {
    Mesh out;
    const auto directions = out.add_property_map<Vertex, Point>("v:sphere").first;
    SP::resample(locator, shape.points(), level, out, out.points(), directions);
    for(Vertex v : vertices(out)) {
      const auto [f, w] = locator.locate(directions[v]);
      const auto h = shape.halfedge(f);
      const Point p = CGAL::barycenter(shape.point(shape.source(h)), w[0], shape.point(shape.target(h)), w[1],
                                       shape.point(shape.target(shape.next(h))), w[2]);
      CHECK(CGAL::squared_distance(p, out.point(v)) < 1e-26);
    }
    const double new_error = std::abs(area(out) / area(shape) - 1);
    CHECK(new_error < error);
    error = new_error;
  }
  CHECK(error < 0.01);
}

TEST_CASE("resampling between types of meshes and kernels", "[resample]")
{
  using Polyhedron = CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>;
  using Polyhedron_vertex = boost::graph_traits<Polyhedron>::vertex_descriptor;
  const Mesh shape = make_mesh(icosphere(2));
  Polyhedron out;
  std::map<Polyhedron_vertex, Point> directions;
  std::map<Polyhedron_vertex, Point> points;
  SP::resample(Locator(shape, shape.points()), shape.points(), 1, out, Writable_map<Polyhedron_vertex, Point>{&points},
               Read_write_map<Polyhedron_vertex, Point>{&directions});
  CHECK(out.size_of_vertices() == 42);
  CHECK(points.size() == 42);
}

TEST_CASE("maps of the same shape are brought into the same position", "[align]")
{
  const Soup soup = bumpy_sphere(3);
  const Sphere sphere = solve_or_throw(soup);
  const double away = GENERATE(0., 100., 1e8); // as coordinates on the earth are
  const Mesh mesh = make_mesh(transformed(soup, [&](const Point& p) { return Point(p.x(), p.y() + away, p.z()); }));
  const auto on_sphere = of_vertex<Point>([&](Vertex v) { return sphere[v]; });
  const Locator locator(mesh, on_sphere);
  for(unsigned seed = 0; seed < 3; ++seed) {
    const auto rows = random_rotation(seed);
    // the second shape is larger and elsewhere, and its map is rotated
    Mesh other = mesh;
    for(Point& p : other.points())
      p = Point(3 * p.x() + 7, 3 * p.y(), 3 * p.z() - away);
    const auto rotated_sphere = of_vertex<Point>([&](Vertex v) { return test::apply(rows, sphere[v]); });
    const SP::Rotation found =
      SP::aligning_rotation(locator, mesh.points(), Locator(other, rotated_sphere), other.points());
    for(std::size_t i = 0; i < 3; ++i)
      for(std::size_t j = 0; j < 3; ++j)
        CHECK(found[i][j] == Approx(rows[i][int(j)]).margin(1e-3));
    const auto seen = SP::rotated_map(on_sphere, found);
    for(Vertex v : vertices(mesh)) {
      const auto p = get(seen, v);
      CHECK((Point(p[0], p[1], p[2]) - get(rotated_sphere, v)).squared_length() < 1e-4);
    }
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("resampling, transfer and alignment are the same bits on several threads", "[resample]")
{
  const CGAL::Parallel_tag several;
  const Soup soup = bumpy_sphere(5);
  const Mesh mesh = make_mesh(soup), round = make_mesh(icosphere(5));
  const Locator locator(mesh, round.points()), parallel(several, mesh, round.points());
  Mesh a, b;
  const auto sphere_a = a.add_property_map<Vertex, Point>("v:sphere").first;
  const auto sphere_b = b.add_property_map<Vertex, Point>("v:sphere").first;
  SP::resample(locator, mesh.points(), 5, a, a.points(), sphere_a);
  SP::resample(several, parallel, mesh.points(), 5, b, b.points(), sphere_b);
  for(Vertex v : vertices(a))
    REQUIRE(a.point(v) == b.point(v));
  std::map<Face, int> labels_a, labels_b;
  const auto number = Readable_map<Face, int>{[](Face f) { return int(f.idx()); }};
  SP::transfer_face_property(locator, number, a, sphere_a, Writable_map<Face, int>{&labels_a});
  SP::transfer_face_property(several, parallel, number, b, sphere_b, Writable_map<Face, int>{&labels_b});
  CHECK(labels_a == labels_b);
  const auto weights = SP::linear_resampling(several, parallel, sphere_b);
  CHECK(weights.weight == SP::linear_resampling(locator, sphere_a).weight);
  CHECK(SP::aligning_rotation(locator, mesh.points(), locator, mesh.points()) ==
        SP::aligning_rotation(several, parallel, mesh.points(), parallel, mesh.points()));
}
#endif
