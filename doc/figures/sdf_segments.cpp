// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.
//
// What CGAL's SDF values make of MESH, with CGAL's defaults, in the colours of the tool's command `segment`: for the
// figure of the manual that shows both.
//
//   sdf_segments MESH COLOURED.ply

#include "../../src/segments_ply.h"

#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/mesh_segmentation.h>

#include <fstream>
#include <iostream>

int main(int argc, char* argv[])
{
  tool::Mesh mesh;
  if(argc != 3 || !CGAL::IO::read_polygon_mesh(argv[1], mesh))
    return std::cerr << "usage: sdf_segments MESH COLOURED.ply\n", 2;
  const auto values = mesh.add_property_map<tool::Mesh::Face_index, double>("f:sdf").first;
  const auto segments = mesh.add_property_map<tool::Mesh::Face_index, std::size_t>("f:segment").first;
  CGAL::sdf_values(mesh, values);
  const std::size_t count = CGAL::segmentation_from_sdf_values(mesh, values, segments);
  std::ofstream out(argv[2]);
  tool::write_segments_ply(out, mesh, segments, count);
  std::cout << argv[1] << ": " << count << " segments\n";
  return out ? 0 : 1;
}
