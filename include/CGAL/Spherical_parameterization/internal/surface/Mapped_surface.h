// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MAPPED_SURFACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MAPPED_SURFACE_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/surface/Source_mesh.h>
#include <CGAL/Spherical_parameterization/internal/surface/corner_table_of.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>

#include <boost/property_map/property_map.hpp>

#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// A mesh that Source_mesh has checked, and its image on the sphere, as arrays: faces in the order of the mesh,
/// vertices breadth-first.
struct Mapped_surface : Corner_table {
  Host_array<vec3> point;   ///< in a box of size 1
  Host_array<vec3> image;   ///< as the sphere map has it
  Host_array<double> area;  ///< every vertex's third of the areas of its faces
  Host_array<int> position; ///< of the vertices in vertices(mesh)
  Shared_graph graph;       ///< the neighbours of the vertices, without weights
};

/// Throws Error for what is no closed, connected triangle mesh of genus 0 with finite points. Property maps are read on
/// the calling thread, but for points whose coordinates are plain numbers.
template <class TriangleMesh, class VertexPointMap, class VertexSphereMap>
Mapped_surface read_mapped_surface(const TriangleMesh& mesh, VertexPointMap points, VertexSphereMap sphere_map,
                                   const Host_loop& where_safe)
{
  typedef typename boost::property_traits<VertexPointMap>::value_type Point;
  const Host_loop loop = are_plain_coordinates<Point>() ? where_safe : Host_loop();
  Source_mesh<TriangleMesh> source(mesh, points, loop);
  Mapped_surface result;
  static_cast<Corner_table&>(result) = corner_table_of(mesh, std::move(source.face), loop);
  result.point = std::move(source.point);
  result.area = std::move(source.area);
  result.position = std::move(source.position);
  result.graph = std::move(source.graph);
  result.image.reserve(source.vertex.size());
  for(auto v : source.vertex)
    result.image.push_back(coordinates(get(sphere_map, v)));
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_MAPPED_SURFACE_H
