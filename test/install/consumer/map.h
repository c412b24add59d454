// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CONSUMER_MAP_H
#define CONSUMER_MAP_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/spherical_parameterization.h>
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/OpenCL_device.h>
#endif

typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;

template <class Policy>
bool can_map(const Policy& policy, Mesh& mesh)
{
  using namespace CGAL::Spherical_parameterization;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Mesh::Point>("v:sphere").first;
  return bool(parameterize(policy, mesh, Balanced(), sphere));
}

bool can_map_elsewhere(Mesh& mesh);

#endif // CONSUMER_MAP_H
