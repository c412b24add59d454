// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H

#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/mesh/point_coordinates.h>

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// What segmentation looks at: a mesh and its sphere as arrays, the mesh scaled to area 1 so that all lengths and areas
/// are dimensionless. Closed triangle meshes of genus 0 only.
struct Segmentation_mesh : Corner_table {
  Host_array<vec3> point;
  Host_array<vec3> sphere;  ///< unit vectors
  std::vector<double> area; ///< of the faces; they sum up to 1
  Shared_graph graph;       ///< the neighbours of the vertices

  int number_of_faces() const { return static_cast<int>(face.size()); }
  int number_of_vertices() const { return static_cast<int>(point.size()); }
  /// the face beyond the side (corner k, corner k+1)
  int across(int f, int k) const { return twin[3 * f + k] / 3; }
  vec3 side(int f, int k) const { return sub(point[face[f][(k + 1) % 3]], point[face[f][k]]); }
  double side_length(int f, int k) const
  {
    const vec3 e = side(f, k);
    return std::sqrt(inner(e, e));
  }
  vec3 centroid(int f) const
  {
    return scale(1. / 3, add(add(point[face[f][0]], point[face[f][1]]), point[face[f][2]]));
  }
  /// Twice the area, along the normal.
  vec3 area_vector(int f) const { return outer(side(f, 0), sub(point[face[f][2]], point[face[f][0]])); }
};

/// Throws Error for a mesh without area, and for images that are not directions. Images need not be normalized.
inline Segmentation_mesh make_segmentation_mesh(Mapped_surface source)
{
  Segmentation_mesh result;
  result.sphere.resize(source.image.size());
  for(std::size_t i = 0; i < source.image.size(); ++i) {
    const vec3 image = scaled_to_unit_box(source.image[i]);
    const double length2 = inner(image, image);
    if(!std::isfinite(length2))
      throw Input_error(Error_code::NON_FINITE_COORDINATE,
                        "the image of vertex " + std::to_string(source.position[i]) + " on the sphere");
    if(!(length2 > 0))
      throw Input_error(Error_code::NOT_BIJECTIVE, "the image of vertex " + std::to_string(source.position[i]) +
                                                     " is the centre of the sphere; compute the map first");
    result.sphere[i] = unit(image);
  }
  result.point = std::move(source.point);
  result.face = std::move(source.face);
  result.twin = std::move(source.twin);
  result.graph = std::move(source.graph);
  result.area.resize(result.face.size());
  double total = 0;
  for(int f = 0; f < result.number_of_faces(); ++f) {
    const vec3 a = result.area_vector(f);
    total += result.area[f] = std::sqrt(inner(a, a)) / 2;
  }
  if(!(total > 0))
    throw Input_error(Error_code::DEGENERATE_FACE, "the mesh has no area");
  for(double& a : result.area)
    a /= total;
  for(vec3& p : result.point)
    p = scale(1 / std::sqrt(total), p);
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H
