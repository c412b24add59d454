// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_TEXTURE_COORDINATES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_TEXTURE_COORDINATES_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/context/make_monitor.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/texture/texture_layout.h>
#include <CGAL/Spherical_parameterization/values/texture_options.h>

#include <CGAL/boost/graph/helpers.h>
#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <type_traits>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationTexture
/// @{

/// Texture coordinates (uv coordinates, texture mapping) for every corner of a valid map. `texture_seams()` finds the
/// edges along which they are cut.
///
/// Guarantee: every face has a counter-clockwise uv triangle that is not degenerate, by an exact predicate on the
/// stored coordinates, also in limbs that are smaller on the sphere than the resolution of the coordinates. This may
/// open seams between neighbouring faces: in limbs narrower than a cell of the grid, and along faces so long and thin
/// that the chart bends them by more than their width (`Texture_report` says how many, and how wide). u and v are in
/// [0, 1], for faces across the seam in [-1, 2].
///
/// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
/// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`
/// \param sphere_map  readable, key vertex_descriptor, value unit vectors; a valid map
/// \param uv_map      writable, key halfedge_descriptor, value constructible from two doubles: the corner of face(h) at
///                    target(h)
/// \param options     the chart, its axes on the sphere, and the grid of the coordinates, which has no more bits than
///                    the coordinates of `uv_map` hold, 23 for floats
/// \param np          optional named parameters: `vertex_point_map`, for the choice of the poles; `callback` and
///                    `maximum_running_time`, as in `parameterize()`
/// \return the report
/// \throws Error  for what is no closed, connected triangle mesh of genus 0, and for a map that is not valid: that has
///         flipped faces, or a degree other than 1; for points that are not finite, if they choose the poles;
///         `INTERRUPTED`; before anything is written
/// \pre the axes are finite and not parallel, and there are 1 to 52 bits
///
/// Complexity: O(n log n); the logarithm is for the choice of the poles.
template <class ExecutionPolicy, class TriangleMesh, class VertexSphereMap, class HalfedgeUVMap,
          class CGAL_NP_TEMPLATE_PARAMETERS, internal::If_policy<ExecutionPolicy> = 0>
Texture_report texture_coordinates(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map,
                                   HalfedgeUVMap uv_map, const Texture_options& options = Texture_options(),
                                   const CGAL_NP_CLASS& np = parameters::default_values())
{
  typedef typename boost::property_traits<HalfedgeUVMap>::value_type UV;
  CGAL_SP_PRECONDITION(options.bits >= 1 && options.bits <= 52, "texture coordinates have 1 to 52 bits");
  const auto loop = internal::host_loop(policy);
  internal::Monitor monitor = internal::make_monitor(np);
  constexpr auto checked = internal::Reading::CHECKED;
  const internal::Valid_map map(
    options.axes ? internal::read_map(mesh, sphere_map, checked, loop)
                 : internal::read_map(mesh, internal::vertex_points(mesh, np), sphere_map, checked, loop),
    loop);
  const internal::Watched_loop watched(loop, monitor);
  watched.advance(0);
  const auto stored = [](const internal::vec2& uv) {
    if constexpr(std::is_constructible_v<UV, double, double>)
      return UV(uv.x, uv.y);
    else // std::array
      return UV{static_cast<typename UV::value_type>(uv.x), static_cast<typename UV::value_type>(uv.y)};
  };
  Texture_options on_grid = options;
  if constexpr(std::is_invocable_v<std::equal_to<>, UV, UV>)
    while(on_grid.bits > 1 && stored({1 + std::ldexp(1., -on_grid.bits), 0}) == stored({1, 0}))
      --on_grid.bits;
  const internal::Texture_layout layout = internal::texture_layout(watched, map, on_grid);
  std::size_t i = 0;
  for(auto f : faces(mesh)) {
    const std::array<internal::vec2, 3>& uv = layout.uv[i++];
    auto h = halfedge(f, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh))
      put(uv_map, h, stored(uv[(k + 1) % 3])); // corner 0 is the source of the first halfedge
  }
  return layout.report;
}
CGAL_SP_ON_ONE_CORE(texture_coordinates)

/// The seams of a texture: the edges whose two faces have different coordinates at an end point. `CGAL::Seam_mesh`
/// takes both maps; on this cut mesh every vertex has one pair of texture coordinates.
/// \param mesh            a triangle mesh, a model of `FaceListGraph`, `HalfedgeListGraph` and `EdgeListGraph`
/// \param uv_map          readable, key halfedge_descriptor, value with `==`, written by `texture_coordinates()`
/// \param edge_is_seam    writable, key edge_descriptor, value `bool`: whether the edge is a seam; `false` on the
/// boundary
/// \param vertex_on_seam  writable, key vertex_descriptor, value `bool`: whether the vertex is the end of a
/// seam
/// \return the number of seam edges, for `CGAL::Seam_mesh::set_seam_edges_number()`
///
/// Complexity: linear.
template <class TriangleMesh, class HalfedgeUVMap, class EdgeSeamMap, class VertexSeamMap>
std::size_t texture_seams(const TriangleMesh& mesh, HalfedgeUVMap uv_map, EdgeSeamMap edge_is_seam,
                          VertexSeamMap vertex_on_seam)
{
  for(auto v : vertices(mesh))
    put(vertex_on_seam, v, false);
  std::size_t number_of_seams = 0;
  for(auto e : edges(mesh)) {
    const auto h = halfedge(e, mesh), o = opposite(h, mesh);
    const bool is_seam = !is_border(e, mesh) && !(get(uv_map, h) == get(uv_map, prev(o, mesh)) &&
                                                  get(uv_map, o) == get(uv_map, prev(h, mesh)));
    put(edge_is_seam, e, is_seam);
    if(is_seam) {
      ++number_of_seams;
      put(vertex_on_seam, source(h, mesh), true);
      put(vertex_on_seam, target(h, mesh), true);
    }
  }
  return number_of_seams;
}

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_TEXTURE_COORDINATES_H
