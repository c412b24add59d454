// SPDX-License-Identifier: GPL-3.0-or-later
// Conformal weights: the map is conformal whatever the triangles, and certified on the faces of the mesh.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/coarsening.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Face_hessian.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Sparse_cholesky.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/mend.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/Patch.h>
#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/resample.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <set>
#include <vector>

using namespace test;

namespace {

/// A sphere, or an ellipsoid, whose triangles are sheared: the vertices are turned round the z-axis, the farther the
/// higher they are.
Soup twisted(const Soup& soup, double twist)
{
  return transformed(soup, [=](const Point& p) {
    const double c = std::cos(twist * p.z()), s = std::sin(twist * p.z());
    return Point(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
  });
}

Settings with(Weights weights)
{
  Settings settings;
  settings.weights = weights;
  return settings;
}

/// Mean ratio of the principal stretches of the faces; 1 is conformal.
double dilatation(const Soup& soup, const Sphere& sphere)
{
  Mesh mesh = make_mesh(soup);
  const auto map = mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
  for(auto v : vertices(mesh))
    map[v] = sphere[v];
  return SP::distortion_summary(mesh, map).dilatation.mean;
}

using Faces = SP::internal::Host_array<std::array<int, 3>>;
using Positions = SP::internal::Host_array<SP::internal::vec3>;

Faces faces_of(const Soup& soup)
{
  Faces faces;
  for(const auto& f : soup.faces)
    faces.push_back({int(f[0]), int(f[1]), int(f[2])});
  return faces;
}

Positions positions_of(const std::vector<Point>& points)
{
  Positions positions;
  for(const Point& p : points)
    positions.push_back({p.x(), p.y(), p.z()});
  return positions;
}

/// The springs of conformal weights, numbered as the soup is, and the lengths of their edges.
template <class Loop = SP::internal::Host_loop>
SP::internal::Weighted_graph graph_of(const Soup& soup, SP::internal::Host_array<double>& length,
                                      const Loop& loop = Loop())
{
  namespace I = SP::internal;
  I::Spring_lengths lengths;
  const Mesh mesh = make_mesh(soup);
  I::Vertices<Mesh> vertex;
  const I::Surface source = I::read_faces(mesh, I::Reading::BREADTH_FIRST, I::Host_loop(), vertex);
  I::Corner_table table = source.copy_of_corner_table(I::Host_loop());
  for(auto& f : table.face)
    for(int& i : f)
      i = source.position[i];
  const auto points = positions_of(soup.points);
  I::Weighted_graph graph = I::conformal_graph(loop, table, points, lengths);
  length = lengths.of_all(graph, points);
  return graph;
}

Sphere sphere_of(const Positions& positions)
{
  Sphere sphere;
  for(const auto& p : positions)
    sphere.emplace_back(p.x, p.y, p.z);
  return sphere;
}

} // namespace

TEST_CASE("conformal weights can be interrupted while they are computed, the flips included", "[conformal]")
{
  namespace I = SP::internal;
  const Soup smooth = icosphere(7), soup = twisted(smooth, 1.5);
  int calls = 0, last = (std::numeric_limits<int>::max)();
  const auto calls_of = [&](const Soup& of, I::Weighted_graph& graph) {
    I::Host_array<double> length;
    I::Monitor monitor(
      std::numeric_limits<double>::infinity(), [&](double) { return ++calls < last; }, false);
    calls = 0;
    graph = graph_of(of, length, I::Watched_loop(I::Host_loop(), monitor));
    return calls;
  };
  I::Host_array<double> length;
  I::Weighted_graph graph;
  const int all = calls_of(soup, graph);
  CHECK(all > 5);
  CHECK(graph.weight == graph_of(soup, length).weight);
  for(const int no : {1, 3}) { // how many calls there are depends on the time that they take
    last = no;
    CHECK_THROWS_AS(calls_of(soup, graph), SP::Error);
    CHECK(calls == no);
  }
}

TEST_CASE("conformal weights: obtuse triangles do no harm", "[conformal][each_policy]")
{
  const Soup smooth = GENERATE(0, 1) == 0 ? icosphere(4) : ellipsoid(1, 1.3, 1.6, 4);
  const Soup soup = twisted(smooth, 1.5);
  Sphere conformal, clamped;
  const Result result = solve(soup, conformal, with(Weights::CONFORMAL));
  CAPTURE(result);
  REQUIRE(result);
  CHECK(count_flipped_faces(soup, conformal) == 0);
  CHECK(degree(soup, conformal) == 1);
  REQUIRE(solve(soup, clamped, with(Weights::CLAMPED)));
  const double good = dilatation(soup, conformal), bad = dilatation(soup, clamped);
  CAPTURE(good, bad);
  CHECK(good < 1.05);
  CHECK(bad - 1 > 4 * (good - 1));
}

TEST_CASE("conformal weights: faces that come out flipped are mended, and the vertices counted", "[conformal]")
{
  // slivers that the intrinsic triangulation does not have
  const Soup soup = twisted(icosphere(3), 6);
  Sphere sphere;
  const Result result = solve(soup, sphere, with(Weights::CONFORMAL));
  CAPTURE(result);
  REQUIRE(result);
  CHECK(count_flipped_faces(soup, sphere) == 0);
  CHECK(degree(soup, sphere) == 1);
  CHECK(count_vertices_off_sphere(sphere) == 0);
  CHECK(result.moved_vertices > 0);
  CHECK(result.moved_vertices < soup.points.size() / 2);
  CHECK(solve(soup, sphere, with(Weights::CLAMPED)).moved_vertices == 0);
  CHECK(solve(icosphere(2), sphere, with(Weights::CONFORMAL)).moved_vertices == 0);
}

TEST_CASE("conformal weights: what is handed out is no worse than what was found before", "[conformal]")
{
  // The first start ends with 13 flipped faces and degree 0; the careful second one does not converge, but flips none.
  const std::array<double, 12> radius = {1.2553, 0.7474, 1.3905, 0.3458, 1.5416, 4.9891,
                                         0.4684, 0.6137, 0.6137, 2.6734, 1.4334, 3.5265};
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
  SP::make_icosphere_soup(0, points, triangles);
  Soup star;
  for(std::size_t i = 0; i < points.size(); ++i)
    star.points.push_back(CGAL::ORIGIN + radius[i] * Vector(points[i][0], points[i][1], points[i][2]));
  for(const auto& [a, b, c] : triangles)
    star.faces.push_back({std::size_t(a), std::size_t(b), std::size_t(c)});
  Settings settings;
  settings.weights = Weights::CONFORMAL;
  Sphere sphere;
  const Result result = solve(star, sphere, settings);
  CHECK(result.error == Error_code::NOT_CONVERGED);
  CHECK(result.flipped_faces == 0);
  CHECK(result.degree == 1);
}

TEST_CASE("conformal weights: a map whose mending is interrupted is interrupted, and not wrong", "[conformal]")
{
  const Soup soup = twisted(icosphere(5), 6);
  Settings settings = with(Weights::CONFORMAL);
  std::size_t calls = 0;
  Sphere sphere;
  settings.callback = [&](double) { return ++calls > 0; };
  REQUIRE(solve(soup, sphere, settings));
  std::size_t last = calls;
  settings.callback = [&](double) { return ++calls < last; };
  for(; last > 0; last -= last / 20 + 1) {
    calls = 0;
    const Result result = solve(soup, sphere, settings);
    CAPTURE(result, last);
    const bool is_done = result.error == Error_code::OK; // nothing was left to mend
    CHECK((is_done || result.error == Error_code::INTERRUPTED));
    CHECK(result.termination == (is_done ? SP::Termination::CONVERGED : SP::Termination::CALLBACK));
  }
}

TEST_CASE("conformal weights: the residual is that of the map that is handed over", "[conformal][each_policy]")
{
  namespace I = SP::internal;
  const double noise = GENERATE(0., 0.2);
  std::mt19937 random(1);
  const Soup soup = transformed(icosphere(4), [&](const Point& p) {
    const double r = 1 + noise * (2. * random() / double(std::mt19937::max()) - 1);
    return Point(r * p.x(), r * p.y(), r * p.z());
  });
  const Settings settings = with(Weights::CONFORMAL);
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  REQUIRE(result);

  // the forces of the springs, in tangent planes, relative to the sum of the weights
  I::Host_array<double> lengths;
  const I::Weighted_graph graph = graph_of(soup, lengths);
  const Positions images = positions_of(sphere);
  double squares = 0;
  for(int i = 0; i < graph.size(); ++i) {
    I::vec3 force = {0, 0, 0};
    double sum = 0;
    for(int k = graph.offset[i]; k < graph.offset[i + 1]; ++k) {
      force = I::add_scaled(force, graph.weight[k], I::sub(images[graph.target[k]], images[i]));
      sum += graph.weight[k];
    }
    force = I::tangent(I::scale(1 / sum, force), images[i]);
    squares += I::inner(force, force);
  }
  CAPTURE(noise, result);
  CHECK(result.residual == Approx(std::sqrt(squares)).epsilon(0.02).margin(settings.accuracy));
  const bool is_accurate = result.residual <= settings.accuracy;
  CHECK(is_accurate == (result.moved_vertices == 0));
  CHECK((result.termination == SP::Termination::CONVERGED) == is_accurate);
  CHECK(is_accurate == (noise == 0));
}

TEST_CASE("conformal weights: renumbering permutes a map that has been mended", "[conformal]")
{
  const Soup soup = GENERATE(0, 1) == 0 ? twisted(icosphere(3), 6) : twisted(spiky_star(3, 1.5), 4);
  Sphere sphere, other;
  const Result result = solve(soup, sphere, with(Weights::CONFORMAL));
  CAPTURE(result);
  REQUIRE((result && result.moved_vertices > 0));
  for(unsigned seed : {1, 2}) {
    std::vector<std::size_t> order;
    const Soup shuffled = renumbered(soup, seed, order);
    CHECK(solve(shuffled, other, with(Weights::CONFORMAL)).moved_vertices == result.moved_vertices);
    Sphere permuted;
    for(std::size_t i : order)
      permuted.push_back(sphere[i]);
    CHECK(distance_up_to_rotation(permuted, other) < 1e-8);
  }
}

TEST_CASE("conformal weights: larger spring exponents have the lengths of the intrinsic edges", "[conformal]")
{
  const Soup soup = twisted(icosphere(3), 2);
  Settings settings = with(Weights::CONFORMAL);
  settings.method = SP::Balanced{3};
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  REQUIRE(result);
  CHECK(dilatation(soup, sphere) < 1.05); // on a sphere areas and angles do not contradict each other
}

TEST_CASE("conformal weights: the same bits on every policy, and of a soup", "[conformal][each_policy]")
{
  const Soup soup = twisted(icosphere(3), 6);
  Settings settings = with(Weights::CONFORMAL);
  Sphere here, there;
  const Result one = solve(soup, here, settings);
  settings.policy = CGAL::Sequential_tag();
  const Result other = solve(soup, there, settings);
  CHECK(here == there);
  CHECK(one.moved_vertices == other.moved_vertices);
  std::vector<std::array<double, 3>> points, images;
  for(const Point& p : soup.points)
    points.push_back({p.x(), p.y(), p.z()});
  const auto of_soup =
    SP::parameterize_triangle_soup(CGAL::Sequential_tag(), points, soup.faces, SP::Balanced(), images,
                                   CGAL::parameters::edge_weight_map(SP::Conformal_weights()));
  REQUIRE(of_soup);
  for(std::size_t i = 0; i < images.size(); ++i)
    CHECK((images[i][0] == here[i].x() && images[i][1] == here[i].y() && images[i][2] == here[i].z()));
}

TEST_CASE("conformal weights: faces without area, and all vertices in one point", "[conformal]")
{
  Sphere sphere;
  CHECK(solve(collinear_face(), sphere, with(Weights::CONFORMAL)));
  CHECK(solve(coincident_points(), sphere, with(Weights::CONFORMAL)));
  CHECK(solve(many_coincident_points(3), sphere, with(Weights::CONFORMAL)));
  CHECK(solve(one_point(2), sphere, with(Weights::CONFORMAL)));
}

TEST_CASE("conformal weights: fixed vertices stay, whatever is moved", "[conformal]")
{
  const Soup soup = twisted(icosphere(3), 6);
  Settings settings = with(Weights::CONFORMAL);
  settings.method = GENERATE(decltype(settings.method)(SP::Balanced()), SP::Saddle_point());
  if(std::holds_alternative<SP::Saddle_point>(settings.method))
    settings.accuracy = 1e-3;
  const Sphere round = twisted(icosphere(3), 6).points;
  for(std::size_t i = 0; i < round.size(); i += 5)
    settings.fixed[i] = round[i];
  Sphere sphere;
  const Result result = solve(soup, sphere, settings);
  CAPTURE(result);
  REQUIRE(result.degree == 1);
  for(const auto& [i, p] : settings.fixed)
    CHECK(CGAL::squared_distance(sphere[i], p) < 1e-30);
}

TEST_CASE("conformal springs: cotangents of a Delaunay mesh, positive and symmetric on any other", "[conformal]")
{
  namespace I = SP::internal;
  I::Host_array<double> length;
  const Soup good = icosphere(2); // all angles are acute
  const I::Weighted_graph graph = graph_of(good, length);
  std::size_t springs = 0;
  for(const Spring& s : make_springs(good, Weights::CLAMPED)) { // which are not clamped here
    const int i = int(s.i);
    const auto begin = graph.target.begin() + graph.offset[i], end = graph.target.begin() + graph.offset[i + 1];
    const auto it = std::find(begin, end, int(s.j));
    REQUIRE(it != end);
    CHECK(graph.weight[it - graph.target.begin()] == Approx(s.weight).epsilon(1e-4)); // mollified
    springs += 2;
  }
  CHECK(graph.target.size() == springs);

  const I::Weighted_graph other = graph_of(twisted(bumpy_sphere(3), 8), length);
  REQUIRE(length.size() == other.target.size());
  for(int i = 0; i < other.size(); ++i) {
    CHECK(std::is_sorted(other.target.begin() + other.offset[i], other.target.begin() + other.offset[i + 1]));
    for(int k = other.offset[i]; k < other.offset[i + 1]; ++k) {
      const int j = other.target[k];
      CHECK(j != i);
      CHECK((k == other.offset[i] || other.target[k - 1] != j));
      CHECK((other.weight[k] > 0 && length[k] > 0));
      const auto back =
        std::lower_bound(other.target.begin() + other.offset[j], other.target.begin() + other.offset[j + 1], i) -
        other.target.begin();
      CHECK((other.target[back] == i && other.weight[back] == other.weight[k] && length[back] == length[k]));
    }
  }
}

namespace {

constexpr double usual_bound = 2; // of MIPS

bool mend(const Soup& soup, const Positions& points, Positions& v, std::vector<char>& is_moved,
          const std::vector<char>& is_fixed = {}, double resolution = 0,
          const std::function<bool(double)>& callback = {})
{
  is_moved.assign(v.size(), 0);
  SP::internal::Monitor monitor(std::numeric_limits<double>::infinity(), callback, false);
  return SP::internal::mend(SP::internal::Host_loop(), faces_of(soup), points, is_fixed, usual_bound, resolution,
                            monitor, v, is_moved) == SP::internal::Mending::DONE;
}

/// Moves a corner of a face towards another one, or beyond it.
int drag_corner(const Soup& soup, double share, Positions& v)
{
  namespace I = SP::internal;
  const auto face = faces_of(soup)[100];
  v[face[0]] = I::unit(I::add_scaled(v[face[0]], share, I::sub(v[face[1]], v[face[0]])));
  return face[0];
}

} // namespace

TEST_CASE("mending moves the vertices of flipped faces, and no fixed ones", "[conformal]")
{
  const Soup soup = icosphere(3);
  const Positions whole = positions_of(soup.points);
  Positions v = whole;
  drag_corner(soup, 2.5, v); // beyond its ring
  REQUIRE(count_flipped_faces(soup, sphere_of(v)) > 0);
  const Positions tangled = v;

  std::vector<char> is_moved;
  SECTION("few")
  {
    REQUIRE(mend(soup, whole, v, is_moved));
    CHECK(count_flipped_faces(soup, sphere_of(v)) == 0);
    CHECK(std::count(is_moved.begin(), is_moved.end(), 1) < 50);
    for(std::size_t i = 0; i < v.size(); ++i)
      if(!is_moved[i])
        CHECK((v[i].x == tangled[i].x && v[i].y == tangled[i].y && v[i].z == tangled[i].z));
  }
  SECTION("what is fixed where it contradicts its ring is not mended")
  {
    const std::vector<char> is_fixed(v.size(), 1);
    CHECK_FALSE(mend(soup, whole, v, is_moved, is_fixed));
  }
  SECTION("what is smaller than positions are known is not mended")
  {
    CHECK_FALSE(mend(soup, whole, v, is_moved, {}, 1.));
    CHECK(sphere_of(v) == sphere_of(tangled));
    CHECK(mend(soup, whole, v, is_moved, {}, 1e-3));
  }
  SECTION("a mirrored map is another map")
  {
    for(auto& p : v)
      p.x = -p.x;
    const Positions before = v;
    CHECK_FALSE(mend(soup, whole, v, is_moved));
    CHECK(sphere_of(v) == sphere_of(before));
    CHECK(std::count(is_moved.begin(), is_moved.end(), 1) == 0);
  }
}

TEST_CASE("mending asks the callback in every step, and leaves the map alone when it is stopped", "[conformal]")
{
  const Soup soup = icosphere(3);
  const Positions whole = positions_of(soup.points);
  Positions tangled = whole;
  drag_corner(soup, 2.5, tangled);
  std::vector<char> is_moved;
  int calls = 0;
  Positions v = tangled;
  REQUIRE(mend(soup, whole, v, is_moved, {}, 0, [&](double) { return ++calls > 0; }));
  const int all = calls;
  REQUIRE(all > 3);
  for(const int last : {1, all / 2, all}) {
    v = tangled;
    calls = 0;
    CHECK_FALSE(mend(soup, whole, v, is_moved, {}, 0, [&](double) { return ++calls < last; }));
    CHECK(calls == last);
    CHECK(sphere_of(v) == sphere_of(tangled));
    CHECK(std::count(is_moved.begin(), is_moved.end(), 1) == 0);
  }
}

TEST_CASE("mending moves a bounded share of the vertices: only flipped faces where bad ones are everywhere",
          "[conformal]")
{
  const Soup soup = icosphere(6); // 40,962 vertices, of which a quarter will have bad faces
  const Positions whole = positions_of(soup.points);
  Positions sheared = whole;
  for(auto& p : sheared) // and none a flipped one
    p = SP::internal::unit({p.x, p.y, 40 * p.z});
  Positions v = sheared;
  std::vector<char> is_moved;
  REQUIRE(mend(soup, whole, v, is_moved));
  CHECK(std::count(is_moved.begin(), is_moved.end(), 1) == 0);
  const int corner = drag_corner(soup, 2.5, v);
  REQUIRE(count_flipped_faces(soup, sphere_of(v)) > 0);
  REQUIRE(mend(soup, whole, v, is_moved));
  CHECK(count_flipped_faces(soup, sphere_of(v)) == 0);
  CHECK(is_moved[corner]);
  CHECK(std::count(is_moved.begin(), is_moved.end(), 1) < 100);
}

TEST_CASE("mending ends at a minimum: no vertex that was moved has a better place", "[conformal]")
{
  namespace I = SP::internal;
  const Soup soup = twisted(icosphere(3), 6);
  const Positions points = positions_of(soup.points);
  Sphere sphere;
  const Result result = solve(soup, sphere, with(Weights::CONFORMAL));
  REQUIRE(result);
  Positions v = positions_of(sphere);
  std::vector<char> is_moved;
  REQUIRE(mend(soup, points, v, is_moved)); // a map that has been mended, once more: some of its faces are still bad
  REQUIRE(std::count(is_moved.begin(), is_moved.end(), 1) > 0);

  const Faces faces = faces_of(soup);
  const I::Distortion mips(0);
  for(int i = 0; i < int(v.size()); ++i) {
    if(!is_moved[i])
      continue;
    I::Star star;
    for(const auto& f : faces)
      for(int k = 0; k < 3; ++k)
        if(f[k] == i) {
          const int j = f[(k + 1) % 3], l = f[(k + 2) % 3];
          const auto metric = I::face_metric(points[i], points[j], points[l], I::Metric_bounds{1e6, 1e-30});
          star.emplace_back(v[j], v[l], metric, 1);
        }
    double energy = I::Star_trial(mips, star, v[i]).energy;
    I::vec3 x = v[i];
    const double before = energy;
    CHECK(I::relax_centre(mips, star, x, energy) < 1e-9 * before);
  }
}

TEST_CASE("mending brings a limb back that has collapsed to a point", "[conformal]")
{
  namespace I = SP::internal;
  const Soup soup = icosphere(3);
  const Positions whole = positions_of(soup.points);
  Positions v = whole;
  for(auto& p : v) // a cap
    if(I::inner(p, whole[7]) > std::cos(0.25))
      p = whole[7];
  REQUIRE(count_flipped_faces(soup, sphere_of(v)) > 10);
  std::vector<char> is_moved;
  REQUIRE(mend(soup, whole, v, is_moved));
  CHECK(count_flipped_faces(soup, sphere_of(v)) == 0);
  CHECK(dilatation(soup, sphere_of(v)) < 1.5);
  CHECK(std::count(is_moved.begin(), is_moved.end(), 1) < int(v.size()) / 2);
}

TEST_CASE("mending makes bad faces more conformal and leaves the others alone", "[conformal]")
{
  const Soup soup = icosphere(3);
  const Positions points = positions_of(soup.points);
  Positions v = points;
  const int centre = drag_corner(soup, 0.9, v), neighbour = faces_of(soup)[100][1];
  REQUIRE(count_flipped_faces(soup, sphere_of(v)) == 0);
  const double before = dilatation(soup, sphere_of(v));
  REQUIRE(before > 1.01);

  std::vector<char> is_fixed(v.size(), 0), is_moved;
  is_fixed[neighbour] = 1;
  REQUIRE(mend(soup, points, v, is_moved, is_fixed));
  CHECK(count_flipped_faces(soup, sphere_of(v)) == 0);
  CHECK(dilatation(soup, sphere_of(v)) - 1 < (before - 1) / 2);
  CHECK((v[neighbour].x == points[neighbour].x && !is_moved[neighbour]));
  std::set<int> concerned; // the corners of the faces at the vertex that was moved
  for(const auto& f : faces_of(soup))
    if(std::find(f.begin(), f.end(), centre) != f.end())
      concerned.insert(f.begin(), f.end());
  for(int i = 0; i < int(v.size()); ++i)
    CHECK((!is_moved[i] || concerned.count(i) > 0));
}

TEST_CASE("Newton's matrix of a face is the derivative of its gradient, flipped or not", "[conformal]")
{
  namespace I = SP::internal;
  const double e = 0.1, h = 1e-6;
  const bool is_flipped = GENERATE(false, true);
  const I::Untangling_energy energy(e);
  const Positions x = {I::unit({0.1, 0.2, 1}), I::unit({is_flipped ? -0.1 : 0.5, 0.1, 1}), I::unit({0.1, 0.6, 1})};
  const auto metric = I::face_metric({0, 0, 0}, {1, 0, 0}, {0.3, 0.8, 0}, I::Metric_bounds{30, 1e-30});
  const auto gradient = [&](const Positions& p, int corner) {
    I::Star_face f(p[1], p[2], metric, 0.1);
    return I::Face_hessian(energy, p[0], f, 0).gradient(corner);
  };
  const I::Star_face f(x[1], x[2], metric, 0.1);
  REQUIRE((f.determinant(x[0]) < 0) == is_flipped);
  const I::Face_hessian hessian(energy, x[0], f, 0);
  for(int m = 0; m < 3; ++m)
    for(int n = 0; n < 3; ++n) {
      const I::Tangents at_m = I::tangents_at(x[m]), at_n = I::tangents_at(x[n]);
      const I::Block block = hessian.block(m, hessian.frame(m, at_m), n, hessian.frame(n, at_n));
      Positions ahead = x, behind = x;
      ahead[n] = I::add_scaled(x[n], h, at_n.s);
      behind[n] = I::add_scaled(x[n], -h, at_n.s);
      const I::vec3 slope = I::scale(1 / (2 * h), I::sub(gradient(ahead, m), gradient(behind, m)));
      CAPTURE(m, n);
      CHECK(block.ss == Approx(I::inner(slope, at_m.s)).epsilon(1e-5).margin(1e-5));
      CHECK(block.ts == Approx(I::inner(slope, at_m.t)).epsilon(1e-5).margin(1e-5));
    }
}

TEST_CASE("what is taken off a face's matrix leaves nothing negative of a small face, flipped or not", "[conformal]")
{
  namespace I = SP::internal;
  const bool is_flipped = GENERATE(false, true);
  const double size = 1e-4, e = 0.1;
  const I::vec3 first = I::make_vec3(0.3 * size, 0.2 * size, 1), second = I::make_vec3(0.9 * size, 0.8 * size, 1),
                third = I::make_vec3(-0.2 * size, 0.5 * size, 1);
  const Positions x = {I::unit(first), I::unit(is_flipped ? third : second), I::unit(is_flipped ? second : third)};
  const auto metric = I::face_metric({0, 0, 0}, {1, 0, 0}, {0.3, 0.1, 0}, I::Metric_bounds{30, 1e-30});
  const I::Star_face f(x[1], x[2], metric, size * size);
  REQUIRE((f.determinant(x[0]) < 0) == is_flipped);
  const auto smallest = [&](double lift, bool is_stiff = false) { // of the second derivatives in some directions
    const I::Face_hessian hessian(I::Untangling_energy(e), x[0], f, lift);
    double result = std::numeric_limits<double>::infinity(), largest = 0;
    for(int trial = 0; trial < 1000; ++trial) {
      double second_derivative = 0;
      const auto direction = [trial](int k) { return I::Planar{std::sin(7. * trial + k), std::cos(5. * trial * k)}; };
      for(int m = 0; m < 3; ++m)
        for(int n = 0; n < 3; ++n) {
          const auto at_m = hessian.frame(m, I::tangents_at(x[m])), at_n = hessian.frame(n, I::tangents_at(x[n]));
          I::Block b = hessian.block(m, at_m, n, at_n);
          if(is_stiff)
            b = I::sum(b, hessian.stiff_lift(m, at_m, n, at_n));
          const I::Planar u = direction(m), v = direction(n);
          second_derivative += u.s * (b.ss * v.s + b.st * v.t) + u.t * (b.ts * v.s + b.tt * v.t);
        }
      result = (std::min)(result, second_derivative);
      largest = (std::max)(largest, second_derivative);
    }
    return result / largest;
  };
  CHECK(smallest(0) < -1e-3);
  CHECK(smallest(1) > -1e-6);
  CHECK(smallest(0, true) > -1e-6);
}

TEST_CASE("the sparse factorization solves what is positive definite, and refuses what is not", "[conformal]")
{
  namespace I = SP::internal;
  // the edges of an icosphere, each with a block; diagonals as large as needed, or a little less
  const Soup soup = icosphere(2);
  const Faces faces = faces_of(soup);
  const int n = int(soup.points.size());
  std::vector<std::vector<int>> neighbours(n);
  for(const auto& f : faces)
    for(int k = 0; k < 3; ++k)
      neighbours[f[k]].push_back(f[(k + 1) % 3]);
  I::Sparse_cholesky matrix(neighbours);
  const auto assemble = [&](double diagonal) {
    matrix.set_zero();
    for(int i = 0; i < n; ++i) {
      matrix.add(matrix.place(i, i), {diagonal, 0.1, 0.1, diagonal});
      for(int j : neighbours[i])
        if(i < j)
          matrix.add(matrix.place(i, j), {-1, 0.5, 0, -1});
    }
  };
  assemble(9);
  REQUIRE(matrix.factorize());
  std::vector<I::Planar> b(n);
  for(int i = 0; i < n; ++i)
    b[i] = {std::sin(i), std::cos(2. * i)};
  const std::vector<I::Planar> x = matrix.solve(b);
  for(int i = 0; i < n; ++i) {
    I::Planar sum = {9 * x[i].s + 0.1 * x[i].t - b[i].s, 0.1 * x[i].s + 9 * x[i].t - b[i].t};
    for(int j : neighbours[i]) {
      sum.s += -x[j].s + (i < j ? 0.5 * x[j].t : 0);
      sum.t += -x[j].t + (i < j ? 0 : 0.5 * x[j].s);
    }
    CHECK(std::abs(sum.s) + std::abs(sum.t) < 1e-13);
  }
  assemble(5); // less than the largest eigenvalue of the rest
  CHECK_FALSE(matrix.factorize());
}

TEST_CASE("coarse matrices keep what hangs on weak edges only", "[multigrid]")
{
  namespace I = SP::internal;
  // two squares with diagonals, tied together by weak edges of unequal weights
  I::Weighted_graph graph;
  for(int i = 0; i < 8; ++i) {
    for(int j = 0; j < 8; ++j)
      if(j != i && (j / 4 == i / 4 || j % 4 == i % 4)) {
        graph.target.push_back(j);
        graph.weight.push_back(j / 4 == i / 4 ? 1 : i % 4 == 2 ? 1e-5 : 1e-7);
      }
    graph.offset.push_back(int(graph.target.size()));
  }
  graph.update_diagonal({});
  I::drop_weak_edges(I::Host_loop(), 0.01, graph);
  int ties = 0;
  for(int i = 0; i < 8; ++i)
    for(int k = graph.offset[i]; k < graph.offset[i + 1]; ++k) {
      const int j = graph.target[k];
      ties += j / 4 != i / 4;
      CHECK(std::count(graph.target.begin() + graph.offset[j], graph.target.begin() + graph.offset[j + 1], i) == 1);
    }
  CHECK(ties >= 2);
}
