// SPDX-License-Identifier: GPL-3.0-or-later
// Handles that are cut all at once, of surfaces with too many of them for shortest loops; holes.

#include "helpers/meshes.h"

#include "preparation/mend.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace {

namespace preparation = CGAL::Spherical_parameterization::preparation;

preparation::Glued_surface glued(
  const test::Soup& mesh, const std::function<void()>& go_on = [] {})
{
  preparation::Wrapping soup;
  for(const test::Point& p : mesh.points)
    soup.points.push_back({p.x(), p.y(), p.z()});
  for(const auto& face : mesh.faces)
    soup.triangles.push_back({int(face[0]), int(face[1]), int(face[2])});
  preparation::Gluing_defects none;
  return preparation::glue(soup, 0, none, go_on);
}

/// Closed, random, with hundreds of handles: both sides of every edge are those of any two triangles.
preparation::Glued_surface random_surface(int faces)
{
  preparation::Glued_surface surface;
  std::vector<int> sides;
  unsigned random = 1;
  for(int f = 0; f < faces; ++f) {
    for(int k = 0; k < 3; ++k)
      surface.add_vertex({double(f % 7), double(f % 11), double(k)});
    surface.add_face({3 * f, 3 * f + 1, 3 * f + 2});
    for(int k = 0; k < 3; ++k)
      sides.push_back(3 * f + k);
  }
  for(std::size_t i = sides.size(); i > 1; --i) {
    random = random * 1664525u + 1013904223u;
    std::swap(sides[i - 1], sides[(random >> 8) % i]);
  }
  for(std::size_t i = 0; i < sides.size(); i += 2)
    surface.glue(sides[i], sides[i + 1]);
  preparation::derive_vertices(surface);
  return surface;
}

} // namespace

TEST_CASE("handles that are cut at once leave a sphere", "[tool][preparation]")
{
  const auto check = [](preparation::Glued_surface surface, int least_genus) {
    std::vector<int> unused;
    const int faces = surface.number_of_faces();
    REQUIRE(preparation::components(surface, unused).size() == 1);
    CHECK(preparation::components(surface, unused)[0].genus() >= least_genus);
    preparation::cut_handles_at_once(surface, [] {});
    const auto components = preparation::components(surface, unused);
    REQUIRE(components.size() == 1);
    CHECK(components[0].genus() == 0);
    CHECK(components[0].holes == 0);
    CHECK(surface.number_of_faces() >= faces); // none is lost
    for(int side = 0; side < surface.number_of_sides(); ++side) {
      const int twin = surface.twin_of(side);
      CHECK((surface.twin_of(twin) == side && surface.origin(twin) == surface.target(side)));
    }
  };
  check(glued(test::torus(16, 8)), 1);
  check(glued(test::double_torus()), 2);
  check(glued(test::bumpy_sphere(2)), 0);
  check(random_surface(2), 0);
  check(random_surface(3000), 200);
}

TEST_CASE("gluing and cutting can be stopped wherever they ask", "[tool][preparation]")
{
  const test::Soup torus = test::torus(16, 8);
  const auto check = [](const auto& work, int least) { // work(go_on) asks so often
    int all = 0;
    work([&all] { ++all; });
    CHECK(all >= least);
    for(int last = 0; last < all; ++last) {
      int asked = 0;
      CHECK_THROWS_AS(work([&asked, last] {
                        if(asked++ == last)
                          throw last;
                      }),
                      int);
      CHECK(asked == last + 1);
    }
  };
  check([&](const std::function<void()>& go_on) { glued(torus, go_on); }, 5);
  check(
    [&](const std::function<void()>& go_on) {
      preparation::Glued_surface surface = glued(torus);
      preparation::cut_handles_at_once(surface, go_on);
    },
    2);
}

TEST_CASE("a hole is filled in the same way wherever memory is", "[tool][preparation]")
{
  // three faces of a cube: for their boundary, many triangulations are equally good
  constexpr int n = 5;
  preparation::Wrapping soup;
  for(std::size_t axis = 0; axis < 3; ++axis)
    for(int i = 0; i < n; ++i)
      for(int j = 0; j < n; ++j) {
        const auto first = static_cast<int>(soup.points.size());
        for(const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
          preparation::Glued_surface::Point p = {};
          p[(axis + 1) % 3] = double(i + di) / n;
          p[(axis + 2) % 3] = double(j + dj) / n;
          soup.points.push_back(p);
        }
        soup.triangles.push_back({first, first + 1, first + 2});
        soup.triangles.push_back({first, first + 2, first + 3});
      }
  preparation::Gluing_defects defects;
  const preparation::Glued_surface surface = preparation::glue(soup, 0, defects, [] {});
  auto holes = preparation::boundary_cycles(surface);
  REQUIRE(holes.size() == 1);
  REQUIRE(holes[0].size() == 6 * n);
  unsigned random = 1;
  const auto next = [&random] { return (random = random * 1664525u + 1013904223u) >> 8; };
  for(std::size_t start = 0; start < holes[0].size(); ++start) {
    std::vector<std::unique_ptr<char[]>> memory; // with gaps, in which CGAL's is put
    preparation::Glued_surface first;
    for(int repetition = 0; repetition < 20; ++repetition) {
      for(int i = 0; i < 300; ++i)
        memory.push_back(std::make_unique<char[]>(1000 + next() % 20000));
      for(auto& part : memory)
        if(next() % 2 == 0)
          part.reset();
      preparation::Glued_surface filled = surface;
      preparation::fill_hole(filled, holes[0]);
      if(repetition == 0)
        first = filled;
      CAPTURE(start, repetition);
      CHECK(preparation::boundary_cycles(filled).empty());
      CHECK((filled.faces == first.faces && filled.points == first.points));
    }
    std::rotate(holes[0].begin(), holes[0].begin() + 1, holes[0].end());
  }
}
