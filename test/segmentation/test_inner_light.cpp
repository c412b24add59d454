// SPDX-License-Identifier: GPL-3.0-or-later
// Light inside a body: the first face that a ray meets, and how much of it goes from one part to another.

#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/inner_light.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <catch2/catch.hpp>

#include <numeric>
#include <random>
#include <utility>
#include <vector>

using namespace test;
namespace internal = CGAL::Spherical_parameterization::internal;
using internal::vec3;

namespace {

/// Light does not ask where vertices are on the sphere.
internal::Segmentation_mesh segmentation_mesh(const Soup& soup)
{
  const Mesh mesh = make_mesh(soup);
  const Readable_map<Mesh::Vertex_index, Point> sphere = {[](const Mesh::Vertex_index&) { return Point(0, 0, 1); }};
  const internal::Host_loop loop = internal::host_loop(CGAL::Sequential_tag());
  return internal::Segmentation_mesh(
    internal::read_map(mesh, mesh.points(), sphere, internal::Reading::BREADTH_FIRST, loop), loop);
}

/// How much light the two sides of the plane z = `height` exchange: 1 in a ball.
double share_across(const Soup& soup, double height)
{
  const internal::Segmentation_mesh mesh = segmentation_mesh(soup);
  const internal::Host_loop loop = internal::host_loop(CGAL::Sequential_tag());
  std::vector<int> side;
  for(const auto& f : soup.faces) {
    double z = 0;
    for(const std::size_t v : f)
      z += soup.points[v].z() / 3;
    side.push_back(z > height);
  }
  const internal::Exchange_of_light light(side, 2, mesh.face_area, internal::flights_inside(loop, mesh, 1 << 14));
  return light.share(0, 1);
}

} // namespace

TEST_CASE("a tree of rays finds the nearest face", "[segmentation]")
{
  const internal::Segmentation_mesh mesh = segmentation_mesh(spiky_star(3, 1.5));
  const internal::Ray_tree tree(mesh.point, mesh.face);
  std::mt19937 random(5);
  std::uniform_int_distribution<int> vertex(0, mesh.number_of_vertices() - 1);
  const auto any_vertex = [&] { return mesh.point[vertex(random)]; };
  const auto between_vertices = [&] {
    return add_scaled(add_scaled(scale(0.2, any_vertex()), 0.3, any_vertex()), 0.5, any_vertex());
  };
  int hits = 0;
  for(int i = 0; i < 500; ++i) {
    const vec3 origin = between_vertices();
    const internal::Ray ray = {origin,
                               i % 10 == 0 ? vec3{0, 0, 1} : sub(between_vertices(), origin)}; // some along an axis
    const int hit = tree.first_hit(ray, -1);
    int expected = -1; // the nearest of the triangles, by the plane and the three sides
    double nearest = 1e300;
    for(int f = 0; f < mesh.number_of_faces(); ++f) {
      const vec3 n = SP::internal::normal(mesh.point, mesh.face[f]);
      const vec3 a = mesh.point[mesh.face[f][0]];
      const double t = inner(sub(a, ray.origin), n) / inner(ray.direction, n);
      const vec3 p = add_scaled(ray.origin, t, ray.direction);
      bool is_inside = t > 0 && t < nearest;
      for(int k = 0; k < 3 && is_inside; ++k)
        is_inside = inner(outer(mesh.side(f, k), sub(p, mesh.point[mesh.face[f][k]])), n) >= 0;
      if(is_inside) {
        nearest = t;
        expected = f;
      }
    }
    CHECK(hit == expected);
    hits += hit >= 0;
    if(hit >= 0)
      CHECK(tree.first_hit(ray, hit) != hit);
  }
  CHECK(hits > 50);
}

TEST_CASE("a ray in the plane of a side of a box meets what is in the box", "[segmentation]")
{
  const internal::Segmentation_mesh mesh = segmentation_mesh(cube());
  const internal::Ray_tree tree(mesh.point, mesh.face);
  const internal::Bounding_box box(mesh.point);
  for(const double z : {box.low.z, box.high.z})
    for(const double zero : {0., -0.}) {
      const vec3 origin = {0.3 * box.low.x + 0.7 * box.high.x, 0.4 * box.low.y + 0.6 * box.high.y, z};
      CHECK(tree.first_hit({origin, {1, zero, zero}}, -1) >= 0);
    }
}

TEST_CASE("where no light is inside, it cuts nothing", "[segmentation]")
{
  Soup inside_out = spiky_star(3, 1.5);
  for(auto& f : inside_out.faces)
    std::swap(f[0], f[1]);
  const Soup sheet = transformed(icosphere(3), [](const Point& p) { return Point(p.x(), p.y(), 0); });
  internal::Monitor monitor;
  const internal::Watched_loop<internal::Host_loop> loop(internal::Host_loop(), monitor);
  for(const Soup& soup : {inside_out, sheet}) {
    const internal::Segmentation_mesh mesh = segmentation_mesh(soup);
    std::vector<int> patches(mesh.face.size());
    std::iota(patches.begin(), patches.end(), 0);
    CHECK(internal::segments_of_light(loop, mesh, patches) == std::vector<int>(patches.size(), 0));
  }
}

TEST_CASE("light spreads evenly in a ball, and hardly through a thin bar", "[segmentation]")
{
  for(const double height : {-0.5, 0., 0.7}) {
    CAPTURE(height);
    CHECK(share_across(icosphere(4), height) == Approx(1).epsilon(0.05));
  }
  const double in_dumbbell = share_across(dumbbell(4), 0);
  CHECK(in_dumbbell > 0);
  CHECK(in_dumbbell < 0.2);
}

TEST_CASE("two sides of a thin wall exchange much light", "[segmentation]")
{
  const auto flattened = [](const Point& p) { return Point(p.x(), p.y(), 0.02 * p.z()); };
  CHECK(share_across(transformed(icosphere(4), flattened), 0) == Approx(1).epsilon(0.1));
}

TEST_CASE("merging regions adds their light", "[segmentation]")
{
  const internal::Segmentation_mesh mesh = segmentation_mesh(spiky_star(3, 1.5));
  const internal::Host_loop loop = internal::host_loop(CGAL::Sequential_tag());
  const auto flights = internal::flights_inside(loop, mesh, 1 << 14);
  std::vector<int> three, two;
  for(int f = 0; f < mesh.number_of_faces(); ++f) {
    three.push_back(f % 3);
    two.push_back(f % 3 == 2 ? 0 : f % 3);
  }
  internal::Exchange_of_light merged(three, 3, mesh.face_area, flights);
  merged.merge(2, 0, 0);
  // Light of two flights by way of the third region is known better before: no more than that is different.
  CHECK(merged.share(0, 1) ==
        Approx(internal::Exchange_of_light(two, 2, mesh.face_area, flights).share(0, 1)).epsilon(0.02));
}

TEST_CASE("ways of light are the same on several threads, and end on the surface", "[segmentation]")
{
  const internal::Segmentation_mesh mesh = segmentation_mesh(dumbbell(4));
  const auto on_one = internal::flights_inside(internal::host_loop(CGAL::Sequential_tag()), mesh, 20000);
  const auto on_all = internal::flights_inside(internal::Host_loop(true), mesh, 20000);
  REQUIRE(on_one.size() == on_all.size());
  CHECK(on_one.size() > 19900); // hardly one slips between two triangles
  for(std::size_t i = 0; i < on_one.size(); ++i) {
    CHECK(on_one[i].from == on_all[i].from);
    CHECK(on_one[i].to == on_all[i].to);
  }
}
