// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/byte_writer.h"
#include "output/volume_geometry.h"
#include "output/write_mesh.h"

#include <cstdint>

namespace tool {

void write_freesurfer(std::ostream& out, const Mesh& mesh, const std::vector<Point>& points, Surface surface,
                      const Annotations& annotations)
{
  out << "\xff\xff\xfe"
         "created by spherical-parameterization\n\n";
  {
    Byte_writer write(out, Byte_order::BIG);
    write(static_cast<std::int32_t>(points.size()));
    write(static_cast<std::int32_t>(mesh.number_of_faces()));
    for(const Point& p : points)
      for(const double x : as_stored(Mesh_format::FREESURFER, surface, p))
        write(static_cast<float>(x));
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      write(mesh.triangle(f));
  }
  out << freesurfer_tags(annotations);
}

} // namespace tool
