// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H

#include <CGAL/Spherical_parameterization/internal/inverse/Kd_tree.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Vertex_numbering.h>
#include <CGAL/Spherical_parameterization/internal/inverse/barycentric_coordinates.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

/// A point of a mesh: a face, and weights (non-negative, sum 1) of its corners source(h), target(h), target(next(h))
/// with h = halfedge(f). The same as `CGAL::Polygon_mesh_processing::Face_location`.
template <class TriangleMesh>
using Face_location = std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>;

/// The inverse of a spherical map: finds the point of the mesh that is mapped to a direction.
///
/// A kd-tree of the vertices says where to start, and a stochastic walk through the triangulation goes on from there
/// (O. Devillers, S. Pion, M. Teillaud, "Walking in a triangulation", 2002), which ends with probability 1 whatever the
/// triangles look like. Exact tests decide every step: no direction is lost, however small the faces.
///
/// Copies what it needs, about 100 bytes per vertex; locating may be done by several threads at once.
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
  /// \throws std::invalid_argument if the map is not valid: there are flipped faces, or its degree is not 1; or if the
  ///         mesh is not closed, or has an isolated vertex
  ///
  /// Complexity: O(n log n).
  template <class VertexSphereMap>
  Spherical_locator(const TriangleMesh& mesh, VertexSphereMap sphere_map)
    : Spherical_locator(mesh, valid_points(mesh, sphere_map))
  {}

  /// The face whose image contains `direction`, and the weights for which the mean of the images of its corners has
  /// that direction. On an edge or at a vertex it is one of the faces there.
  /// \param direction any vector that is finite and not zero: with x(), y(), z() or operator[]
  /// \return the face and the weights, exact to 1e-12
  /// \throws std::invalid_argument if it is none
  ///
  /// Complexity: O(log n) expected, for triangles that are not all slivers.
  template <class Direction>
  Face_location locate(const Direction& direction) const
  {
    const internal::vec3 given = internal::coordinates(direction);
    if(!internal::is_finite(given) || (given.x == 0 && given.y == 0 && given.z == 0))
      throw std::invalid_argument("no direction to locate: zero or not finite");
    const int exponent = binary_exponent(given);
    const internal::vec3 q = scaled(given, -exponent);
    // Where one coordinate is 1e300 times smaller than another, scaling takes digits off; the tests do with any length.
    const bool is_same = internal::is_equal(scaled(q, exponent), given);
    const std::size_t f = walk(is_same ? q : given, start(q));
    const Face& face = face_[f];
    return {descriptor_[f], internal::barycentric_coordinates(
                              {point_[face.vertex[0]], point_[face.vertex[1]], point_[face.vertex[2]]}, q)};
  }

  /// \return the mesh whose map this is the inverse of
  const TriangleMesh& mesh() const { return *mesh_; }

private:
  struct Face {
    std::array<int, 3> vertex;
    std::array<int, 3> neighbour; ///< across the edge from vertex k to vertex k+1
  };

  Spherical_locator(const TriangleMesh& mesh, const std::vector<internal::vec3>& unsorted)
    : mesh_(&mesh), tree_(unsorted)
  {
    std::vector<int> rank(unsorted.size());
    point_.reserve(unsorted.size());
    for(int i : tree_.order()) {
      rank[i] = static_cast<int>(point_.size());
      point_.push_back(unsorted[i]);
    }
    const internal::Vertex_numbering<TriangleMesh> number(mesh);
    link_faces(mesh, [&](auto v) { return rank[number(v)]; });
  }

  template <class VertexSphereMap>
  static std::vector<internal::vec3> valid_points(const TriangleMesh& mesh, VertexSphereMap sphere_map)
  {
    if(number_of_flipped_faces(mesh, sphere_map) > 0 || degree_of_map(mesh, sphere_map) != 1)
      throw std::invalid_argument("no inverse: the map is not valid");
    std::vector<internal::vec3> points;
    for(auto v : vertices(mesh))
      points.push_back(internal::coordinates(get(sphere_map, v)));
    return points;
  }

  /// Faces are sorted by their first vertex, so that walks stay in a small part of the memory.
  template <class Rank>
  void link_faces(const TriangleMesh& mesh, const Rank& rank)
  {
    for(auto f : faces(mesh)) {
      const auto h = halfedge(f, mesh);
      face_.push_back({{rank(source(h, mesh)), rank(target(h, mesh)), rank(target(next(h, mesh), mesh))}, {}});
      descriptor_.push_back(f);
    }
    std::vector<int> order(face_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int f, int g) { return face_[f].vertex[0] < face_[g].vertex[0]; });
    std::vector<Face> sorted_faces;
    std::vector<face_descriptor> sorted_descriptors;
    for(int f : order) {
      sorted_faces.push_back(face_[f]);
      sorted_descriptors.push_back(descriptor_[f]);
    }
    face_.swap(sorted_faces);
    descriptor_.swap(sorted_descriptors);

    // the edges out of every vertex, as pairs of the other end and the face to the left, sorted
    std::vector<std::vector<std::pair<int, int>>> edges(point_.size());
    for(std::size_t f = 0; f < face_.size(); ++f)
      for(int k = 0; k < 3; ++k)
        edges[face_[f].vertex[k]].emplace_back(face_[f].vertex[(k + 1) % 3], static_cast<int>(f));
    for(auto& out : edges)
      std::sort(out.begin(), out.end());
    for(Face& face : face_)
      for(int k = 0; k < 3; ++k) {
        const auto& out = edges[face.vertex[(k + 1) % 3]];
        const auto opposite = std::lower_bound(out.begin(), out.end(), std::pair<int, int>(face.vertex[k], 0));
        if(opposite == out.end() || opposite->first != face.vertex[k])
          throw std::invalid_argument("no inverse: the mesh is not closed");
        face.neighbour[k] = opposite->second;
      }
    for(const auto& out : edges) {
      if(out.empty())
        throw std::invalid_argument("no inverse: the mesh has an isolated vertex");
      some_face_.push_back(out.front().second);
    }
  }

  /// Some face near q.
  std::size_t start(internal::vec3 q) const { return some_face_[tree_.near(internal::unit(q), point_)]; }

  /// The power of two of which the length of q is about; 0 for unit vectors.
  static int binary_exponent(internal::vec3 q)
  {
    const double square = internal::inner(q, q);
    if(square > 0.5 && square < 2)
      return 0;
    return 1 + std::ilogb((std::max)({std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
  }

  static internal::vec3 scaled(internal::vec3 q, int exponent)
  {
    return exponent == 0
             ? q
             : internal::vec3{std::ldexp(q.x, exponent), std::ldexp(q.y, exponent), std::ldexp(q.z, exponent)};
  }

  std::size_t walk(internal::vec3 q, std::size_t f) const
  {
    std::uint32_t random = 1;
    for(int from = -1;;) {
      random = 1664525 * random + 1013904223; // D. Knuth, TAOCP 2, 3.3.4; the high bits are good
      const Face& face = face_[f];
      int next = -1;
      for(unsigned i = 0, k = (random >> 16) % 3; i < 3 && next < 0; ++i, k = (k + 1) % 3)
        if(face.neighbour[k] != from &&
           internal::orientation(point_[face.vertex[k]], point_[face.vertex[(k + 1) % 3]], q) < 0)
          next = face.neighbour[k];
      if(next < 0)
        return f;
      from = static_cast<int>(f);
      f = static_cast<std::size_t>(next);
    }
  }

  const TriangleMesh* mesh_;
  internal::Kd_tree tree_;
  std::vector<internal::vec3> point_; ///< in the order of the tree, and so are the numbers of vertices here
  std::vector<int> some_face_;        ///< of every vertex
  std::vector<Face> face_;
  std::vector<face_descriptor> descriptor_;
};

/// @}

} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H
