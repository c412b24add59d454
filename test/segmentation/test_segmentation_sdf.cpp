// SPDX-License-Identifier: GPL-3.0-or-later
// Segmentation beside CGAL's by the shape diameter function, on CGAL's own meshes (Debian package libcgal-demo).

#include "helpers/partitions.h"
#include "helpers/soup.h"

#include <CGAL/Spherical_parameterization/parameterize.h>
#include <CGAL/Spherical_parameterization/segmentation.h>

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

using namespace test;
namespace SP = CGAL::Spherical_parameterization;

namespace {

typedef Mesh::Property_map<Mesh::Face_index, std::size_t> Segment_map;

class Stopwatch {
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// L. Hubert and P. Arabie, "Comparing partitions", 1985: 1 for equal partitions, 0 expected for unrelated ones.
double adjusted_rand_index(const Mesh& mesh, Segment_map a, Segment_map b)
{
  const Pairs_together pairs(
    mesh.faces(), [&](auto f) { return a[f]; }, [&](auto f) { return b[f]; });
  const double expected = pairs.in_a * pairs.in_b / pairs.all;
  return (pairs.in_both - expected) / ((pairs.in_a + pairs.in_b) / 2 - expected);
}

std::size_t count_ids(const Mesh& mesh, Segment_map segments)
{
  std::set<std::size_t> ids;
  for(auto f : mesh.faces())
    ids.insert(segments[f]);
  CHECK(*ids.begin() == 0);
  CHECK(*ids.rbegin() == ids.size() - 1);
  return ids.size();
}

} // namespace

TEST_CASE("as CGAL's segmentation by SDF values, and faster", "[segmentation]")
{
  if(!std::filesystem::exists(CGAL_DEMO_MESHES)) {
    std::cout << "SKIPPED: no meshes in '" << CGAL_DEMO_MESHES
              << "'; install the Debian package libcgal-demo and configure again" << std::endl;
    return;
  }
  for(const char* name : {"cactus.off", "cow.off", "dino.off", "bull.off", "camel.off"}) {
    CAPTURE(name);
    Mesh mesh;
    REQUIRE(CGAL::IO::read_polygon_mesh((std::filesystem::path(CGAL_DEMO_MESHES) / name).string(), mesh));
    auto sphere = mesh.add_property_map<Mesh::Vertex_index, Point>("v:sphere").first;
    REQUIRE(SP::parameterize(mesh, sphere).degree == 1);

    const std::size_t nowhere = 12345;
    const Segment_map ours = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:ours", nowhere).first;
    const Segment_map theirs = mesh.add_property_map<Mesh::Face_index, std::size_t>("f:theirs", nowhere).first;
    const Stopwatch our_watch;
    const auto result = SP::segmentation_via_area_stretch(mesh, sphere, ours);
    const double our_seconds = our_watch.seconds();
    REQUIRE(result);

    const Stopwatch their_watch;
    const std::size_t their_count = CGAL::segmentation_via_sdf_values(mesh, theirs);
    const double their_seconds = their_watch.seconds();
    REQUIRE(their_count > 1);

    // all faces have an id (none is left at `nowhere`), and all ids a face
    CHECK(count_ids(mesh, ours) == result.number_of_segments);
    CHECK(count_ids(mesh, theirs) == their_count);
    CHECK(result.number_of_segments > 1);
    CHECK(adjusted_rand_index(mesh, ours, theirs) > 0.1);
    CHECK(our_seconds < their_seconds);
  }
}
