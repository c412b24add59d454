// SPDX-License-Identifier: GPL-3.0-or-later
// edge_weights.h against the formulas, computed again.

#include "helpers/certificate.h"
#include "helpers/meshes.h"
#include "helpers/property_maps.h"

#include <CGAL/Spherical_parameterization/edge_weights.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace test;
namespace SP = CGAL::Spherical_parameterization;

namespace {

Mesh::Edge_index edge_between(const Mesh& mesh, const Spring& s)
{
  return mesh.edge(mesh.halfedge(Mesh::Vertex_index(Mesh::size_type(s.i)), Mesh::Vertex_index(Mesh::size_type(s.j))));
}

} // namespace

TEST_CASE("barycentric weights are one", "[weights]")
{
  const Mesh mesh = make_mesh(bumpy_sphere(1));
  const auto weights = SP::barycentric_weights(mesh);
  for(auto e : edges(mesh))
    CHECK(get(weights, e) == 1);
}

TEST_CASE("clamped weights are half the sum of two clamped cotangents", "[weights]")
{
  const Soup soup = GENERATE(0, 1) == 0 ? bumpy_sphere(3) : ellipsoid(1, 1, 30, 3);
  const Mesh mesh = make_mesh(soup);
  const auto weights = SP::clamped_weights(mesh);
  bool clamped = false;
  for(const Spring& s : make_springs(soup, Weights::CLAMPED)) {
    CHECK(get(weights, edge_between(mesh, s)) == Approx(s.weight).epsilon(1e-12));
    clamped = clamped || s.weight < 0.1;
  }
  CHECK(clamped);
}

TEST_CASE("the clamping bounds of clamped weights are parameters", "[weights]")
{
  const double degree = std::acos(-1.) / 180;
  const Mesh needles = make_mesh(ellipsoid(1, 1, 100, 3));
  auto extremes = [&](const auto& weights) {
    std::pair<double, double> result(1e300, -1e300);
    for(auto e : edges(needles)) {
      result.first = std::min(result.first, double(get(weights, e)));
      result.second = std::max(result.second, double(get(weights, e)));
    }
    return result;
  };
  const auto narrow = extremes(SP::clamped_weights(needles, 30, 60));
  CHECK(narrow.first >= 1 / std::tan(60 * degree) * (1 - 1e-12));
  CHECK(narrow.second <= 1 / std::tan(30 * degree) * (1 + 1e-12));
  const auto standard = extremes(SP::clamped_weights(needles));
  CHECK(standard.first < narrow.first);
  CHECK(standard.second > narrow.second);
  CHECK(standard.first >= 1 / std::tan(85 * degree) * (1 - 1e-12));
  CHECK(standard.second <= 1 / std::tan(5 * degree) * (1 + 1e-12));
}

TEST_CASE("clamped weights take the points of a point map", "[weights]")
{
  const Soup soup = bumpy_sphere(2);
  const Mesh mesh = make_mesh(ellipsoid(1, 2, 3, 2));
  const Readable_map<Mesh::Vertex_index, Point> points{[&](const Mesh::Vertex_index& v) { return soup.points[v]; }};
  const auto weights = SP::clamped_weights(mesh, 5, 85, CGAL::parameters::vertex_point_map(points));
  for(const Spring& s : make_springs(soup, Weights::CLAMPED))
    CHECK(get(weights, edge_between(mesh, s)) == Approx(s.weight).epsilon(1e-12));
}

TEST_CASE("mean value weights are the mean of those of the two ends of an edge", "[weights]")
{
  const Soup soup = bumpy_sphere(3);
  const Mesh mesh = make_mesh(soup);
  const auto weights = SP::mean_value_weights(mesh);
  for(const Spring& s : make_springs(soup, Weights::MEAN_VALUE))
    CHECK(get(weights, edge_between(mesh, s)) == Approx(s.weight).epsilon(1e-12));
}

TEST_CASE("clamped weights do not change with the size of the mesh", "[weights]")
{
  const double scale = GENERATE(1e-100, 1e-6, 1e6, 1e100);
  const Mesh mesh = make_mesh(bumpy_sphere(2));
  const Mesh scaled = make_mesh(
    transformed(bumpy_sphere(2), [=](const Point& p) { return Point(scale * p.x(), scale * p.y(), scale * p.z()); }));
  const auto weights = SP::clamped_weights(mesh), scaled_weights = SP::clamped_weights(scaled);
  for(auto e : edges(mesh))
    CHECK(get(scaled_weights, e) == Approx(get(weights, e)).epsilon(1e-10));
}
