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
