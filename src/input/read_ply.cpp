// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/mesh_readers.h"
#include "input/ply_structure.h"
#include "system/refusal.h"

#include <CGAL/IO/PLY.h>

#include <fstream>

namespace tool {

Polygon_soup read_ply(const std::string& file)
{
  const Ply_counts counts = check_ply_structure(file);
  Polygon_soup soup;
  soup.points.reserve(counts.vertices);
  soup.polygons.reserve(counts.faces);
  std::ifstream in(file, std::ios::binary);
  const bool complete = CGAL::IO::read_PLY(in, soup.points, soup.polygons, CGAL::parameters::verbose(false));
  if(!complete || soup.points.size() != counts.vertices || soup.polygons.size() != counts.faces)
    throw Refusal(unreadable_file, file, "cannot be read by CGAL's PLY reader", "export it again");
  return soup;
}

} // namespace tool
