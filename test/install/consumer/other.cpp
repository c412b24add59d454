// SPDX-License-Identifier: GPL-3.0-or-later
// A second translation unit with all headers: nothing may be defined twice.

#include "map.h"

bool can_map_elsewhere(Mesh& mesh)
{
#ifdef CGAL_LINKED_WITH_TBB
  return can_map(CGAL::Parallel_tag(), mesh);
#else
  // main.cpp has mapped it
  const auto sphere = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:sphere").first; // or the one there is
  return CGAL::Spherical_parameterization::degree_of_map(mesh, sphere) == 1;
#endif
}
