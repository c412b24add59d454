// SPDX-License-Identifier: GPL-3.0-or-later
// The maps a caller passes: value types, and archetypes that can do what their concept says and nothing else.

#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/spherical_parameterization.h>

#include <Eigen/Core>
#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace test;

namespace {

/// What the shortest call does.
Settings by_default()
{
  Settings settings;
  settings.weights = Weights::CONFORMAL;
  return settings;
}

using Vertex = Mesh::Vertex_index;
using Edge = Mesh::Edge_index;

/// Nothing but a constructor from three doubles.
class Direction {
  double m_x, m_y, m_z;

public:
  Direction(double x, double y, double z) : m_x(x), m_y(y), m_z(z) {}
  double operator[](int i) const { return i == 0 ? m_x : i == 1 ? m_y : m_z; }
};

template <class Value>
Sphere collect(const std::map<Vertex, Value>& images)
{
  Sphere sphere;
  for(const auto& [v, p] : images)
    sphere.emplace_back(p[0], p[1], p[2]);
  return sphere;
}

} // namespace

TEST_CASE("pointers are property maps, as Boost has them", "[property_maps]")
{
  const Mesh mesh = make_mesh(bumpy_sphere(2));
  Sphere sphere(num_vertices(mesh)), other = sphere;
  std::vector<double> weight(num_edges(mesh), 1), dilatation(num_faces(mesh));
  std::array<bool, 162> is_fixed = {};
  std::fill_n(is_fixed.begin(), 12, true); // the corners of an icosahedron
  REQUIRE(SP::parameterize(mesh, sphere.data(), CGAL::parameters::edge_weight_map(weight.data())));
  std::copy_n(sphere.begin(), 12, other.begin());
  REQUIRE(SP::parameterize(mesh, other.data(),
                           CGAL::parameters::edge_weight_map(weight.data())
                             .vertex_is_constrained_map(static_cast<const bool*>(is_fixed.data()))));
  CHECK(other[1] == sphere[1]);
  SP::face_dilatation(mesh, sphere.data(), dilatation.data());
  CHECK(*std::min_element(dilatation.begin(), dilatation.end()) >= 1);
  std::vector<Kernel::Point_2> uv(num_halfedges(mesh));
  SP::texture_coordinates(mesh, sphere.data(), uv.data());
  CHECK(std::all_of(uv.begin(), uv.end(), [](const auto& p) { return p.y() >= 0 && p.y() <= 1; }));
  const std::vector<Point> points(mesh.points().begin(), mesh.points().end());
  const auto weights = SP::mean_value_weights(mesh, CGAL::parameters::vertex_point_map(points.data()));
  REQUIRE(SP::parameterize(mesh, other.data(), CGAL::parameters::edge_weight_map(weights)));
}

TEMPLATE_TEST_CASE("any value type that is made from three numbers", "[property_maps]", Kernel::Point_3,
                   Kernel::Vector_3, (std::array<double, 3>), Eigen::Vector3d, Direction)
{
  const Soup soup = bumpy_sphere(2);
  const Mesh mesh = make_mesh(soup);
  std::map<Vertex, TestType> images;
  const Result result = SP::parameterize(mesh, Writable_map<Vertex, TestType>{&images});
  CAPTURE(result);
  REQUIRE(result);
  CHECK(distance(solve_or_throw(soup, by_default()), collect(images)) == 0);
}

TEMPLATE_TEST_CASE("what is written besides has any value type, too", "[property_maps]", Kernel::Point_3,
                   (std::array<double, 3>), (std::array<float, 3>), Eigen::Vector3d, Direction)
{
  typedef Read_write_map<Vertex, TestType> Map;
  Mesh mesh;
  SP::make_icosphere(1, mesh, mesh.points());
  const auto is_nearly_the_mesh = [&mesh](const std::map<Vertex, TestType>& images) {
    double largest = 0;
    for(const auto& [v, p] : images)
      for(int k = 0; k < 3; ++k)
        largest = (std::max)(largest, std::abs(p[k] - mesh.point(v)[k]));
    return images.size() == mesh.number_of_vertices() && largest < 1e-6;
  };
  std::map<Vertex, TestType> of_icosphere, centred, synthesized, registered;
  Mesh out;
  SP::make_icosphere(1, out, Writable_map<Vertex, TestType>{&of_icosphere});
  CHECK(is_nearly_the_mesh(of_icosphere));
  const auto one = Readable_map<Vertex, double>{[](Vertex) { return 1.; }};
  SP::moebius_centred_map(mesh, mesh.points(), one, Map{&centred});
  CHECK(is_nearly_the_mesh(centred));
  const auto coefficients = SP::harmonic_analysis(mesh, mesh.points(), mesh.points(), 2).coefficients;
  SP::harmonic_synthesis(coefficients, mesh, mesh.points(), Map{&synthesized});
  CHECK(is_nearly_the_mesh(synthesized));
  SP::Registration method;
  method.motion = SP::Registration::Motion::ROTATION;
  const std::vector<std::pair<Vertex, Vertex>> landmarks = {
    {Vertex(0), Vertex(0)}, {Vertex(5), Vertex(5)}, {Vertex(9), Vertex(9)}};
  CHECK(SP::register_maps(SP::mapped_mesh(mesh, mesh.points()), SP::mapped_mesh(mesh, mesh.points()), Map{&registered},
                          method, landmarks));
  CHECK(is_nearly_the_mesh(registered));
}

TEMPLATE_TEST_CASE("texture coordinates have any value type that is made from two numbers", "[property_maps]",
                   Kernel::Point_2, (std::array<double, 2>), (std::array<float, 2>), Eigen::Vector2d)
{
  using Halfedge = Mesh::Halfedge_index;
  const Mesh mesh = make_mesh(icosphere(1));
  std::map<Halfedge, TestType> uv;
  SP::texture_coordinates(mesh, mesh.points(), Writable_map<Halfedge, TestType>{&uv}, SP::Texture_options());
  CHECK(uv.size() == mesh.number_of_halfedges());
  CHECK(std::all_of(uv.begin(), uv.end(), [](const auto& c) { return c.second[1] >= 0 && c.second[1] <= 1; }));
}

TEST_CASE("measuring reads maps of any value type with three coordinates", "[property_maps]")
{
  const Mesh mesh = make_mesh(icosphere(1));
  std::map<Vertex, std::array<double, 3>> arrays;
  std::map<Vertex, Eigen::Vector3d> vectors;
  for(Vertex v : vertices(mesh)) {
    const Point& p = mesh.point(v);
    arrays.insert({v, {p.x(), p.y(), p.z()}});
    vectors.emplace(v, Eigen::Vector3d(p.x(), p.y(), p.z()));
  }
  CHECK(SP::number_of_flipped_faces(mesh, Read_write_map<Vertex, std::array<double, 3>>{&arrays}) == 0);
  CHECK(SP::number_of_flipped_faces(mesh, Read_write_map<Vertex, Eigen::Vector3d>{&vectors}) == 0);
}

TEST_CASE("a property map of the mesh holds the sphere", "[property_maps]")
{
  const Soup soup = bumpy_sphere(2);
  Mesh mesh = make_mesh(soup);
  auto sphere_map = mesh.add_property_map<Vertex, Point>("v:sphere").first;
  REQUIRE(SP::parameterize(mesh, sphere_map));
  Sphere sphere;
  for(Vertex v : vertices(mesh))
    sphere.push_back(sphere_map[v]);
  CHECK(distance(solve_or_throw(soup, by_default()), sphere) == 0);
}

TEST_CASE("the mesh may be mapped over its own points", "[property_maps]")
{
  const Soup soup = bumpy_sphere(2);
  Mesh mesh = make_mesh(soup);
  REQUIRE(SP::parameterize(mesh, mesh.points()));
  CHECK(distance(solve_or_throw(soup, by_default()), make_soup(mesh).points) == 0);
}

TEST_CASE("a minimal point map replaces the points of the mesh", "[property_maps]")
{
  // the points of the map are those of another mesh
  const Soup soup = bumpy_sphere(2), other = ellipsoid(1, 2, 3, 2);
  const Mesh mesh = make_mesh(other);
  const Readable_map<Vertex, Point> point_map{[&](const Vertex& v) { return soup.points[v]; }};
  std::map<Vertex, Point> images;
  const Writable_map<Vertex, Point> sphere_map{&images};
  REQUIRE(SP::parameterize(mesh, sphere_map, CGAL::parameters::vertex_point_map(point_map)));
  CHECK(distance(solve_or_throw(soup, by_default()), collect(images)) == 0);
  CHECK(distance_up_to_rotation(solve_or_throw(other, by_default()), collect(images)) > 0.01);
}

TEST_CASE("with a point map, a mesh needs no points of its own", "[property_maps]")
{
  struct Without_points {};
  const double points[] = {3};
  const auto map = SP::internal::vertex_points(Without_points(), CGAL::parameters::vertex_point_map(&points[0]));
  CHECK(map[0] == 3);
}

TEST_CASE("minimal weight and constraint maps", "[property_maps]")
{
  const Soup soup = bumpy_sphere(2);
  const Mesh mesh = make_mesh(soup);
  Settings settings;
  settings.weights = Weights::BARYCENTRIC;
  const Readable_map<Edge, double> ones{[](const Edge&) { return 1.; }};
  std::map<Vertex, Point> images;

  REQUIRE(SP::parameterize(mesh, Writable_map<Vertex, Point>{&images}, CGAL::parameters::edge_weight_map(ones)));
  CHECK(distance(solve_or_throw(soup, settings), collect(images)) == 0);

  // the positions of fixed vertices are read from the sphere map
  for(std::size_t i : {0, 4, 8}) {
    settings.fixed[i] = icosphere(2).points[i];
    images.at(Vertex(Mesh::size_type(i))) = settings.fixed[i];
  }
  const Readable_map<Vertex, bool> is_fixed{[&](const Vertex& v) { return settings.fixed.count(v) != 0; }};
  REQUIRE(SP::parameterize(mesh, Read_write_map<Vertex, Point>{&images},
                           CGAL::parameters::edge_weight_map(ones).vertex_is_constrained_map(is_fixed)));
  CHECK(distance(solve_or_throw(soup, settings), collect(images)) == 0);
}

TEST_CASE("the shortest call is the balanced conformal map on one core", "[property_maps]")
{
  const Mesh mesh = make_mesh(bumpy_sphere(2));
  std::map<Vertex, Point> short_call, long_call;
  const Result one = SP::parameterize(mesh, Writable_map<Vertex, Point>{&short_call});
  const Result two = SP::parameterize(
    CGAL::Sequential_tag(), mesh, SP::Balanced(), Writable_map<Vertex, Point>{&long_call},
    CGAL::parameters::edge_weight_map(SP::conformal_weights(mesh)).accuracy(SP::Balanced::default_accuracy));
  CHECK(one);
  CHECK(one.iterations == two.iterations);
  CHECK(distance(collect(short_call), collect(long_call)) == 0);
}
