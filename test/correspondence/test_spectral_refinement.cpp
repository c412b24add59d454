// SPDX-License-Identifier: GPL-3.0-or-later
// internal/correspondence/Spectral_refinement.h and places_on_sphere.h

#include "helpers/meshes.h"
#include "helpers/property_maps.h"
#include "helpers/solve.h"

#include <CGAL/Spherical_parameterization/internal/correspondence/Spectral_refinement.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/coarse_map.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/places_on_sphere.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <catch2/catch.hpp>

#include <numeric>
#include <vector>

using namespace test;
using namespace CGAL::Spherical_parameterization::internal;

TEST_CASE("by all of its eigenfunctions a body with limbs is mapped to itself vertex by vertex", "[registration]")
{
  const std::vector<Vector>& d = six_directions();
  const Soup soup = body_with_limbs({{d[0], 0.4, 2.5}, {d[1], 0.3, 2}, {d[2], 0.4, 1.2}}, 4).soup;
  const Mesh mesh = make_mesh(soup);
  Settings settings;
  settings.method = SP::Isometric();
  const Sphere sphere = solve_or_throw(soup, settings);
  const Readable_map<Mesh::Vertex_index, Point> images = {[&](Mesh::Vertex_index v) { return sphere[v]; }};
  const Host_loop loop;
  Monitor monitor(1e9, {}, false);
  const Mapped_surface map = read_map(mesh, mesh.points(), images, Reading::CHECKED, loop);
  const Watched_loop<Host_loop> watched(loop, monitor);
  const Coarse_map of_area_1(watched, {map.copy_of_corner_table(loop), map.point, map.image}, {}, 1 << 20);
  const Spectral_shape<Host_loop> shape(loop, of_area_1, monitor);
  typedef Spectral_refinement<Host_loop> Refinement;
  const Refinement refinement(watched, shape, shape, {}, false);
  const int n = shape.number_of_functions();
  Refinement::Map all(soup.points.size());
  std::iota(all.begin(), all.end(), 0);
  CHECK(refinement.nearest(all, Refinement::Rows::Identity(n, n)) == all);

  // and the refinement of the right answer leaves it there, with its orientation
  const Refinement::Map right = Refinement::first(shape.sample, shape.some);
  const Refinement::Candidate same = refinement.upsample(right, shape.some, all, {20, 40});
  CHECK(same.map == right);
  CHECK(same.orientation > 0.9);
}

TEST_CASE("places follow their anchors", "[registration]")
{
  const Matrix_3 rotation = super_fibonacci_rotation(3, 10);
  Places places, rotated_places;
  for(const Point& p : icosphere(2).points) {
    places.push_back({p.x(), p.y(), p.z()});
    rotated_places.push_back(rotated(rotation, places.back()));
  }
  const auto distance = [](vec3 a, vec3 b) { return norm(sub(a, b)); };
  const Places found = turned(places, places, rotated_places, std::vector<double>(places.size(), 1.), 0.3);
  for(std::size_t k = 0; k < places.size(); ++k)
    CHECK(distance(found[k], rotated_places[k]) < 1e-12);

  const Places longer = moved_from(places[0], 0.2, places);
  CHECK(distance(longer[0], places[0]) < 1e-12);
  for(std::size_t k = 1; k < places.size(); ++k) {
    CHECK(norm(longer[k]) == Approx(1));
    CHECK(distance(longer[k], places[0]) > distance(places[k], places[0]) - 1e-12);
  }
}
