// SPDX-License-Identifier: GPL-3.0-or-later

#include "helpers/meshes.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_PolyMesh_ArrayKernelT.h>

#include "helpers/check_graph.h"

using namespace test;

TEST_CASE("OpenMesh", "[mesh_types]")
{
  // its points are floats
  const Soup soup =
    transformed(bumpy_sphere(3), [](const Point& p) { return Point(float(p.x()), float(p.y()), float(p.z())); });
  check_same_map(make_graph<OpenMesh::PolyMesh_ArrayKernelT<>>(soup), soup);
}
