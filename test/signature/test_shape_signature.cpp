// SPDX-License-Identifier: GPL-3.0-or-later
// shape_signature.h: what a signature depends on, and what it does not.

#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/shape_signature.h>

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace test;
using SP::Shape_signature;

namespace {

using Vertex = Mesh::Vertex_index;

Shape_signature signature_of(const Mesh& mesh, const Sphere& sphere)
{
  return SP::shape_signature(mesh, Readable_map<Vertex, Point>{[&](const Vertex& v) { return sphere[v]; }});
}

Shape_signature signature_of(const Soup& soup, Weights weights = Weights::CLAMPED)
{
  Settings settings;
  settings.weights = weights;
  Sphere sphere;
  solve(soup, sphere, settings); // not bijective is good enough
  return signature_of(make_mesh(soup), sphere);
}

double distance_between(const Soup& a, const Soup& b) { return SP::distance(signature_of(a), signature_of(b)); }

/// Every triangle into four: the same surface.
Soup subdivided(const Soup& soup)
{
  Soup result;
  result.points = soup.points;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middle;
  const auto middle_of = [&](std::size_t i, std::size_t j) {
    const auto [it, is_new] = middle.emplace(std::minmax(i, j), result.points.size());
    if(is_new)
      result.points.push_back(CGAL::midpoint(soup.points[i], soup.points[j]));
    return it->second;
  };
  for(const auto& f : soup.faces) {
    const std::size_t a = middle_of(f[0], f[1]), b = middle_of(f[1], f[2]), c = middle_of(f[2], f[0]);
    for(const std::vector<std::size_t>& g :
        {std::vector{f[0], a, c}, std::vector{f[1], b, a}, std::vector{f[2], c, b}, std::vector{a, b, c}})
      result.faces.push_back(g);
  }
  return result;
}

Soup decimated(const Soup& soup, double share_of_edges)
{
  namespace SMS = CGAL::Surface_mesh_simplification;
  Mesh mesh = make_mesh(soup);
  // CGAL's predicate has another name from 5.6 on.
  SMS::edge_collapse(mesh, [&](const auto&, const auto&, std::size_t initial, std::size_t current) {
    return double(current) < share_of_edges * double(initial);
  });
  mesh.collect_garbage();
  return make_soup(mesh);
}

/// Rolls the z axis up to an arc, which changes lengths on a tube of radius 1 by up to 1 / radius.
Soup bent(const Soup& soup, double radius)
{
  return transformed(soup, [=](const Point& p) {
    const double angle = p.z() / radius;
    return Point((radius + p.x()) * std::cos(angle) - radius, p.y(), (radius + p.x()) * std::sin(angle));
  });
}

struct Named_shape {
  std::string name;
  Soup soup;
};

std::vector<Named_shape> shapes()
{
  return {{"ellipsoid", ellipsoid(1, 2, 3, 4)},
          {"bumpy sphere", bumpy_sphere(4)},
          {"dumbbell", dumbbell(4)},
          {"star", spiky_star(4, 3)},
          {"capsule", capsule(2, 24)}};
}

/// The largest distance of `other(shape)` from its shape, and the smallest one of two shapes.
template <class Other>
void check_nearer_than_other_shapes(Other other, double factor)
{
  const std::vector<Named_shape> all = shapes();
  std::vector<Shape_signature> signatures;
  for(const Named_shape& shape : all)
    signatures.push_back(signature_of(shape.soup));
  for(std::size_t i = 0; i < all.size(); ++i) {
    const Shape_signature changed = signature_of(other(all[i].soup));
    const double within = SP::distance(changed, signatures[i]);
    for(std::size_t j = 0; j < all.size(); ++j)
      if(j != i) {
        CAPTURE(all[i].name, all[j].name);
        CHECK(within < factor * SP::distance(changed, signatures[j]));
      }
  }
}

} // namespace

TEST_CASE("signature: position, size and orientation do not matter", "[signature]")
{
  const std::array<Vector, 3> rows = random_rotation(5);
  const double size = GENERATE(1., 1e-9, 1e9);
  for(const Named_shape& shape : shapes()) {
    const Soup moved = transformed(shape.soup, [&](const Point& p) {
      const Point q = apply(rows, p);
      return Point(size * (q.x() + 3), size * (q.y() - 2), size * (q.z() + 1));
    });
    CAPTURE(shape.name, size);
    CHECK(distance_between(moved, shape.soup) < 1e-3);
  }
}

TEST_CASE("signature: a mirror image has the same", "[signature]")
{
  Soup soup = spiky_star(4, 3);
  Soup mirrored = transformed(soup, [](const Point& p) { return Point(-p.x(), p.y(), p.z()); });
  for(auto& f : mirrored.faces)
    std::swap(f[1], f[2]);
  CHECK(distance_between(mirrored, soup) < 1e-3);
}

TEST_CASE("signature: the order of vertices and faces does not matter", "[signature]")
{
  std::vector<std::size_t> order;
  for(const Named_shape& shape : shapes()) {
    CAPTURE(shape.name);
    CHECK(distance_between(renumbered(shape.soup, 7, order), shape.soup) < 5e-3);
  }
}

TEST_CASE("signature: the same shape by other triangles is nearer than other shapes", "[signature]")
{
  SECTION("subdivided") { check_nearer_than_other_shapes(subdivided, 0.2); }
  SECTION("decimated")
  {
    check_nearer_than_other_shapes([](const Soup& soup) { return decimated(soup, 0.5); }, 0.6);
  }
}

TEST_CASE("signature: that of a coarse mesh is that of its surface", "[signature]")
{
  const Soup soup = decimated(spiky_star(4, 3), 0.05);
  REQUIRE(soup.points.size() < 200);
  CHECK(distance_between(soup, subdivided(subdivided(soup))) < 0.2);
}

TEST_CASE("signature: another pose of a shape is nearer than other shapes", "[signature]")
{
  const Soup straight = capsule(3, 32);
  const Shape_signature pose = signature_of(bent(straight, 20));
  const double within = SP::distance(pose, signature_of(straight));
  CHECK(within > 0); // it is no isometry
  for(const Named_shape& shape : shapes()) {
    CAPTURE(shape.name);
    CHECK(within < 0.5 * SP::distance(pose, signature_of(shape.soup)));
  }
}

TEST_CASE("signature: |grad u| is 2 / radius on a tube", "[signature]")
{
  const Soup soup = capsule(6, 32);
  const Shape_signature s = signature_of(soup);
  double area = 0;
  for(const auto& f : soup.faces)
    area += std::sqrt(CGAL::squared_area(soup.points[f[0]], soup.points[f[1]], soup.points[f[2]]));
  const double radius = 1 / std::sqrt(area / (4 * std::acos(-1.))); // of the tube, where the area is 4 pi
  const double girth = std::log(2 / radius);
  const auto bin = static_cast<std::size_t>((girth + 1) / 6 * Shape_signature::fine_bins);
  const auto fine = s.values.begin() + Shape_signature::coarse_bins;
  const double there = std::accumulate(fine + (bin - 1), fine + (bin + 2), 0.);
  CHECK(there > 0.7 * std::accumulate(fine, fine + Shape_signature::fine_bins, 0.));
}

TEST_CASE("signature: what an index holds keeps its meaning", "[signature]")
{
  // An index compares what it has stored with new queries: these numbers change with the format of the index only.
  constexpr std::size_t coarse = Shape_signature::coarse_bins, all_bins = coarse + Shape_signature::fine_bins;
  const double share = 1 / 1.37; // of all area, in either histogram
  const Shape_signature ball = signature_of(make_mesh(icosphere(4)), icosphere(4).points);
  for(std::size_t k = 0; k < ball.values.size(); ++k) // has no girth, and no limbs
    CHECK(ball.values[k] == Approx(k == 0 || k == coarse ? share : 0).margin(1e-12));

  const Shape_signature capsule_2 = signature_of(capsule(2, 24));
  const auto at = capsule_2.values.begin();
  CHECK(std::accumulate(at, at + coarse, 0.) == Approx(share));
  CHECK(std::accumulate(at + coarse, at + all_bins, 0.) == Approx(share));
  // the tube of radius r: log |grad u| is log(2 / r), between -1 and 5
  CHECK(std::max_element(at, at + coarse) - at == 7);
  CHECK(std::max_element(at + coarse, at + all_bins) - (at + coarse) == 28);
  CHECK(*(at + 7) == Approx(0.3155).epsilon(1e-3));
  CHECK(*(at + coarse + 28) == Approx(0.3925).epsilon(1e-3));
  // two limbs: their lengths, and the masses
  const std::array<double, 2 * Shape_signature::limbs> limbs = {0.16174, 0.16174, 0, 0, 0, 0, 0, 0, 0.28571, 0.20112};
  for(std::size_t k = 0; k < limbs.size(); ++k)
    CHECK(capsule_2.values[all_bins + k] == Approx(limbs[k]).epsilon(1e-3).margin(1e-9));
}

TEST_CASE("signature: limbs are counted", "[signature]")
{
  const auto limbs = [](const Soup& soup) {
    const Shape_signature s = signature_of(soup);
    const auto length = s.values.begin() + Shape_signature::coarse_bins + Shape_signature::fine_bins;
    return std::count_if(length, length + Shape_signature::limbs, [](double x) { return x > 0; });
  };
  CHECK(limbs(icosphere(4)) == 0);
  CHECK(limbs(capsule(3, 24)) == 2);
  CHECK(limbs(spiky_star(5, 3)) == 7);
}

TEST_CASE("signature: in thin limbs it does not matter what the map is like", "[signature]")
{
  SECTION("barycentric")
  {
    const Soup soup = capsule(4, 24); // whose triangles are alike: on others a barycentric map differs in large parts
    CHECK(SP::distance(signature_of(soup), signature_of(soup, Weights::BARYCENTRIC)) < 0.1);
  }
  SECTION("conformal, but thinner than doubles resolve")
  {
    const Soup soup = capsule(15, 24);
    Sphere sphere;
    const Result result = solve(soup, sphere);
    REQUIRE(result.error != Error_code::OK); // or this tests nothing
    const Shape_signature s = signature_of(make_mesh(soup), sphere);
    CHECK(SP::distance(s, signature_of(capsule(15, 32))) < 0.2);
  }
}

TEST_CASE("signature: degenerate triangles do no harm", "[signature]")
{
  const auto [name, soup] =
    GENERATE(table<std::string, Soup>({{"collinear", collinear_face()}, {"coincident", coincident_points()}}));
  Settings settings;
  settings.weights = Weights::BARYCENTRIC;
  const Shape_signature s = signature_of(make_mesh(soup), solve_or_throw(soup, settings));
  CAPTURE(name);
  CHECK(std::all_of(s.values.begin(), s.values.end(), [](double x) { return std::isfinite(x) && x >= 0; }));
}

TEST_CASE("signature: meshes and maps that have none are refused", "[signature]")
{
  const auto check_refused = [](const Mesh& mesh, const Sphere& sphere, const std::string& word) {
    CAPTURE(word);
    CHECK_THROWS_AS(signature_of(mesh, sphere), std::invalid_argument);
    CHECK_THROWS_WITH(signature_of(mesh, sphere), Catch::Contains(word));
  };
  const auto check_mesh = [&](const Soup& soup, const std::string& word) {
    check_refused(make_mesh(soup), soup.points, word);
  };
  check_mesh(torus(8, 8), "genus");
  check_mesh(open_sphere(2), "closed");
  check_mesh(two_spheres(), "components");
  check_mesh(isolated_vertex(), "without faces");
  check_mesh(quad_cube(), "not a triangle");
  check_mesh(nan_coordinate(), "finite");
  check_mesh({}, "no faces");
  check_mesh(transformed(icosphere(1), [](const Point&) { return Point(1, 2, 3); }), "area");

  const Soup soup = icosphere(1);
  check_refused(make_mesh(soup), Sphere(soup.points.size(), Point(1, 0, 0)), "map");
  check_refused(make_mesh(soup), Sphere(soup.points.size(), Point(NAN, 0, 0)), "not finite");
}

TEST_CASE("signature: any FaceGraph has one", "[signature]")
{
  typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
  const Soup soup = dumbbell(3);
  const Sphere sphere = solve_or_throw(soup);
  const Polyhedron polyhedron = make_graph<Polyhedron>(soup);
  std::map<boost::graph_traits<Polyhedron>::vertex_descriptor, Point> positions;
  std::size_t i = 0;
  for(auto v : vertices(polyhedron))
    positions[v] = sphere[i++];
  const Shape_signature s = SP::shape_signature(polyhedron, boost::make_assoc_property_map(positions));
  CHECK(s.values == signature_of(make_mesh(soup), sphere).values);
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("signature: the same bits on several threads", "[signature]")
{
  const int level = GENERATE(4, 7); // by Cholesky, by multigrid
  const Mesh mesh = make_mesh(bumpy_sphere(level)), round = make_mesh(icosphere(level));
  CHECK(SP::shape_signature(mesh, round.points()).values ==
        SP::shape_signature(CGAL::Parallel_tag(), mesh, round.points()).values);
}
#endif

TEST_CASE("signatures: callback and time limit end them", "[signature]")
{
  const Soup small = icosphere(3), large = icosphere(7); // by factorization, and by multigrid
  const auto call = [](const Soup& soup, const auto& np) -> std::string {
    try {
      SP::shape_signature(CGAL::Parallel_if_available_tag(), make_mesh(soup),
                          Readable_map<Vertex, Point>{[&](const Vertex& v) { return soup.points[v]; }}, np);
    } catch(const SP::Error& error) {
      CHECK(error.code() == SP::Error_code::INTERRUPTED);
      return error.detail();
    }
    return "";
  };
  int calls = 0;
  CHECK(call(large, CGAL::parameters::callback([&](double) { return ++calls > 0; })).empty());
  CHECK(calls > 20);
  for(const int most : {0, 1, 2, 10, 20}) {
    int left = most;
    CHECK(call(large, CGAL::parameters::callback([&](double) { return left-- > 0; })) == "stopped by the callback");
  }
  int left = 1;
  CHECK(call(small, CGAL::parameters::callback([&](double) { return left-- > 0; })) == "stopped by the callback");
  CHECK(call(small, CGAL::parameters::maximum_running_time(0)) == "the time limit was reached");
}
