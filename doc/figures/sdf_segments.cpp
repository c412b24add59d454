// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// What CGAL's SDF values make of MESH, with CGAL's defaults, in the colours of the tool's command `segment`: for the
// figure of the manual that shows both.
//
//   sdf_segments MESH COLOURED.ply

#include "input/mesh.h"
#include "output/write_mesh.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <cstddef>
#include <fstream>
#include <iostream>
#include <vector>

int main(int argc, char* argv[])
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Surface_mesh;
  Surface_mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return std::cerr << "usage: sdf_segments MESH COLOURED.ply\n", 2;
  const auto values = mesh.add_property_map<Surface_mesh::Face_index, double>("f:sdf").first;
  const auto segments = mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:segment").first;
  CGAL::sdf_values(mesh, values);
  const std::size_t count = CGAL::segmentation_from_sdf_values(mesh, values, segments);
  std::vector<std::size_t> of_faces;
  for(const auto f : mesh.faces())
    of_faces.push_back(segments[f]);
  std::ofstream out(argv[2], std::ios::binary);
  tool::write_segments_ply(out, false, tool::read_mesh(argv[1]).mesh, of_faces, count);
  std::cout << argv[1] << ": " << count << " segments\n";
  return out ? 0 : 1;
}
