// SPDX-License-Identifier: GPL-3.0-or-later
// Surface_mesh: with garbage, and over other kernels.

#include "helpers/check_graph.h"
#include "helpers/meshes.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

using namespace test;

TEST_CASE("a Surface_mesh with garbage maps like the same mesh without", "[mesh_types]")
{
  Mesh mesh = make_mesh(bumpy_sphere(3));
  // ids with holes: every tenth edge is collapsed
  std::size_t collapsed = 0;
  for(std::size_t i = 0; i < mesh.num_edges(); i += 10) {
    const Mesh::Edge_index e(static_cast<Mesh::size_type>(i));
    if(!mesh.is_removed(e) && CGAL::Euler::does_satisfy_link_condition(e, mesh)) {
      CGAL::Euler::collapse_edge(e, mesh);
      ++collapsed;
    }
  }
  REQUIRE(collapsed > 50);
  REQUIRE(mesh.has_garbage());
  REQUIRE(mesh.num_vertices() > mesh.number_of_vertices());

  // The neighbours of a vertex come in another order than in the mesh made of the soup. That decides how the map whose
  // residual has come down to 1e-5 differs from the solution, and the balance refers to it.
  const double tolerance = 2e-6;
  const Soup soup = make_soup(mesh);
  check_same_map(mesh, soup, tolerance);
  mesh.collect_garbage();
  check_same_map(mesh, soup, tolerance);
}

TEST_CASE("a kernel with exact predicates", "[mesh_types]")
{
  const Soup soup = bumpy_sphere(3);
  check_same_map(make_graph<CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>>(soup),
                 soup);
}

TEST_CASE("a kernel with exact constructions", "[mesh_types]")
{
  const Soup soup = bumpy_sphere(3);
  check_same_map(make_graph<CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>>(soup),
                 soup);
}
