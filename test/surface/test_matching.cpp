// SPDX-License-Identifier: GPL-3.0-or-later
// The corners round every vertex, and the halfedges that match there, against what a map of all edges says.

#include "helpers/meshes.h"

#include <CGAL/Spherical_parameterization/internal/surface/fans.h>
#include <CGAL/Spherical_parameterization/internal/surface/match_halfedges.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <utility>
#include <vector>

using namespace test;
namespace I = CGAL::Spherical_parameterization::internal;

namespace {

using Faces = I::Host_array<std::array<int, 3>>;

Faces faces_of(const Soup& soup)
{
  Faces faces;
  for(const auto& f : soup.faces)
    faces.push_back({int(f[0]), int(f[1]), int(f[2])});
  return faces;
}

/// Three different corners each, in no order at all.
Faces random_faces(int n, int count, unsigned seed)
{
  std::mt19937 random(seed);
  Faces faces;
  while(int(faces.size()) < count) {
    const std::array<int, 3> f = {int(random() % unsigned(n)), int(random() % unsigned(n)),
                                  int(random() % unsigned(n))};
    if(f[0] != f[1] && f[1] != f[2] && f[2] != f[0])
      faces.push_back(f);
  }
  return faces;
}

/// Compares with the halfedges of every edge, from the smaller end and towards it.
void check_matching(const Faces& faces, int n)
{
  std::map<std::pair<int, int>, std::array<std::vector<int>, 2>> edges;
  const auto end = [&](int h, int step) { return faces[std::size_t(h) / 3][std::size_t(h + step - h / 3 * 3) % 3]; };
  const int m = 3 * int(faces.size());
  for(int h = 0; h < m; ++h)
    edges[std::minmax(end(h, 0), end(h, 1))][end(h, 0) > end(h, 1)].push_back(h);
  I::Matching_troubles expected;
  std::vector<int> twin(std::size_t(m), -1);
  for(const auto& [ends, sides] : edges) {
    const std::size_t count = sides[0].size() + sides[1].size();
    if(count > 2)
      expected.crowded.add({1, ends});
    else if(count == 1)
      expected.boundary.add({1, ends});
    else if(sides[0].size() != 1)
      expected.opposed.add({1, ends});
    else {
      twin[std::size_t(sides[0][0])] = sides[1][0];
      twin[std::size_t(sides[1][0])] = sides[0][0];
    }
  }

  for(const bool on_all_cores : {false, true}) {
    I::Host_array<int> found;
    const I::Matching_troubles troubles = I::match_halfedges(I::Host_loop(on_all_cores), faces, n, found);
    CHECK(std::equal(found.begin(), found.end(), twin.begin(), twin.end()));
    const auto same = [](const auto& a, const auto& b) { return a.count == b.count && a.first == b.first; };
    CHECK(same(troubles.crowded, expected.crowded));
    CHECK(same(troubles.opposed, expected.opposed));
    CHECK(same(troubles.boundary, expected.boundary));
  }
}

} // namespace

TEST_CASE("halfedges match wherever an edge has two faces of one orientation", "[mesh]")
{
  check_matching(random_faces(8, 30, 1), 8);         // crowded edges
  check_matching(random_faces(60, 300, 2), 60);      // edges of all kinds
  check_matching(random_faces(5000, 9000, 3), 6000); // several blocks of vertices, many of them isolated
  check_matching(faces_of(open_sphere(3)), int(open_sphere(3).points.size()));
  check_matching(faces_of(icosphere(4)), int(icosphere(4).points.size()));
  check_matching(faces_of(bipyramid(100)), 102); // two vertices of degree 100
  Faces wrong = faces_of(bipyramid(100));
  std::swap(wrong[3][0], wrong[3][1]);
  check_matching(wrong, 102);
}

TEST_CASE("the faces round a vertex are met one after the other", "[mesh]")
{
  for(const Soup& soup : {icosphere(4), bipyramid(100)}) {
    const Faces faces = faces_of(soup);
    const int n = int(soup.points.size());
    I::Host_array<int> twin;
    I::Vertex_walks walks;
    REQUIRE(I::match_halfedges(I::Host_loop(), faces, n, twin, &walks).none());
    for(int v = 0; v < n; ++v) {
      int h = I::Corner_table::previous(walks.last_corner[std::size_t(v)]); // towards v
      for(int k = walks.neighbours.offset[std::size_t(v)]; k < walks.neighbours.offset[std::size_t(v) + 1]; ++k) {
        REQUIRE(walks.neighbours.target[std::size_t(k)] == faces[std::size_t(h) / 3][std::size_t(h) % 3]);
        h = twin[std::size_t(I::Corner_table::next(h))];
      }
      CHECK(h == I::Corner_table::previous(walks.last_corner[std::size_t(v)]));
    }
  }
  // two tetrahedra that touch in vertex 0, and vertex 7 without a face
  const Faces pinched = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}, {0, 5, 4}, {0, 4, 6}, {4, 5, 6}, {0, 6, 5}};
  I::Host_array<int> twin;
  const I::Matching_troubles troubles = I::match_halfedges(I::Host_loop(), pinched, 8, twin);
  CHECK_FALSE(troubles.has_bad_edge());
  CHECK((troubles.pinched.count == 1 && troubles.pinched.first == 0));
  CHECK((troubles.isolated.count == 1 && troubles.isolated.first == 7));
}
