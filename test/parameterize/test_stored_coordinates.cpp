// SPDX-License-Identifier: GPL-3.0-or-later
// What is certified is what the sphere map holds afterwards, in the numbers it is made of.

#include "helpers/certificate.h"
#include "helpers/meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spherical_parameterization/parameterize.h>

#include <catch2/catch.hpp>

#include <array>
#include <vector>

using namespace test;
namespace SP = CGAL::Spherical_parameterization;

namespace {

/// Maps into a map of floats, reads it back and counts.
template <class Float_point, class Method>
SP::Result map_to_floats(const Soup& soup, const Method& method, Sphere& stored)
{
  Mesh mesh = make_mesh(soup);
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Float_point>("v:sphere").first;
  SP::Result result = SP::parameterize(mesh, method, sphere);
  stored.clear();
  for(const Mesh::Vertex_index v : mesh.vertices())
    stored.emplace_back(sphere[v][0], sphere[v][1], sphere[v][2]);
  return result;
}

} // namespace

TEMPLATE_TEST_CASE("a map of floats is called valid only if it is", "[stored]", (std::array<float, 3>),
                   CGAL::Simple_cartesian<float>::Point_3)
{
  Sphere stored;
  SECTION("rounding does no harm to a coarse sphere")
  {
    const Soup soup = bumpy_sphere(3);
    CHECK(map_to_floats<TestType>(soup, SP::Balanced(), stored));
    CHECK(count_flipped_faces(soup, stored) == 0);
    CHECK(degree(soup, stored) == 1);
  }
  SECTION("it flips faces in a limb, which are counted, and not called valid")
  {
    const Soup soup = capsule(8, 24); // the middle shrinks by exp(-8 pi)
    const SP::Result result = map_to_floats<TestType>(soup, SP::Balanced(), stored);
    CAPTURE(result);
    CHECK(result.error == SP::Error_code::NOT_BIJECTIVE);
    CHECK(result.flipped_faces > 0);
    CHECK(result.flipped_faces == count_flipped_faces(soup, stored));
    CHECK(result.detail.find("a sphere map of doubles") != std::string::npos);
    std::vector<std::array<double, 3>> doubles;
    CHECK(SP::parameterize_triangle_soup(soup.points, soup.faces, doubles));
  }
  SECTION("the automatic method finds one that floats can hold")
  {
    const Soup soup = capsule(8, 24);
    const SP::Result result = map_to_floats<TestType>(soup, SP::Automatic(), stored);
    CAPTURE(result);
    CHECK(bool(result));
    CHECK(result.method != "balanced");
    CHECK(count_flipped_faces(soup, stored) == 0);
    CHECK(degree(soup, stored) == 1);
  }
}
