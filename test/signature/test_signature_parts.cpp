// SPDX-License-Identifier: GPL-3.0-or-later
// What shape_signature.h is made of, and stretch_histogram.h.

#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/internal/signature/conformal_factor.h>
#include <CGAL/Spherical_parameterization/internal/surface/persistence.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/stretch_histogram.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

using namespace test;
using namespace CGAL::Spherical_parameterization::internal;
using SP::Stretch_histogram;

namespace {

const Host_loop one_core;
Monitor nobody;
const Watched_loop<Host_loop> watched(one_core, nobody);

/// With its own points as images.
Mapped_surface surface_of(const Mesh& mesh)
{
  return read_map(mesh, mesh.points(), mesh.points(), Reading::BREADTH_FIRST, one_core);
}

Intrinsic_triangulation triangulation_of(const Soup& soup)
{
  const Mapped_surface surface = surface_of(make_mesh(soup));
  return Intrinsic_triangulation(surface.copy_of_corner_table(one_core), surface.point);
}

double total_area(const Intrinsic_triangulation& t)
{
  double sum = 0;
  for(int f = 0; f < t.number_of_faces(); ++f)
    sum += t.area(3 * f);
  return sum;
}

/// Flat and with needles: an ellipsoid squeezed in one direction.
Soup needles() { return ellipsoid(1, 30, 30, 3); }

double l1(const std::vector<double>& a, const std::vector<double>& b)
{
  double sum = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    sum += std::abs(a[i] - b[i]);
  return sum;
}

} // namespace

TEST_CASE("intrinsic triangulation: Delaunay, and the same surface", "[signature]")
{
  const Soup soup = GENERATE(needles(), bumpy_sphere(3), spiky_star(3, 4), cube(), tetrahedron(), cross());
  const Intrinsic_triangulation t = triangulation_of(soup);
  REQUIRE(t.number_of_halfedges() == static_cast<int>(3 * soup.faces.size()));
  for(int h = 0; h < t.number_of_halfedges(); ++h) {
    REQUIRE(t.twin[t.twin[h]] == h);
    CHECK(t.origin(t.twin[h]) == t.target(h));
    CHECK(t.cotangent(h) + t.cotangent(t.twin[h]) > -1e-9);
  }
  const Mapped_surface surface = surface_of(make_mesh(soup));
  const Host_array<double>& areas = surface.vertex_area(one_core);
  const double area = std::accumulate(areas.begin(), areas.end(), 0.);
  CHECK(total_area(t) == Approx(area).epsilon(1e-4)); // but for what mollifying adds
}

TEST_CASE("intrinsic triangulation: faces without area get one", "[signature]")
{
  const Intrinsic_triangulation t = triangulation_of(GENERATE(collinear_face(), coincident_points()));
  for(int h = 0; h < t.number_of_halfedges(); ++h) {
    CHECK(t.area(h) > 0);
    CHECK(std::isfinite(t.cotangent(h)));
  }
}

TEST_CASE("discrete surface: area and curvature are 4 pi, the Laplacian is what it should be", "[signature]")
{
  const Discrete_surface surface(triangulation_of(GENERATE(bumpy_sphere(3), needles(), dumbbell(3))));
  const Discrete_surface::Vector one = Discrete_surface::Vector::Ones(surface.size());
  CHECK(surface.mass().sum() == Approx(4 * pi));
  CHECK(surface.defect().sum() == Approx(4 * pi)); // Gauss and Bonnet
  CHECK((surface.laplacian() * one).cwiseAbs().maxCoeff() < 1e-9);
  CHECK((smoothed(watched, surface, one, 0.1) - one).cwiseAbs().maxCoeff() < 1e-9);
}

TEST_CASE("discrete surface: harmonics of the sphere", "[signature]")
{
  const Soup soup = icosphere(5);
  const Mapped_surface source = surface_of(make_mesh(soup));
  const Discrete_surface surface(Intrinsic_triangulation(source.copy_of_corner_table(one_core), source.point));
  Discrete_surface::Vector z(surface.size()), slope(surface.size());
  for(int i = 0; i < surface.size(); ++i) {
    z[i] = soup.points[std::size_t(source.position[i])].z();
    slope[i] = std::sqrt(1 - z[i] * z[i]);
  }
  // z is an eigenfunction, of the eigenvalue 2
  CHECK((surface.laplacian() * z - 2 * surface.mass().cwiseProduct(z)).norm() < 0.01 * surface.mass().norm());
  Discrete_surface::Vector x = Surface_solver<>(watched, surface)(2 * surface.mass().cwiseProduct(z));
  x.array() -= x.mean();
  CHECK((x - z).cwiseAbs().maxCoeff() < 0.01);
  CHECK((smoothed(watched, surface, z, 0.5) - z / 2).cwiseAbs().maxCoeff() < 0.01); // 1 / (1 + 2 t)
  CHECK((surface.gradient_norm(z) - slope).cwiseAbs().maxCoeff() < 0.05);
}

TEST_CASE("discrete surface: large ones are solved as accurately as small ones", "[signature]")
{
  const Discrete_surface surface(triangulation_of(bumpy_sphere(7)));
  REQUIRE(surface.size() > 100000); // by multigrid
  const Discrete_surface::Vector b = surface.mass() - surface.defect();
  CHECK((surface.laplacian() * Surface_solver<>(watched, surface)(b) - b).norm() < 1e-6 * b.norm());
}

TEST_CASE("discrete surface: a singular system is refused, and not solved with what is in the memory", "[signature]")
{
  Mapped_surface source = surface_of(make_mesh(icosphere(1)));
  source.point.push_back({1, 1, 1}); // a vertex without triangles: its row is zero
  const Discrete_surface surface(Intrinsic_triangulation(source.copy_of_corner_table(one_core), source.point));
  CHECK_THROWS_AS(Surface_solver<>(watched, surface), SP::Error);
}

TEST_CASE("midpoint refinement: the same surface in four times as many faces", "[signature]")
{
  const Mapped_surface source = surface_of(make_mesh(bumpy_sphere(1)));
  const Triangle_surface coarse = {source.copy_of_corner_table(one_core), source.point};
  const Triangle_surface fine = refined_at_midpoints(refined_at_midpoints(coarse));
  REQUIRE(fine.face.size() == 16 * coarse.face.size());
  CHECK(2 * fine.point.size() == fine.face.size() + 4); // Euler
  CHECK(total_area(Intrinsic_triangulation(fine, fine.point)) ==
        Approx(total_area(Intrinsic_triangulation(coarse, coarse.point))));
  for(std::size_t h = 0; h < fine.twin.size(); ++h) {
    const auto origin = [&](std::size_t g) { return fine.face[g / 3][g % 3]; };
    const std::size_t t = fine.twin[h];
    CHECK(static_cast<std::size_t>(fine.twin[t]) == h);
    CHECK(origin(h) == origin(t / 3 * 3 + (t + 1) % 3));
    CHECK(origin(t) == origin(h / 3 * 3 + (h + 1) % 3));
  }
}

TEST_CASE("conformal factor: the sphere is mapped to itself without stretch", "[signature]")
{
  const Soup soup = icosphere(4);
  const Mesh mesh = make_mesh(soup);
  const Conformal_factor factor(watched, surface_of(mesh));
  CHECK(factor.u.cwiseAbs().maxCoeff() < 0.01);
}

TEST_CASE("conformal factor: that of a boost of the sphere", "[signature]")
{
  // The sphere of the map is moved by a Moebius transformation, x -> boost(x, c): areas change by a known factor.
  const Soup soup = icosphere(5);
  const Mesh mesh = make_mesh(soup);
  const vec3 c = {0.3, 0.1, -0.2};
  const auto moved = [&](const Point& p) { return SP::internal::boost({p.x(), p.y(), p.z()}, c); };
  const Readable_map<Mesh::Vertex_index, Point> images = {[&](const Mesh::Vertex_index& v) {
    const vec3 q = moved(mesh.point(v));
    return Point(q.x, q.y, q.z);
  }};
  const Mapped_surface source = read_map(mesh, mesh.points(), images, Reading::BREADTH_FIRST, one_core);
  const Conformal_factor factor(watched, source);
  for(int i = 0; i < factor.surface.size(); ++i) {
    const Point p = mesh.point(Mesh::Vertex_index(Mesh::size_type(source.position[std::size_t(i)])));
    const vec3 d = sub({p.x(), p.y(), p.z()}, c);
    CHECK(factor.u[i] == Approx(2 * std::log((1 - inner(c, c)) / inner(d, d))).margin(0.02));
  }
}

TEST_CASE("persistence of a function on a path", "[signature]")
{
  const std::vector<double> f = {0, 3, 1, 5, 2, 4, 3.5}, mass(f.size(), 1);
  const std::vector<Basin> found = basins(f, mass, [&](int i, const auto& visit) {
    if(i > 0)
      visit(i - 1);
    if(i + 1 < static_cast<int>(f.size()))
      visit(i + 1);
  });
  REQUIRE(found.size() == 4);
  CHECK(found[0].minimum == 0);
  CHECK(found[0].persistence == 5); // the range, and all mass
  CHECK(found[0].mass == 7);
  CHECK(found[1].minimum == 4);
  CHECK(found[1].persistence == 3); // 2, meets 0 at 5
  CHECK(found[1].mass == 3);
  CHECK(found[2].minimum == 2);
  CHECK(found[2].persistence == 2); // 1, meets 0 at 3
  CHECK(found[2].mass == 1);
  CHECK(found[3].minimum == 6);
  CHECK(found[3].persistence == 0.5); // 3.5, meets 2 at 4
  CHECK(found[3].mass == 1);
}

TEST_CASE("stretch histogram: sampling tends to exact areas", "[signature]")
{
  const Soup soup = spiky_star(4, 3);
  const Mesh mesh = make_mesh(soup);
  const Sphere sphere = solve_or_throw(soup);
  const Readable_map<Mesh::Vertex_index, Point> map = {[&](const Mesh::Vertex_index& v) { return sphere[v]; }};
  const auto histogram = [&](Stretch_histogram options) { return SP::stretch_histogram(mesh, map, options); };
  Stretch_histogram options;
  options.scale = GENERATE(Stretch_histogram::Scale::LOGARITHMIC, Stretch_histogram::Scale::LINEAR);
  const std::vector<double> exact = histogram(options);
  CHECK(exact.size() == options.bins);
  CHECK(std::accumulate(exact.begin(), exact.end(), 0.) == Approx(1));

  options.number_of_samples = 1 << 16;
  options.sampling = Stretch_histogram::Sampling::RANDOM;
  const std::vector<double> random = histogram(options);
  CHECK(l1(random, exact) < 0.03);
  CHECK(random == histogram(options));
  options.random_seed = 1;
  CHECK(random != histogram(options));
  options.sampling = Stretch_histogram::Sampling::UNIFORM;
  CHECK(l1(histogram(options), exact) < 0.01);
  options.sampling = Stretch_histogram::Sampling::VERTICES;
  CHECK(l1(histogram(options), exact) > 0.1); // the triangles in the spikes are larger
}

TEST_CASE("stretch histogram: counts what log_area_stretch() says", "[signature]")
{
  // The identity of the sphere has stretch 1 everywhere.
  const Mesh mesh = make_mesh(icosphere(4));
  Stretch_histogram options;
  options.bins = 3;
  options.low = -0.3;
  options.high = 0.3;
  CHECK(SP::stretch_histogram(mesh, mesh.points(), options) == std::vector<double>{0, 1, 0});
  options.scale = Stretch_histogram::Scale::LINEAR;
  options.low = 0.7;
  options.high = 1.3;
  CHECK(SP::stretch_histogram(mesh, mesh.points(), options) == std::vector<double>{0, 1, 0});
  options.low = 2; // outside: the first bin
  options.high = 3;
  CHECK(SP::stretch_histogram(mesh, mesh.points(), options) == std::vector<double>{1, 0, 0});

  // however large the mesh is
  for(const double scale : {1e-200, 1e200}) {
    const Mesh scaled = make_mesh(
      transformed(icosphere(4), [&](const Point& p) { return Point(scale * p.x(), scale * p.y(), scale * p.z()); }));
    CHECK(SP::stretch_histogram(scaled, mesh.points(), options) == std::vector<double>{1, 0, 0});
  }
  const Mesh point = make_mesh(one_point(2));
  CHECK_THROWS_AS(SP::stretch_histogram(point, mesh.points(), options), SP::Error);
  const auto check_refused = [&](const Stretch_histogram& wrong) {
    CHECK_THROWS_AS(SP::stretch_histogram(mesh, mesh.points(), wrong), CGAL::Precondition_exception);
  };
  options.low = -std::numeric_limits<double>::infinity();
  check_refused(options);
  options.low = 2;
  options.bins = 1;
  check_refused(options);
}
