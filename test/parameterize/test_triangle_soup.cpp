// SPDX-License-Identifier: GPL-3.0-or-later
// Triangle soups are mapped like meshes, and refused with what is wrong and where.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/parameterize.h>

#include <boost/property_map/function_property_map.hpp>
#include <catch2/catch.hpp>

#include <array>
#include <string>
#include <utility>
#include <vector>

using namespace test;

namespace {

typedef std::vector<std::array<double, 3>> Points;
typedef std::vector<std::array<std::uint32_t, 3>> Triangles;

Points points_of(const Soup& soup)
{
  Points points;
  for(const Point& p : soup.points)
    points.push_back({p.x(), p.y(), p.z()});
  return points;
}

Triangles triangles_of(const Soup& soup)
{
  Triangles triangles;
  for(const auto& f : soup.faces)
    triangles.push_back({std::uint32_t(f[0]), std::uint32_t(f[1]), std::uint32_t(f[2])});
  return triangles;
}

Points as_points(const Sphere& sphere) { return points_of({sphere, {}}); }

Result refusal(const Soup& soup)
{
  Points sphere;
  Result result = SP::parameterize_triangle_soup(points_of(soup), soup.faces, sphere);
  CHECK(!result);
  return result;
}

} // namespace

TEST_CASE("a soup has the map of the mesh, to the last bit", "[soup]")
{
  std::vector<std::size_t> order;
  const Soup shuffled = renumbered(bumpy_sphere(4), 7, order);
  const Soup soup =
    GENERATE_REF(spiky_star(4, 1.5), dumbbell(4), tetrahedron(), cross(), bipyramid(50), comb(20, 3), shuffled);
  Points sphere;
  SECTION("balanced")
  {
    Sphere expected;
    Settings settings;
    settings.weights = Weights::CONFORMAL; // the default
    const Result of_mesh = solve(soup, expected, settings);
    const Result of_soup = SP::parameterize_triangle_soup(points_of(soup), triangles_of(soup), sphere);
    CHECK(sphere == as_points(expected));
    CHECK(of_soup.error == of_mesh.error);
    CHECK(of_soup.residual == of_mesh.residual);
  }
  SECTION("isometric")
  {
    Settings settings;
    settings.method = SP::Isometric();
    settings.accuracy = SP::Isometric::default_accuracy;
    settings.number_of_iterations = SP::Isometric::default_number_of_iterations;
    Sphere expected;
    solve(soup, expected, settings);
    CHECK(SP::parameterize_triangle_soup(CGAL::Sequential_tag(), points_of(soup), triangles_of(soup), SP::Isometric(),
                                         sphere));
    CHECK(sphere == as_points(expected));
  }
}

TEST_CASE("a soup that is no sphere is refused: what, where, what to do", "[soup]")
{
  const auto check = [](const Soup& soup, Error_code code, const std::string& detail) {
    const Result result = refusal(soup);
    CAPTURE(result);
    CHECK(result.error == code);
    CHECK(result.detail.find(detail) != std::string::npos);
  };
  check({}, Error_code::EMPTY_MESH, "no faces");
  check(torus(6, 6), Error_code::WRONG_GENUS, "genus 1");
  check(double_torus(), Error_code::WRONG_GENUS, "genus 2");
  check(open_sphere(2), Error_code::BOUNDARY, "5 boundary edges (first: between vertices");
  check(two_spheres(), Error_code::SEVERAL_COMPONENTS, "2 connected components");
  check(isolated_vertex(), Error_code::ISOLATED_VERTEX, "1 isolated vertex without faces (first: vertex ");
  check(quad_cube(), Error_code::NOT_TRIANGULAR, "face 0 has 4 corners");
  check(nan_coordinate(), Error_code::NON_FINITE_COORDINATE, "vertex 5");
  check(make_soup(hourglass()), Error_code::NON_MANIFOLD, "1 non-manifold vertex");

  Soup soup = icosphere(1);
  SECTION("a number that is too large")
  {
    soup.faces[3][1] = soup.points.size();
    check(soup, Error_code::BAD_INDEX, "triangle 3 names point 42 of 42");
  }
  SECTION("a vertex twice in a face")
  {
    soup.faces[4][1] = soup.faces[4][0];
    check(soup, Error_code::DEGENERATE_FACE, "1 face that has a vertex twice (first: face 4)");
  }
  SECTION("a face turned over")
  {
    std::swap(soup.faces[4][1], soup.faces[4][0]);
    check(soup, Error_code::INCONSISTENT_ORIENTATION, "3 edges between faces of opposite orientation");
  }
  SECTION("a face twice")
  {
    soup.faces.push_back(soup.faces[0]);
    check(soup, Error_code::NON_MANIFOLD, "3 edges with more than two faces");
  }
  SECTION("triangles that do not share their vertices")
  {
    Soup apart;
    for(const auto& f : soup.faces) {
      apart.faces.push_back({apart.points.size(), apart.points.size() + 1, apart.points.size() + 2});
      for(std::size_t v : f)
        apart.points.push_back(soup.points[v]);
    }
    check(apart, Error_code::BOUNDARY, "only 42 different points for 240 vertices");
  }
}

TEST_CASE("weights and fixed vertices of a soup are given by numbers", "[soup]")
{
  const Soup soup = bumpy_sphere(3);
  const auto weight = [](std::pair<std::size_t, std::size_t> edge) {
    CHECK(edge.first < edge.second);
    return 1. + 1. / (1. + edge.first);
  };
  const auto weights = boost::make_function_property_map<std::pair<std::size_t, std::size_t>>(weight);
  const auto is_fixed = boost::make_function_property_map<std::size_t>([](std::size_t v) { return v < 3; });
  Points sphere(soup.points.size());
  sphere[0] = {1, 0, 0};
  sphere[1] = {0, 1, 0};
  sphere[2] = {0, 0, 1};
  const Result result =
    SP::parameterize_triangle_soup(CGAL::Sequential_tag(), points_of(soup), soup.faces, SP::Balanced(), sphere,
                                   CGAL::parameters::edge_weight_map(weights).vertex_is_constrained_map(is_fixed));
  CHECK(result.iterations > 0);
  CHECK(sphere[0] == std::array<double, 3>{1, 0, 0});
  CHECK(sphere[2] == std::array<double, 3>{0, 0, 1});

  // the same with a mesh
  Mesh mesh = make_mesh(soup);
  auto map = mesh.add_property_map<Mesh::Vertex_index, Point>("v:map").first;
  for(int v = 0; v < 3; ++v)
    map[Mesh::Vertex_index(v)] = Point(v == 0, v == 1, v == 2);
  const auto edge_weights = boost::make_function_property_map<Mesh::Edge_index>([&](Mesh::Edge_index e) {
    const std::size_t a = mesh.vertex(e, 0), b = mesh.vertex(e, 1);
    return 1. + 1. / (1. + (std::min)(a, b));
  });
  const auto first_three =
    boost::make_function_property_map<Mesh::Vertex_index>([](Mesh::Vertex_index v) { return v.idx() < 3; });
  SP::parameterize(mesh, SP::Balanced(), map,
                   CGAL::parameters::edge_weight_map(edge_weights).vertex_is_constrained_map(first_three));
  for(const Mesh::Vertex_index v : mesh.vertices())
    CHECK(sphere[v.idx()] == std::array<double, 3>{map[v].x(), map[v].y(), map[v].z()});
}

TEST_CASE("ranges without room for the sphere are refused, others are resized", "[soup]")
{
  const Soup soup = icosphere(1);
  std::array<std::array<double, 3>, 7> small;
  CHECK_THROWS_AS(SP::parameterize_triangle_soup(points_of(soup), soup.faces, small), CGAL::Precondition_exception);
  std::array<std::array<double, 3>, 42> fitting;
  CHECK(SP::parameterize_triangle_soup(points_of(soup), soup.faces, fitting));
  std::vector<Point> any;
  CHECK(SP::parameterize_triangle_soup(soup.points, soup.faces, any));
  CHECK(any.size() == 42);
}

TEST_CASE("an indexed mesh is a FaceGraph whose halfedges fit together", "[soup]")
{
  const Soup soup = spiky_star(2, 1);
  const SP::Indexed_triangle_mesh mesh(soup.points, soup.faces);
  CHECK(num_vertices(mesh) - num_edges(mesh) + num_faces(mesh) == 2);
  for(const auto h : halfedges(mesh)) {
    CHECK(opposite(opposite(h, mesh), mesh) == h);
    CHECK(source(opposite(h, mesh), mesh) == target(h, mesh));
    CHECK(next(next(next(h, mesh), mesh), mesh) == h);
    CHECK(prev(next(h, mesh), mesh) == h);
    CHECK(halfedge(source(h, mesh), target(h, mesh), mesh).first == h);
    CHECK(source(next(h, mesh), mesh) == target(h, mesh));
  }
  for(const auto v : vertices(mesh))
    CHECK(target(halfedge(v, mesh), mesh) == v);
  for(const auto f : faces(mesh))
    CHECK(face(halfedge(f, mesh), mesh) == f);
  std::size_t number_of_edges = 0;
  for(const auto e : edges(mesh)) {
    CHECK(edge(halfedge(e, mesh), mesh) == e);
    CHECK(edge(opposite(halfedge(e, mesh), mesh), mesh) == e);
    ++number_of_edges;
  }
  CHECK(number_of_edges == num_edges(mesh));
}

TEST_CASE("an indexed mesh that forgets its neighbours has points and triangles, and no memory of the rest", "[soup]")
{
  const Soup soup = bumpy_sphere(2);
  SP::Indexed_triangle_mesh mesh(points_of(soup), triangles_of(soup));
  REQUIRE(mesh.corner_table().twin.size() == 3 * soup.faces.size());
  mesh.forget_neighbours();
  CHECK(mesh.corner_table().twin.capacity() == 0);
  CHECK(mesh.breadth_first_order().capacity() == 0);
  CHECK(mesh.points() == points_of(soup));
  for(std::size_t f = 0; f < soup.faces.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
      CHECK(std::size_t(mesh.triangle(f)[k]) == soup.faces[f][k]);
}

TEST_CASE("from the first call of the callback on the mesh is not looked at any more", "[soup]")
{
  const Soup soup = dumbbell(3);
  const auto check = [&](const auto& method) {
    SP::Indexed_triangle_mesh mesh(points_of(soup), soup.faces);
    Points expected(soup.points.size()), sphere(soup.points.size());
    const auto map = [](Points& points) {
      return boost::make_function_property_map<SP::Indexed_triangle_mesh::Vertex_index>(
        [&points](auto v) -> std::array<double, 3>& { return points[std::size_t(v.idx())]; });
    };
    REQUIRE(SP::parameterize(mesh, method, map(expected)));
    std::size_t calls = 0;
    const auto forget = [&](double) {
      if(calls++ == 0)
        mesh.forget_neighbours();
      return true;
    };
    CHECK(SP::parameterize(mesh, method, map(sphere), CGAL::parameters::callback(forget)));
    CHECK(calls > 1);
    CHECK(sphere == expected);
  };
  check(SP::Balanced());
  check(SP::Isometric());
}
