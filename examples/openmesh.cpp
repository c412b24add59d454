// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// A mesh of OpenMesh, with its own points and a property of its own for the sphere: no CGAL type is needed. MESH is
// read, and SPHERE written, by OpenMesh; else an ellipsoid is mapped.
//
//   openmesh [MESH [SPHERE]]

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>
#include <CGAL/spherical_parameterization.h>

#include <iostream>

namespace SP = CGAL::Spherical_parameterization;
typedef OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1) {
    SP::make_icosphere(3, mesh, get(CGAL::vertex_point, mesh));
    for(OpenMesh::VertexHandle v : mesh.vertices())
      mesh.set_point(v, OpenMesh::Vec3d(1, 2, 3) * mesh.point(v)); // component by component
  } else if(!OpenMesh::IO::read_mesh(mesh, argv[1]))
    return std::cerr << argv[1] << ": cannot be read by OpenMesh\n", 1;

  OpenMesh::VPropHandleT<OpenMesh::Vec3d> property;
  mesh.add_property(property, "sphere");
  const CGAL::OM_pmap<Mesh, OpenMesh::VertexHandle, OpenMesh::Vec3d> sphere(mesh, property);
  const auto result = SP::parameterize(mesh, sphere);
  if(!result)
    return std::cerr << result << '\n', 1;
  std::cout << "valid spherical map of " << mesh.n_vertices() << " vertices and " << mesh.n_faces() << " faces\n";

  for(OpenMesh::VertexHandle v : mesh.vertices())
    mesh.set_point(v, mesh.property(property, v));
  return argc < 3 || OpenMesh::IO::write_mesh(mesh, argv[2], OpenMesh::IO::Options::Default, 17) ? 0 : 1;
}
