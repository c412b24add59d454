// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// Texture coordinates for the corners of MESH, or else of an icosphere, by latitude and longitude. Writes TEXTURED.obj,
// if given.
//
//   texture [MESH [TEXTURED.obj]]

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/spherical_parameterization.h>

#include <fstream>
#include <iostream>

namespace SP = CGAL::Spherical_parameterization;
typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

int main(int argc, char* argv[])
{
  Mesh mesh;
  if(argc == 1)
    SP::make_icosphere(4, mesh, mesh.points());
  else if(!CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return std::cerr << argv[1] << ": cannot be read as a polygon mesh\n", 1;
  auto sphere = mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("v:sphere").first;
  const auto result = SP::parameterize(mesh, sphere);
  if(!result)
    return std::cerr << result << '\n', 1;

  auto uv = mesh.add_property_map<Mesh::Halfedge_index, Kernel::Point_2>("h:uv").first;
  SP::Texture_options options;
  options.bits = 23; // coordinates that are floats: what is true here is true in a viewer
  const SP::Texture_report report = SP::texture_coordinates(mesh, sphere, uv, options);
  std::cout << report.seam_faces << " faces across the seam, " << report.pole_faces << " at the poles, "
            << report.moved_faces << " with a corner of their own\n";
  if(argc < 3)
    return 0;

  std::ofstream out(argv[2]);
  out.precision(17);
  for(Mesh::Vertex_index v : vertices(mesh))
    out << "v " << mesh.point(v) << '\n';
  for(Mesh::Face_index f : faces(mesh)) // one vt per corner, written where it is used: -3, -2, -1 are the last three
  {
    for(Mesh::Halfedge_index h : halfedges_around_face(halfedge(f, mesh), mesh))
      out << "vt " << uv[h] << '\n';
    out << 'f';
    int k = -3;
    for(Mesh::Halfedge_index h : halfedges_around_face(halfedge(f, mesh), mesh))
      out << ' ' << target(h, mesh).idx() + 1 << '/' << k++;
    out << '\n';
  }
  return out ? 0 : 1;
}
