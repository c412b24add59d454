// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H

#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/locate/Locator.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// A point of a mesh: a face, and weights (non-negative, sum 1) of its corners source(h), target(h), target(next(h))
/// with h = halfedge(f). The same as `CGAL::Polygon_mesh_processing::Face_location`.
template <class TriangleMesh>
using Face_location = std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>;

/// The inverse of a spherical map (point location on the sphere): finds the point of the mesh that is mapped to a
/// direction.
///
/// A kd-tree of the vertices finds a start. From there a stochastic walk through the triangulation (O. Devillers, S.
/// Pion, M. Teillaud, "Walking in a triangulation", 2002) reaches the face with probability 1, whatever the triangles
/// look like. Exact tests decide every step, so every direction is found, however small the faces are.
///
/// Copies its data, about 100 bytes per vertex. Several threads may call `locate()` at the same time.
template <class TriangleMesh>
class Spherical_locator {
  typedef boost::graph_traits<TriangleMesh> Graph_traits;

public:
  typedef typename Graph_traits::face_descriptor face_descriptor; ///< of the mesh
  /// What `locate()` returns.
  typedef Spherical_parameterization::Face_location<TriangleMesh> Face_location;

  /// \param mesh        a closed triangle mesh, a model of `FaceListGraph` and `HalfedgeListGraph`; must outlive the
  ///                    locator
  /// \param sphere_map  readable, key vertex_descriptor, value unit vectors
  /// \throws Error  for what is no closed, connected triangle mesh of genus 0, and for a map that is not valid: that
  /// has
  ///         flipped faces, or a degree other than 1
  ///
  /// Complexity: O(n log n).
  template <class VertexSphereMap>
  Spherical_locator(const TriangleMesh& mesh, VertexSphereMap sphere_map)
    : Spherical_locator(CGAL::Sequential_tag(), mesh, sphere_map)
  {}

  /// The same on the threads of a policy.
  /// \param policy      `CGAL::Sequential_tag` or `CGAL::Parallel_tag`; the result does not depend on it
  /// \param mesh        as above
  /// \param sphere_map  as above
  template <class ExecutionPolicy, class VertexSphereMap>
  Spherical_locator(const ExecutionPolicy& policy, const TriangleMesh& mesh, VertexSphereMap sphere_map)
    : mesh_(&mesh), face_(faces(mesh).begin(), faces(mesh).end()),
      locator_(internal::host_loop(policy), read(mesh, sphere_map, internal::host_loop(policy)))
  {}

  /// The face whose image contains `direction`, and the weights for which the mean of the images of its corners has
  /// that direction. If the direction is on an edge or at a vertex, one of the faces there is returned.
  /// \param direction any vector that is finite and not zero: with x(), y(), z() or operator[]
  /// \return the face and the weights, exact to 1e-12
  /// \throws Error  `NON_FINITE_COORDINATE` if it is not
  ///
  /// Complexity: O(log n) expected, for triangles that are not all slivers.
  template <class Direction>
  Face_location locate(const Direction& direction) const
  {
    const auto [face, weights] = locator_.locate(internal::coordinates(direction));
    return {face_[static_cast<std::size_t>(face)], weights};
  }

  /// \return the mesh of the map
  const TriangleMesh& mesh() const { return *mesh_; }

private:
  template <class VertexSphereMap>
  static internal::Valid_map read(const TriangleMesh& mesh, VertexSphereMap sphere_map, const internal::Host_loop& loop)
  {
    return {internal::read_map(mesh, sphere_map, internal::Reading::CHECKED, loop), loop};
  }

  const TriangleMesh* mesh_;
  std::vector<face_descriptor> face_; ///< by number
  internal::Locator locator_;
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H
