// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_TWINS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_TWINS_H

#include <CGAL/Spherical_parameterization/internal/mesh/Vertex_numbering.h>

#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// The opposite of every halfedge 3f + k, which leaves corner k of face f, as in Source_mesh. The mesh is closed.
template <class TriangleMesh>
std::vector<int> twins(const TriangleMesh& mesh)
{
  const Face_numbering<TriangleMesh> numbering(mesh);
  std::vector<int> result;
  result.reserve(3 * numbering.size());
  for(auto f : faces(mesh)) {
    auto h = halfedge(f, mesh);
    for(int k = 0; k < 3; ++k, h = next(h, mesh)) {
      const auto other = opposite(h, mesh);
      const auto first = halfedge(face(other, mesh), mesh);
      const int corner = other == first ? 0 : other == next(first, mesh) ? 1 : 2;
      result.push_back(3 * numbering(face(other, mesh)) + corner);
    }
  }
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_TWINS_H
