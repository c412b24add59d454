// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as arrays, and what is computed from them.

#include "helpers/meshes.h"

#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <CGAL/boost/graph/Euler_operations.h>

#include <catch2/catch.hpp>

#include <numeric>
#include <thread>
#include <vector>

using namespace test;
namespace I = CGAL::Spherical_parameterization::internal;
namespace SP = CGAL::Spherical_parameterization;

namespace {

const I::Host_loop one_core;

SP::Error_code code_of(const Mesh& mesh, I::Reading reading)
{
  I::Vertices<Mesh> vertex;
  try {
    I::read_surface(mesh, mesh.points(), reading, one_core, vertex);
  } catch(const SP::Error& error) {
    return error.code();
  }
  return SP::Error_code::OK;
}

} // namespace

TEST_CASE("a surface has the faces of the mesh, whatever the numbers of its vertices", "[surface]")
{
  const Mesh mesh = make_mesh(GENERATE(bumpy_sphere(3), comb(20, 3), tetrahedron()));
  const auto reading = GENERATE(I::Reading::UNCHECKED, I::Reading::CHECKED, I::Reading::BREADTH_FIRST);
  I::Vertices<Mesh> vertex;
  const I::Surface surface = I::read_surface(mesh, mesh.points(), reading, one_core, vertex);
  CHECK(surface.position.empty() == (reading != I::Reading::BREADTH_FIRST));
  REQUIRE(surface.number_of_vertices == int(mesh.number_of_vertices()));
  REQUIRE(surface.number_of_faces() == int(mesh.number_of_faces()));
  for(auto f : mesh.faces()) {
    const auto h = mesh.halfedge(f);
    const auto& corners = surface.face[std::size_t(f.idx())];
    CHECK(vertex[std::size_t(corners[0])] == mesh.source(h));
    CHECK(vertex[std::size_t(corners[1])] == mesh.target(h));
    CHECK(vertex[std::size_t(corners[2])] == mesh.target(mesh.next(h)));
  }
  CHECK(surface.is_simplicial);
  const std::vector<Mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
  CHECK(surface.twin(one_core) == I::read_twins(mesh, faces, one_core));

  const auto& of_faces = surface.face_area(one_core);
  const auto& of_vertices = surface.vertex_area(one_core);
  CHECK(std::accumulate(of_vertices.begin(), of_vertices.end(), 0.) ==
        Approx(std::accumulate(of_faces.begin(), of_faces.end(), 0.)));
}

TEST_CASE("where two edges have the same ends, opposite halfedges are those of the mesh", "[surface]")
{
  Mesh mesh = make_mesh(tetrahedron());
  CGAL::Euler::flip_edge(*halfedges(mesh).begin(), mesh);
  I::Vertices<Mesh> vertex;
  const I::Surface surface = I::read_faces(mesh, I::Reading::CHECKED, one_core, vertex);
  CHECK(!surface.is_simplicial);
  const I::Host_array<int>& twin = surface.twin(one_core);
  const I::Corner_table table = surface.copy_of_corner_table(one_core);
  for(int h = 0; h < table.number_of_halfedges(); ++h) {
    REQUIRE(twin[std::size_t(twin[std::size_t(h)])] == h);
    CHECK(table.origin(twin[std::size_t(h)]) == table.target(h));
  }
}

TEST_CASE("what is no sphere is refused, if that is asked for", "[surface]")
{
  CHECK(code_of(make_mesh(open_sphere(2)), I::Reading::CHECKED) == SP::Error_code::BOUNDARY);
  CHECK(code_of(make_mesh(two_spheres()), I::Reading::BREADTH_FIRST) == SP::Error_code::SEVERAL_COMPONENTS);
  CHECK(code_of(make_mesh(double_torus()), I::Reading::CHECKED) == SP::Error_code::WRONG_GENUS);
  CHECK(code_of(make_mesh(nan_coordinate()), I::Reading::CHECKED) == SP::Error_code::NON_FINITE_COORDINATE);
  for(const Soup& soup : {open_sphere(2), two_spheres(), double_torus(), nan_coordinate()})
    CHECK(code_of(make_mesh(soup), I::Reading::UNCHECKED) == SP::Error_code::OK);
}

TEST_CASE("threads that ask for a quantity at once get the same one", "[surface]")
{
  const Mesh mesh = make_mesh(bumpy_sphere(4));
  I::Vertices<Mesh> vertex;
  const I::Surface surface = I::read_surface(mesh, mesh.points(), I::Reading::CHECKED, one_core, vertex);
  std::vector<const I::Host_array<double>*> area(8);
  std::vector<std::thread> threads;
  for(auto& its : area)
    threads.emplace_back([&] { its = &surface.vertex_area(one_core); });
  for(std::thread& thread : threads)
    thread.join();
  for(const auto* its : area)
    CHECK(its == area[0]);
}
