// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H

#include <CGAL/Spherical_parameterization/Error.h>
#include <CGAL/Spherical_parameterization/internal/base/text.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Source_mesh.h>
#include <CGAL/Spherical_parameterization/internal/mesh/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/mesh/twins.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// What segmentation looks at: a mesh and its sphere as arrays, the mesh scaled to area 1 so that all lengths and areas
/// are dimensionless. Closed triangle meshes of genus 0 only.
struct Segmentation_mesh {
  Host_array<vec3> point;
  Host_array<vec3> sphere; ///< unit vectors
  Host_array<std::array<int, 3>> face;
  std::vector<std::array<int, 3>> across; ///< the faces beyond the sides (corner k, corner k+1)
  std::vector<double> area;               ///< of the faces; they sum up to 1
  Shared_graph graph;                     ///< the neighbours of the vertices

  int number_of_faces() const { return static_cast<int>(face.size()); }
  int number_of_vertices() const { return static_cast<int>(point.size()); }
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

/// Reads mesh and map. Throws Error for what is no closed triangle mesh of genus 0, or has no area, and for
/// images that are not directions. Images need not be normalised.
template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
Segmentation_mesh read_segmentation_mesh(const TriangleMesh& mesh, VertexPointMap points, VertexSphereMap sphere_map)
{
  Source_mesh<TriangleMesh> source(mesh, points);
  Segmentation_mesh result;
  const int n = static_cast<int>(source.vertex.size());
  result.sphere.resize(n);
  for(int i = 0; i < n; ++i) {
    const vec3 image = scaled_to_unit_box(coordinates(get(sphere_map, source.vertex[i])));
    const double length2 = inner(image, image);
    if(!std::isfinite(length2))
      throw Error(Error_code::NON_FINITE_COORDINATE,
                  "the image of vertex " + std::to_string(source.position[i]) + " on the sphere");
    if(!(length2 > 0))
      throw Error(Error_code::NOT_BIJECTIVE, "the image of vertex " + std::to_string(source.position[i]) +
                                               " is the centre of the sphere; compute the map first");
    result.sphere[i] = unit(image);
  }
  result.point = std::move(source.point);
  result.face = std::move(source.face);
  result.graph = source.graph;
  const std::vector<int> twin = twins(mesh);
  result.across.resize(result.face.size());
  for(std::size_t h = 0; h < twin.size(); ++h)
    result.across[h / 3][h % 3] = twin[h] / 3;

  double largest = 0;
  for(const vec3& p : result.point)
    largest = (std::max)({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if(largest > 0) // so that no square over- or underflows
    for(vec3& p : result.point)
      p = scale(1 / largest, p);
  result.area.resize(result.face.size());
  double total = 0;
  for(int f = 0; f < result.number_of_faces(); ++f) {
    const vec3 a = result.area_vector(f);
    total += result.area[f] = std::sqrt(inner(a, a)) / 2;
  }
  if(!(total > 0))
    throw Error(Error_code::DEGENERATE_FACE, "the mesh has no area");
  for(double& a : result.area)
    a /= total;
  for(vec3& p : result.point)
    p = scale(1 / std::sqrt(total), p);
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTATION_MESH_H
