// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_RESAMPLE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_RESAMPLE_H

#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/surface/midpoint_refinement.h>
#include <CGAL/Spherical_parameterization/transfer_properties.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// The largest level of `make_icosphere()`: 167,772,162 vertices. More halfedges than that exceed 32-bit integers.
constexpr int largest_icosphere_level = 12;

/// Adds an icosphere to `out`: an icosahedron with every triangle cut in four `level` times.
/// \param level       0 for an icosahedron
/// \param out         a model of `MutableFaceGraph`, empty
/// \param sphere_map  writable, key vertex_descriptor of `out`, value constructible from three numbers: unit vectors
/// \pre the level is in 0 ... `largest_icosphere_level`
template <class Graph, class VertexSphereMap>
void make_icosphere(int level, Graph& out, VertexSphereMap sphere_map)
{
  CGAL_SP_PRECONDITION(level >= 0 && level <= largest_icosphere_level, "the level of an icosphere is 0 to 12");
  typedef typename boost::property_traits<VertexSphereMap>::value_type Point;
  const internal::Icosphere icosphere(level);
  typedef typename boost::graph_traits<Graph>::vertex_descriptor vertex_descriptor;
  std::vector<vertex_descriptor> vertex;
  vertex.reserve(icosphere.points.size());
  for(const internal::vec3& p : icosphere.points) {
    vertex.push_back(add_vertex(out));
    put(sphere_map, vertex.back(), internal::stored_point<Point>(p));
  }
  for(const auto& [a, b, c] : icosphere.triangles)
    CGAL::Euler::add_face(std::array<vertex_descriptor, 3>{vertex[a], vertex[b], vertex[c]}, out);
}

/// The same as arrays.
/// \param level      0 for an icosahedron
/// \param points     gets the unit vectors
/// \param triangles  gets the indices of their corners, counterclockwise as seen from outside
/// \pre the level is in 0 ... `largest_icosphere_level`
inline void make_icosphere_soup(int level, std::vector<std::array<double, 3>>& points,
                                std::vector<std::array<int, 3>>& triangles)
{
  CGAL_SP_PRECONDITION(level >= 0 && level <= largest_icosphere_level, "the level of an icosphere is 0 to 12");
  internal::Icosphere icosphere(level);
  points.clear();
  points.reserve(icosphere.points.size());
  for(const internal::vec3& p : icosphere.points)
    points.push_back(internal::array_of(p));
  triangles = std::move(icosphere.triangles);
}

/// Remeshing by an icosphere: adds an icosphere to `out`, and gives every vertex of it the point of the shape that is
/// mapped to its direction. Shapes that are sampled at the same level have the same vertices and faces, as morphing and
/// statistics of shapes need.
///
/// The samples are uniform on the sphere, not on the shape: a limb that is tiny on the sphere gets few samples or none.
/// Barycentric weights or larger spring exponents keep limbs wider.
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param shape       the inverse of the map of the shape
/// \param points      readable, key vertex_descriptor of the shape; see `interpolate()`
/// \param level       of the icosphere
/// \param out         a model of `MutableFaceGraph`, empty
/// \param out_points  writable, key vertex_descriptor of `out`
/// \param out_sphere  readable and writable, likewise: the directions
/// \pre the level is in 0 ... `largest_icosphere_level`
///
/// Complexity: 10 * 4^level + 2 queries.
template <class ExecutionPolicy, class TriangleMesh, class VertexPointMap, class Graph, class OutPointMap,
          class OutSphereMap, internal::If_policy<ExecutionPolicy> = 0>
void resample(const ExecutionPolicy& policy, const Spherical_locator<TriangleMesh>& shape, VertexPointMap points,
              int level, Graph& out, OutPointMap out_points, OutSphereMap out_sphere)
{
  make_icosphere(level, out, out_sphere);
  transfer_vertex_property(policy, shape, points, out, out_sphere, out_points);
}
CGAL_SP_ON_ONE_CORE(resample)

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_RESAMPLE_H
