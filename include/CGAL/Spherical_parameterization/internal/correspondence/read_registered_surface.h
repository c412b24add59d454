// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_READ_REGISTERED_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_READ_REGISTERED_SURFACE_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/algebra/pi.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/refine.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Mapped_faces.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/predicates/certificate.h>
#include <CGAL/Spherical_parameterization/internal/surface/corner_table_of.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// Reads a surface and its map. Throws Error if the map is not valid.
template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
Registered_surface read_registered_surface(const Host_loop& loop, const TriangleMesh& mesh, VertexPointMap points,
                                           VertexSphereMap sphere_map)
{
  Mapped_faces map = read_mapped_faces(mesh, points, sphere_map, loop);
  const int n = static_cast<int>(map.image.size());
  if(map.face.empty())
    throw Input_error(Error_code::EMPTY_MESH, "there is nothing to register");
  Registered_surface surface;
  static_cast<Corner_table&>(surface) = corner_table_of(mesh, map.face, loop);
  check_no_isolated_vertex(map.face, n);
  for(int i = 0; i < n; ++i)
    if(!is_finite(map.point[i]))
      throw Input_error(Error_code::NON_FINITE_COORDINATE, "the point of vertex " + std::to_string(i));
  const Certificate certificate = certify(loop, map.face, map.image);
  if(!certificate.is_valid())
    throw Input_error(Error_code::NOT_BIJECTIVE, counted(certificate.flipped_faces, "flipped face", "flipped faces") +
                                                   ", degree " + std::to_string(certificate.degree) +
                                                   "; register certified maps");
  for(vec3& p : map.image)
    p = unit(p);
  if(!certify(loop, map.face, map.image).is_valid())
    throw Input_error(Error_code::NOT_BIJECTIVE, "rounding flips faces; take unit vectors");

  double area = 0;
  vec3 centre = {0, 0, 0};
  for(const std::array<int, 3>& f : map.face) {
    const double of_face = norm(normal(map.point, f)) / 2;
    area += of_face;
    for(int i : f)
      centre = add_scaled(centre, of_face / 3, map.point[i]);
  }
  if(!(area > 0) || !std::isfinite(area))
    throw Input_error(Error_code::DEGENERATE_FACE, "the area of the surface is " + std::to_string(area));
  const double factor = std::sqrt(4 * internal::pi / area);
  for(const vec3& p : map.point)
    surface.point.push_back(scale(factor, add_scaled(p, -1 / area, centre)));
  surface.image = std::move(map.image);
  return surface;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_READ_REGISTERED_SURFACE_H
