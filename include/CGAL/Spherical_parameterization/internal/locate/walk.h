// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_WALK_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_WALK_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>

#include <array>
#include <cstdint>

namespace CGAL::Spherical_parameterization::internal {

/// The face of a valid map that contains the direction q: a stochastic walk from face f on, which ends with probability
/// 1 whatever the triangles look like (O. Devillers, S. Pion, M. Teillaud, "Walking in a triangulation", 2002). Exact
/// tests decide every step: no direction is lost, however small the faces.
inline int face_at(const Corner_table& table, const Host_array<vec3>& image, vec3 q, int f)
{
  std::uint32_t random = 1;
  for(int from = -1;;) {
    random = 1664525 * random + 1013904223; // D. Knuth, TAOCP 2, 3.3.4; the high bits are good
    const std::array<int, 3>& corner = table.face[f];
    int next = -1;
    for(unsigned i = 0, k = (random >> 16) % 3; i < 3 && next < 0; ++i, k = (k + 1) % 3) {
      const int beyond = table.twin[3 * f + k] / 3;
      if(beyond != from && orientation(image[corner[k]], image[corner[(k + 1) % 3]], q) < 0)
        next = beyond;
    }
    if(next < 0)
      return f;
    from = f;
    f = next;
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_WALK_H
