// SPDX-License-Identifier: GPL-3.0-or-later
// What segmentations along concave creases are made of.

#include "helpers/meshes.h"
#include "helpers/property_maps.h"

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/concave_cuts.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

using namespace test;
namespace internal = CGAL::Spherical_parameterization::internal;

namespace {

const internal::Host_loop one_core;

/// Creases do not ask where vertices are on the sphere.
internal::Segmentation_mesh segmentation_mesh(const Soup& soup)
{
  const Mesh mesh = make_mesh(soup);
  const Readable_map<Mesh::Vertex_index, Point> sphere = {[](const Mesh::Vertex_index&) { return Point(0, 0, 1); }};
  return internal::Segmentation_mesh(
    internal::read_map(mesh, mesh.points(), sphere, internal::Reading::BREADTH_FIRST, one_core), one_core);
}

} // namespace

TEST_CASE("normals are smoothed as well and as soon in any order of the faces", "[segmentation]")
{
  const Soup soup = bumpy_sphere(7);
  std::vector<std::size_t> order(soup.faces.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  Soup shuffled = soup;
  for(std::size_t i = 0; i < order.size(); ++i)
    shuffled.faces[i] = soup.faces[order[i]];
  const auto smoothed = [](const Soup& some, int& calls) { // of the callback: one for each iteration, and a few
    internal::Monitor monitor(
      std::numeric_limits<double>::infinity(), [&](double) { return ++calls > 0; }, false);
    const internal::Watched_loop<internal::Host_loop> loop(one_core, monitor);
    return internal::smoothed_normals(loop, segmentation_mesh(some), 0.1);
  };
  int calls = 0, calls_of_shuffled = 0;
  const auto normals = smoothed(soup, calls), normals_of_shuffled = smoothed(shuffled, calls_of_shuffled);
  CHECK(calls_of_shuffled <= 2 * calls);
  double largest = 0;
  for(std::size_t i = 0; i < order.size(); ++i)
    largest = std::max(largest, internal::norm(internal::sub(normals[order[i]], normals_of_shuffled[i])));
  CHECK(largest < 2e-3);
}

TEST_CASE("of all pairs of regions that with the smallest key is merged, and of equal ones the first", "[segmentation]")
{
  const internal::Segmentation_mesh mesh = segmentation_mesh(bumpy_sphere(3));
  internal::Monitor monitor;
  const internal::Watched_loop<internal::Host_loop> loop(one_core, monitor);
  std::vector<int> faces(mesh.face.size());
  std::iota(faces.begin(), faces.end(), 0);
  internal::Region_graph regions(loop, mesh, faces, internal::side_lengths(mesh));
  // Unlike areas and lengths, these keys rise and fall as regions grow, and many are equal.
  const auto key = [&](int a, const internal::Region_graph::Border& border) {
    const double area = regions.area(a) + regions.area(border.region);
    return std::floor(20 * std::sin(500 * area + 30 * border.cost));
  };
  typedef std::tuple<double, int, int> Pair;
  Pair least;
  int mergers = 0;
  const auto goes_on = [&](double smallest) {
    least = {std::numeric_limits<double>::infinity(), 0, 0};
    for(int a = 0; a < regions.capacity(); ++a)
      if(regions.is_region(a))
        for(const internal::Region_graph::Border& border : regions.borders(a))
          least = std::min(least, Pair(key(a, border), std::min(a, border.region), std::max(a, border.region)));
    CHECK(smallest == std::get<0>(least));
    return mergers < 400;
  };
  internal::merge_in_order(regions, key, goes_on, [&](int a, int b, int) {
    CHECK((a == std::get<1>(least) && b == std::get<2>(least)));
    ++mergers;
  });
  CHECK(mergers == 400);
  CHECK(regions.number_of_regions() == mesh.face.size() - 400);
}
