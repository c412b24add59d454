// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/check_graph.h"
#include "helpers/meshes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>

using namespace test;

TEST_CASE("Polyhedron_3, whose vertices have no numbers", "[mesh_types]")
{
  const Soup soup = bumpy_sphere(3);
  check_same_map(make_graph<CGAL::Polyhedron_3<Kernel>>(soup), soup);
}

TEST_CASE("Polyhedron_3 with numbers that nobody has set", "[mesh_types]")
{
  const Soup soup = bumpy_sphere(3);
  check_same_map(make_graph<CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3>>(soup), soup);
}
