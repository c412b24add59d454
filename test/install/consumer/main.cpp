// SPDX-License-Identifier: GPL-3.0-or-later
// Maps a tetrahedron on every policy that the components allow, and says which.

#include "map.h"

#include <CGAL/Spherical_parameterization/version.h>
#include <CGAL/boost/graph/generators.h>

#include <iostream>

int main()
{
  Mesh mesh;
  CGAL::make_tetrahedron(Mesh::Point(0, 0, 0), Mesh::Point(1, 0, 0), Mesh::Point(0, 1, 0), Mesh::Point(0, 0, 1), mesh);
  bool ok = can_map(CGAL::Sequential_tag(), mesh) && can_map_elsewhere(mesh);
  std::cout << CGAL_SPHERICAL_PARAMETERIZATION_VERSION << " sequential";
#ifdef CGAL_LINKED_WITH_TBB
  std::cout << " tbb";
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
  std::cout << " opencl";
  if(!CGAL::Spherical_parameterization::opencl_devices().empty())
    ok = ok && can_map(CGAL::Spherical_parameterization::opencl_device(), mesh);
#endif
  std::cout << std::endl;
  return ok ? 0 : 1;
}
