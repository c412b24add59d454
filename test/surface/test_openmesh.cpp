// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/meshes.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include "helpers/check_graph.h"

using namespace test;

TEST_CASE("OpenMesh", "[mesh_types]")
{
  const auto mesh = make_graph<OpenMesh::PolyMesh_ArrayKernelT<>>(bumpy_sphere(3));
  check_same_map(mesh, make_soup(mesh)); // of its points, which are floats
}
