// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_NEIGHBOURS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_NEIGHBOURS_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>

#include <algorithm>

namespace CGAL::Spherical_parameterization::internal {

/// The neighbours of every vertex of a closed surface in ascending order, without weights.
inline Weighted_graph neighbours(const Host_loop& loop, const Surface& surface)
{
  Weighted_graph graph;
  graph.offset.resize(surface.number_of_vertices + 1);
  graph.offset[surface.number_of_vertices] = 3 * surface.number_of_faces();
  graph.target.resize(3 * surface.face.size());
  for_each_fan(loop, surface.face, surface.number_of_vertices, [&](const Fan& fan) {
    const auto row = graph.target.begin() + fan.first;
    auto end = row;
    for(int c : fan)
      *end++ = surface.face[c / 3][(c + 1) % 3];
    std::sort(row, end);
    graph.offset[fan.vertex] = fan.first;
  });
  return graph;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_NEIGHBOURS_H
