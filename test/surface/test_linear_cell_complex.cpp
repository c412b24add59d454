// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/meshes.h"

#include <CGAL/Linear_cell_complex_for_bgl_combinatorial_map_helper.h>
#include <CGAL/boost/graph/graph_traits_Linear_cell_complex_for_combinatorial_map.h>

#include "helpers/check_graph.h"

using namespace test;

TEST_CASE("Linear_cell_complex", "[mesh_types]")
{
  using Traits = CGAL::Linear_cell_complex_traits<3, Kernel>;
  using Complex = CGAL::Linear_cell_complex_for_bgl_combinatorial_map_helper<2, 3, Traits>::type;
  const Soup soup = bumpy_sphere(3);
  check_same_map(make_graph<Complex>(soup), soup);
}
