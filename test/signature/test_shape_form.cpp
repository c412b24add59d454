// SPDX-License-Identifier: GPL-3.0-or-later
// shape_form.h: what a form depends on, and how shapes are ranked.

#include "helpers/meshes.h"

#include <CGAL/Spherical_parameterization/shape_form.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

using namespace test;
using SP::Shape_description;
using SP::Shape_form;

namespace {

Shape_form form_of(const Soup& soup) { return SP::shape_form(make_mesh(soup)); }

/// The distance is that of the places, which are one behind the other.
std::vector<Shape_description> shapes_at(const std::vector<double>& places)
{
  std::vector<Shape_description> shapes(places.size());
  for(std::size_t i = 0; i < places.size(); ++i)
    shapes[i].signature.values[0] = places[i];
  return shapes;
}

} // namespace

TEST_CASE("form: position, size, orientation and mirroring do not matter, and the mesh little", "[signature][form]")
{
  const std::vector<Soup> all = {ellipsoid(1, 2, 3, 4), bumpy_sphere(4), dumbbell(4), spiky_star(4, 3), capsule(2, 24)};
  const std::array<Vector, 3> rows = random_rotation(5);
  const double size = GENERATE(1., 1e-9, 1e9);
  for(std::size_t i = 0; i < all.size(); ++i) {
    const Shape_form form = form_of(all[i]);
    Soup moved = transformed(all[i], [&](const Point& p) {
      const Point q = apply(rows, p);
      return Point(-size * (q.x() + 3), size * (q.y() - 2), size * (q.z() + 1));
    });
    for(auto& face : moved.faces)
      std::swap(face[1], face[2]);
    Soup other = all[i]; // order of the faces
    std::rotate(other.faces.begin(), other.faces.begin() + static_cast<std::ptrdiff_t>(other.faces.size() / 3),
                other.faces.end());
    std::reverse(other.faces.begin(), other.faces.end());
    const double within = std::max(SP::distance(form_of(moved), form), SP::distance(form_of(other), form));
    for(std::size_t j = 0; j < all.size(); ++j)
      if(j != i) {
        CAPTURE(i, j, size);
        CHECK(within < 0.2);
        CHECK(2 * within < SP::distance(form, form_of(all[j])));
      }
  }
}

TEST_CASE("form: that of a ball is known", "[signature][form]")
{
  const Shape_form form = form_of(icosphere(5));
  // pairs: the distance d of points on a sphere has the density d / 2, and |cos| is evenly spread
  double sum = 0;
  for(std::size_t bin = 0; bin < 16; ++bin) {
    double share = 0;
    for(std::size_t angle = 0; angle < 4; ++angle)
      share += 0.435 * form.values[4 * bin + angle];
    sum += share;
    if(bin > 0 && bin < 7) // bins of width 1/4, between whose centres is interpolated
      CHECK(share == Approx((bin + 0.5) / 32).margin(0.003));
  }
  CHECK(sum == Approx(1));
  for(std::size_t angle = 0; angle < 4; ++angle) {
    double share = 0;
    for(std::size_t bin = 0; bin < 16; ++bin)
      share += 0.435 * form.values[4 * bin + angle];
    CHECK(share == Approx(0.25).margin(0.005));
  }
  // the radius is 1, and normals point along it
  const double radii = std::accumulate(form.values.begin() + 64, form.values.end(), 0.);
  CHECK(0.88 * radii == Approx(1));
  CHECK(0.88 * (form.values[64 + 4 * 4 + 3] + form.values[64 + 4 * 5 + 3]) > 0.99);
}

TEST_CASE("form: samples are spread evenly over large faces, too", "[signature][form]")
{
  CHECK(SP::distance(form_of(flat_octahedron(0)), form_of(flat_octahedron(5))) < 0.1); // the same surface
}

TEST_CASE("form: what has none", "[signature][form]")
{
  CHECK_THROWS_AS(SP::shape_form(make_mesh(open_sphere(2))), SP::Error);
  CHECK_THROWS_AS(SP::shape_form(make_mesh(torus(8, 8))), SP::Error);
  const Soup flat = transformed(icosphere(1), [](const Point&) { return Point(0, 0, 0); });
  CHECK_THROWS_AS(SP::shape_form(make_mesh(flat)), SP::Error);
}

TEST_CASE("relevance: chains of similar shapes count, not the distance alone", "[signature][form]")
{
  std::vector<double> places(8);
  std::iota(places.begin(), places.end(), 0.); // the query at 0, and a chain up to 7
  for(int i = 0; i < 8; ++i)
    places.push_back(-6 - 0.1 * i); // others that are nearer than the end of the chain
  const std::vector<double> relevance = SP::relevance_of_shapes(shapes_at(places));
  REQUIRE(relevance.size() == places.size());
  CHECK(relevance[0] == 1);
  for(std::size_t i = 1; i < relevance.size(); ++i) {
    CHECK(relevance[i] >= 0);
    CHECK(relevance[i] < 1);
  }
  CHECK(*std::min_element(relevance.begin(), relevance.begin() + 8) >
        *std::max_element(relevance.begin() + 8, relevance.end()));

  std::vector<double> permuted = places; // neither the order nor the scale
  std::reverse(permuted.begin() + 1, permuted.end());
  for(double& place : permuted)
    place *= 1e-3;
  const std::vector<double> again = SP::relevance_of_shapes(shapes_at(permuted));
  for(std::size_t i = 1; i < relevance.size(); ++i)
    CHECK(again[i] == Approx(relevance[relevance.size() - i]).margin(1e-12));
}

TEST_CASE("relevance: few shapes, and copies", "[signature][form]")
{
  CHECK(SP::relevance_of_shapes(shapes_at({})).empty());
  CHECK(SP::relevance_of_shapes(shapes_at({3})) == std::vector<double>{1});
  const std::vector<double> two = SP::relevance_of_shapes(shapes_at({3, 4}));
  CHECK(two[1] == Approx(0.95)); // the walk goes on with this probability
  for(const double place : {0., 5.}) {
    std::vector<double> places(10, 0.); // more copies than neighbours
    places.push_back(place);
    for(const double x : SP::relevance_of_shapes(shapes_at(places)))
      CHECK((x >= 0 && x <= 1));
  }
  std::vector<double> places(10, 0.); // copies do not cut themselves off from others
  places.insert(places.end(), {0.1, 5});
  const std::vector<double> relevance = SP::relevance_of_shapes(shapes_at(places));
  CHECK(relevance[10] > relevance[11]);
  CHECK(relevance[11] > 0);
  for(std::size_t i = 0; i < 10; ++i)
    places[i] = 1e-13 * double(i); // copies but for rounding
  const std::vector<double> rounded = SP::relevance_of_shapes(shapes_at(places));
  for(std::size_t i = 0; i < places.size(); ++i)
    CHECK(rounded[i] == Approx(relevance[i]).epsilon(1e-6));
}
