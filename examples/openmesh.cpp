// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// A mesh of OpenMesh, with its own points and a property of its own for the sphere: no CGAL type is needed. MESH is read,
// and SPHERE written, by OpenMesh; else an octahedron is mapped.
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

void make_octahedron(Mesh& mesh, double height)
{
  OpenMesh::VertexHandle v[6];
  for(int k = 0; k < 3; ++k)
    for(int side = 0; side < 2; ++side) {
      OpenMesh::Vec3d p(0, 0, 0);
      p[k] = (side == 0 ? 1 : -1) * (k == 2 ? height : 1);
      v[2 * k + side] = mesh.add_vertex(p);
    }
  for(int x = 0; x < 2; ++x)
    for(int y = 0; y < 2; ++y)
      for(int z = 0; z < 2; ++z) // an odd number of negative coordinates mirrors the face
        (x + y + z) % 2 == 0 ? mesh.add_face(v[x], v[2 + y], v[4 + z]) : mesh.add_face(v[x], v[4 + z], v[2 + y]);
}

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    make_octahedron(mesh, 2);
  else if(!OpenMesh::IO::read_mesh(mesh, argv[1]))
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
