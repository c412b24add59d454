// SPDX-License-Identifier: GPL-3.0-or-later
// Half-edge collapses and their undoing, alone.

#include "helpers/arrays.h"

#include <CGAL/Spherical_parameterization/internal/isometric/Carried_density.h>
#include <CGAL/Spherical_parameterization/internal/isometric/Progressive_mesh.h>
#include <CGAL/Spherical_parameterization/internal/isometric/decimation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

using namespace test;

namespace {

/// The faces, each from its smallest vertex on.
std::set<std::array<int, 3>> faces_of(const I::Progressive_mesh& mesh)
{
  std::set<std::array<int, 3>> faces;
  for(int v = 0; v < mesh.capacity(); ++v)
    if(!mesh.is_removed(v))
      mesh.for_each_corner(v, [&](int c) {
        std::array<int, 3> f = {mesh.vertex(c), mesh.target(c), mesh.apex(c)};
        std::rotate(f.begin(), std::min_element(f.begin(), f.end()), f.end());
        faces.insert(f);
      });
  return faces;
}

/// A closed, oriented surface of genus 0 with the degrees that the mesh says
void check_sphere(const I::Progressive_mesh& mesh)
{
  const auto faces = faces_of(mesh);
  CHECK(int(faces.size()) == 2 * mesh.number_of_vertices() - 4);
  std::set<std::pair<int, int>> edges;
  for(const auto& f : faces)
    for(int k = 0; k < 3; ++k)
      CHECK(edges.emplace(f[k], f[(k + 1) % 3]).second);
  std::vector<int> degree(mesh.capacity(), 0);
  for(const auto& [i, j] : edges) {
    CHECK(edges.count({j, i}) == 1);
    ++degree[i];
  }
  int remaining = 0;
  for(int v = 0; v < mesh.capacity(); ++v)
    if(!mesh.is_removed(v)) {
      ++remaining;
      CHECK(mesh.degree(v) == degree[v]);
      for(int w = 0; w < mesh.capacity(); ++w)
        if(w != v && !mesh.is_removed(w))
          CHECK(mesh.are_adjacent(v, w) == (edges.count({v, w}) == 1));
    }
  CHECK(remaining == mesh.number_of_vertices());
}

} // namespace

TEST_CASE("collapses keep a sphere down to a tetrahedron, and undoing them gives every mesh back", "[progressive]")
{
  const Plain_mesh source = octasphere(2);
  I::Monitor monitor;
  const I::Watched_loop loop(I::Host_loop(), monitor);
  I::Progressive_mesh mesh(loop, source.face, int(source.point.size()));
  check_sphere(mesh);
  std::vector<int> collapsed;
  std::vector<std::set<std::array<int, 3>>> before;
  Random random;
  while(mesh.number_of_vertices() > 4) {
    const int h = int(random.number(0, 3. * double(source.face.size()) - 1));
    // one that is still there: it is met at the vertex that it leaves
    if(mesh.is_removed(mesh.vertex(h)))
      continue;
    bool is_there = false;
    mesh.for_each_corner(mesh.vertex(h), [&](int c) { is_there = is_there || c == h; });
    if(!is_there)
      continue;
    const int u = mesh.vertex(h), v = mesh.target(h);
    std::set<int> at_u, at_v, common;
    mesh.for_each_corner(u, [&](int c) { at_u.insert(mesh.target(c)); });
    mesh.for_each_corner(v, [&](int c) { at_v.insert(mesh.target(c)); });
    std::set_intersection(at_u.begin(), at_u.end(), at_v.begin(), at_v.end(), std::inserter(common, common.end()));
    REQUIRE(mesh.is_collapsible(h) == (common.size() == 2));
    if(common.size() != 2)
      continue;
    before.push_back(faces_of(mesh));
    mesh.collapse(h);
    mesh.count_collapses(1);
    collapsed.push_back(h);
    CHECK(mesh.is_removed(u));
    check_sphere(mesh);
  }
  for(int v = 0; v < mesh.capacity(); ++v)
    if(!mesh.is_removed(v))
      mesh.for_each_corner(v, [&](int c) { CHECK_FALSE(mesh.is_collapsible(c)); });
  while(!collapsed.empty()) {
    mesh.undo_collapses(loop, {collapsed.back()});
    collapsed.pop_back();
    CHECK(faces_of(mesh) == before.back());
    before.pop_back();
    check_sphere(mesh);
  }
}

TEST_CASE("rounds of decimation are independent collapses, the same on all threads, and can be undone", "[progressive]")
{
  const Plain_mesh source = octasphere(4);
  I::Monitor monitor;
  const I::Watched_loop one(I::Host_loop(), monitor), all(I::Host_loop(true), monitor);
  I::Progressive_mesh mesh(one, source.face, int(source.point.size())), other = mesh;
  const auto whole = faces_of(mesh);
  I::Decimation decimation(one, source.point, mesh, {}, 4), parallel(all, source.point, other, {}, 4);
  std::vector<std::vector<int>> rounds;
  for(;;) {
    const std::vector<int> round = decimation.round();
    CHECK(parallel.round() == round);
    if(round.empty())
      break;
    rounds.push_back(round);
    if(rounds.size() < 4)
      check_sphere(mesh);
  }
  CHECK(mesh.number_of_vertices() == 4);
  CHECK(rounds.size() < 60);
  check_sphere(mesh);
  while(!rounds.empty()) {
    mesh.undo_collapses(one, rounds.back());
    rounds.pop_back();
  }
  CHECK(faces_of(mesh) == whole);
}

TEST_CASE("densities of coarse meshes are means, and undoing collapses gives those of every mesh back", "[progressive]")
{
  const Plain_mesh source = octasphere(3);
  I::Monitor monitor;
  const I::Watched_loop loop(I::Host_loop(), monitor);
  const int n = int(source.point.size());
  I::Problem problem;
  problem.face = source.face;
  problem.point = source.point;
  problem.number_of_vertices = n;
  for(const auto& f : source.face)
    problem.density.push_back(source.point[f[0]].z > 0 ? 1 : 0.1);
  I::Carried_density density(problem);
  I::Progressive_mesh mesh(loop, source.face, n);
  // The areas that the faces are wanted to have, were all of them 1
  const auto wanted = [&] {
    std::map<std::array<int, 3>, double> areas;
    for(int v = 0; v < n; ++v)
      if(!mesh.is_removed(v))
        mesh.for_each_corner(v, [&](int c) {
          I::Face_metric metric;
          metric.twice_area = 1;
          density.apply(mesh, c, 0, metric);
          areas[{mesh.vertex(c), mesh.target(c), mesh.apex(c)}] = metric.twice_area;
        });
    return areas;
  };
  I::Decimation decimation(loop, source.point, mesh, {}, 4);
  std::vector<std::vector<int>> rounds;
  std::vector<std::map<std::array<int, 3>, double>> before;
  for(;;) {
    before.push_back(wanted());
    std::vector<int> round = decimation.round();
    if(round.empty())
      break;
    for(int h : round)
      density.collapse(mesh, h);
    rounds.push_back(std::move(round));
  }
  for(const auto& [face, area] : before.back()) { // of a tetrahedron
    CHECK(area > 0.1 / 0.55 * 0.99);
    CHECK(area < 1 / 0.55 * 1.01);
  }
  before.pop_back();
  for(; !rounds.empty(); rounds.pop_back(), before.pop_back()) {
    mesh.undo_collapses(loop, rounds.back());
    for(int h : rounds.back())
      density.undo_collapse(mesh, h);
    CHECK(wanted() == before.back());
  }
}

TEST_CASE("decimation keeps the vertices that it has to, and a map a bijection", "[progressive]")
{
  const Plain_mesh source = octasphere(4);
  I::Monitor monitor;
  const I::Watched_loop loop(I::Host_loop(), monitor);
  const int n = int(source.point.size());
  std::vector<char> is_kept(n, 0);
  for(int i = 6; i < n; i += 100)
    is_kept[i] = 1;
  I::Progressive_mesh mesh(loop, source.face, n);
  const std::vector<std::vector<int>> adjacent = source.neighbours();
  const bool has_map = GENERATE(false, true);
  I::Decimation decimation(loop, source.point, mesh, is_kept, 60, has_map ? &source.point : nullptr);
  while(mesh.number_of_vertices() > 60 && !decimation.round().empty()) {
    if(mesh.number_of_vertices() > 60)
      for(int i = 0; i < n; ++i)
        if(is_kept[i]) {
          REQUIRE_FALSE(mesh.is_removed(i));
          // new edges between kept vertices would be walls to others
          CHECK_FALSE(mesh.any_neighbour(
            i, [&](int j) { return is_kept[j] && std::count(adjacent[i].begin(), adjacent[i].end(), j) == 0; }));
        }
    if(has_map)
      for(const auto& [i, j, k] : faces_of(mesh))
        CHECK(I::is_positively_oriented(source.point[i], source.point[j], source.point[k]));
  }
  CHECK(mesh.number_of_vertices() <= 100);
}

TEST_CASE("a quadric is the sum of squared distances to its planes", "[progressive]")
{
  Random random;
  I::Quadric quadrics[2];
  const vec3 origins[2] = {random.vector(), random.vector()};
  struct Plane {
    vec3 normal, point;
    double weight;
  };
  std::vector<Plane> planes;
  for(int k = 0; k < 6; ++k) {
    planes.push_back({random.unit_vector(), origins[k % 2], random.number(0.1, 2)});
    quadrics[k % 2].add_plane(planes.back().normal, planes.back().weight);
  }
  quadrics[0].add(quadrics[1], I::sub(origins[0], origins[1]));
  for(int k = 0; k < 20; ++k) {
    const vec3 p = random.vector();
    double sum = 0;
    for(const Plane& plane : planes) {
      const double distance = I::inner(plane.normal, I::sub(p, plane.point));
      sum += plane.weight * distance * distance;
    }
    CHECK(quadrics[0](I::sub(p, origins[0])) == Approx(sum));
  }
}
