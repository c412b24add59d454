// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_VERTEX_MEANS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_VERTEX_MEANS_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/fans.h>

namespace CGAL::Spherical_parameterization::internal {

/// For every vertex the mean of the values of its faces.
template <class Values>
Host_array<double> means_over_faces(const Host_loop& loop, const Surface& surface, const Values& value)
{
  Host_array<double> mean(surface.number_of_vertices);
  for_each_fan(loop, surface.face, surface.number_of_vertices, [&](const Fan& fan) {
    double sum = 0;
    for(int c : fan)
      sum += value[c / 3];
    mean[fan.vertex] = sum / fan.size();
  });
  return mean;
}

/// The logarithmic area stretch of the vertices.
CGAL_SP_INLINE Host_array<double> vertex_stretch(const Host_loop& loop, const Mapped_surface& map)
{
  return means_over_faces(loop, map, Face_measures(map, loop).values(loop, &Face_measures::log_area_stretch));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_VERTEX_MEANS_H
