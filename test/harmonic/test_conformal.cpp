// SPDX-License-Identifier: GPL-3.0-or-later
// Conformal weights: the map is conformal whatever the triangles, and certified on the faces of the mesh.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/distortion_summary.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Source_mesh.h>
#include <CGAL/Spherical_parameterization/internal/multigrid/coarsening.h>
#include <CGAL/Spherical_parameterization/internal/relaxation/mend.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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

Sphere sphere_of(const Positions& positions)
{
  Sphere sphere;
  for(const auto& p : positions)
    sphere.emplace_back(p.x, p.y, p.z);
  return sphere;
}

} // namespace

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
  const auto graph_of = [](const Soup& soup, I::Host_array<double>& length) {
    I::Spring_lengths lengths;
    const Mesh mesh = make_mesh(soup);
    I::Source_mesh<Mesh> source(mesh, mesh.points());
    I::Corner_table table = I::corner_table_of(mesh, source.face, I::Host_loop());
    // back to the numbers of the soup
    for(auto& f : table.face)
      for(int& i : f)
        i = source.position[i];
    const auto points = positions_of(soup.points);
    I::Weighted_graph graph = I::conformal_graph(I::Host_loop(), table, points, lengths);
    length = lengths.of_all(graph, points);
    return graph;
  };
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

TEST_CASE("untangling moves the vertices of flipped faces, and no fixed ones", "[conformal]")
{
  namespace I = SP::internal;
  const Soup soup = icosphere(3);
  const Faces faces = faces_of(soup);
  const Positions whole = positions_of(soup.points);
  Positions v = whole;
  const int centre = faces[100][0], neighbour = faces[100][1];
  v[centre] = I::unit(I::add_scaled(v[centre], 2.5, I::sub(v[neighbour], v[centre]))); // beyond its ring
  REQUIRE(count_flipped_faces(soup, sphere_of(v)) > 0);
  const Positions tangled = v;
  const I::Host_loop loop;

  std::vector<char> is_moved(v.size(), 0);
  SECTION("few")
  {
    REQUIRE(I::untangle(loop, faces, whole, {}, v, is_moved));
    CHECK(count_flipped_faces(soup, sphere_of(v)) == 0);
    CHECK(std::count(is_moved.begin(), is_moved.end(), 1) < 50);
    for(std::size_t i = 0; i < v.size(); ++i)
      if(!is_moved[i])
        CHECK((v[i].x == tangled[i].x && v[i].y == tangled[i].y && v[i].z == tangled[i].z));
  }
  SECTION("what is fixed where it contradicts its ring is not mended")
  {
    std::vector<char> is_fixed(v.size(), 1);
    CHECK_FALSE(I::untangle(loop, faces, whole, is_fixed, v, is_moved));
  }
  SECTION("a mirrored map is another map")
  {
    for(auto& p : v)
      p.x = -p.x;
    const Positions before = v;
    CHECK_FALSE(I::untangle(loop, faces, whole, {}, v, is_moved));
    CHECK(sphere_of(v) == sphere_of(before));
    CHECK(std::count(is_moved.begin(), is_moved.end(), 1) == 0);
  }
}

TEST_CASE("untangling brings a limb back that has collapsed to a point", "[conformal]")
{
  namespace I = SP::internal;
  const Soup soup = icosphere(3);
  const Faces faces = faces_of(soup);
  const Positions whole = positions_of(soup.points);
  Positions v = whole;
  for(auto& p : v) // a cap
    if(I::inner(p, whole[7]) > std::cos(0.25))
      p = whole[7];
  REQUIRE(count_flipped_faces(soup, sphere_of(v)) > 10);
  std::vector<char> is_moved(v.size(), 0);
  REQUIRE(I::untangle(I::Host_loop(), faces, whole, {}, v, is_moved));
  CHECK(count_flipped_faces(soup, sphere_of(v)) == 0);
  CHECK(dilatation(soup, sphere_of(v)) < 1.5);
  CHECK(std::count(is_moved.begin(), is_moved.end(), 1) < int(v.size()) / 2);
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

TEST_CASE("polishing makes bad faces more conformal and leaves the others alone", "[conformal]")
{
  namespace I = SP::internal;
  const Soup soup = icosphere(3);
  const Faces faces = faces_of(soup);
  const Positions points = positions_of(soup.points);
  Positions v = points;
  const int centre = faces[100][0], neighbour = faces[100][1];
  v[centre] = I::unit(I::add_scaled(v[centre], 0.9, I::sub(v[neighbour], v[centre])));
  REQUIRE(count_flipped_faces(soup, sphere_of(v)) == 0);
  const double before = dilatation(soup, sphere_of(v));
  REQUIRE(before > 1.01);

  std::vector<char> is_fixed(v.size(), 0), is_moved(v.size(), 0);
  is_fixed[neighbour] = 1;
  I::polish(I::Host_loop(), faces, points, is_fixed, v, is_moved);
  CHECK(count_flipped_faces(soup, sphere_of(v)) == 0);
  CHECK(dilatation(soup, sphere_of(v)) - 1 < (before - 1) / 2);
  CHECK((v[neighbour].x == points[neighbour].x && !is_moved[neighbour]));
  std::set<int> concerned; // the corners of the faces at the vertex that was moved
  for(const auto& f : faces)
    if(std::find(f.begin(), f.end(), centre) != f.end())
      concerned.insert(f.begin(), f.end());
  for(int i = 0; i < int(v.size()); ++i)
    CHECK((!is_moved[i] || concerned.count(i) > 0));
}
