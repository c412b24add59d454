// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/distortion/Mapped_faces.h>
#include <CGAL/Spherical_parameterization/internal/locate/Kd_tree.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>
#include <CGAL/Spherical_parameterization/internal/surface/corner_table_of.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization {

/// \addtogroup PkgSphericalParameterizationInverse
/// @{

namespace internal {

/// Weights (non-negative, sum 1) for which the weighted mean of the corners v has the direction q, each exact to 1e-12.
/// \pre q is in the cone of v, which is positively oriented
inline std::array<double, 3> barycentric_coordinates(const std::array<vec3, 3>& v, vec3 q)
{
  for(int k = 0; k < 3; ++k)
    if(is_equal(q, v[k]))
      return {k == 0 ? 1. : 0., k == 1 ? 1. : 0., k == 2 ? 1. : 0.};
  std::array<double, 3> w;
  double sum = 0, error = 0;
  for(int k = 0; k < 3; ++k) {
    const Determinant determinant(v[(k + 1) % 3], v[(k + 2) % 3], q);
    w[k] = (std::max)(determinant.value, 0.);
    sum += w[k];
    error += determinant.error;
  }
  if(error > 1e-13 * sum) { // slivers
    w = exact_barycentric_coordinates(v, q);
    sum = w[0] + w[1] + w[2];
  }
  return {w[0] / sum, w[1] / sum, w[2] / sum};
}

} // namespace internal

/// A point of a mesh: a face, and weights (non-negative, sum 1) of its corners source(h), target(h), target(next(h))
/// with h = halfedge(f). The same as `CGAL::Polygon_mesh_processing::Face_location`.
template <class TriangleMesh>
using Face_location = std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>;

/// The inverse of a spherical map (point location on the sphere): finds the point of the mesh that is mapped to a
/// direction.
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
  /// \throws Error  if the map is not valid: there are flipped faces, or its degree is not 1; or if the mesh is not
  ///         closed, has a face that is no triangle, or an isolated vertex
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
    : Spherical_locator(mesh, internal::host_loop(policy),
                        internal::read_images(mesh, sphere_map, internal::host_loop(policy)), 0)
  {}

  /// The face whose image contains `direction`, and the weights for which the mean of the images of its corners has
  /// that direction. On an edge or at a vertex it is one of the faces there.
  /// \param direction any vector that is finite and not zero: with x(), y(), z() or operator[]
  /// \return the face and the weights, exact to 1e-12
  /// \throws Error  `NON_FINITE_COORDINATE` if it is none
  ///
  /// Complexity: O(log n) expected, for triangles that are not all slivers.
  template <class Direction>
  Face_location locate(const Direction& direction) const
  {
    const internal::vec3 given = internal::coordinates(direction);
    if(!internal::is_finite(given) || (given.x == 0 && given.y == 0 && given.z == 0))
      throw internal::Input_error(Error_code::NON_FINITE_COORDINATE, "no direction to locate: zero or not finite");
    const int exponent = binary_exponent(given);
    const internal::vec3 q = scaled(given, -exponent);
    // Where one coordinate is 1e300 times smaller than another, scaling takes digits off; the tests do with any length.
    const bool is_same = internal::is_equal(scaled(q, exponent), given);
    const int f = walk(is_same ? q : given, some_face_[tree_.near(internal::unit(q), point_)]);
    const auto [a, b, c] = table_.face[f];
    return {descriptor_[f], internal::barycentric_coordinates({point_[a], point_[b], point_[c]}, q)};
  }

  /// \return the mesh whose map this is the inverse of
  const TriangleMesh& mesh() const { return *mesh_; }

private:
  template <class Loop>
  Spherical_locator(const TriangleMesh& mesh, const Loop& loop, internal::Mapped_faces map, int)
    : mesh_(&mesh), tree_(loop, checked(loop, map))
  {
    internal::Host_array<int> rank(map.image.size());
    point_.reserve(map.image.size());
    for(int i : tree_.order()) {
      rank[i] = static_cast<int>(point_.size());
      point_.push_back(map.image[i]);
    }
    for(std::array<int, 3>& corner : map.face)
      for(int& v : corner)
        v = rank[v];
    sort_faces(mesh, internal::corner_table_of(mesh, std::move(map.face), loop));
    choose_some_faces();
  }

  /// The images of a valid map.
  template <class Loop>
  static const internal::Host_array<internal::vec3>& checked(const Loop& loop, const internal::Mapped_faces& map)
  {
    using internal::Input_error;
    if(const std::size_t flipped = internal::number_of_flipped_faces(loop, map); flipped > 0)
      throw Input_error(Error_code::NOT_BIJECTIVE, internal::counted(flipped, "flipped face", "flipped faces"));
    if(const int degree = internal::degree_of_map(loop, map); degree != 1)
      throw Input_error(Error_code::NOT_BIJECTIVE, "its degree is " + std::to_string(degree));
    internal::check_no_isolated_vertex(map.face, static_cast<int>(map.image.size()));
    return map.image;
  }

  /// Faces are sorted by their first vertex, so that walks stay in a small part of the memory.
  void sort_faces(const TriangleMesh& mesh, const internal::Corner_table& unsorted)
  {
    const std::vector<face_descriptor> descriptor(faces(mesh).begin(), faces(mesh).end());
    std::vector<int> order(unsorted.face.size()), place(order.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int f, int g) { return unsorted.face[f][0] < unsorted.face[g][0]; });
    for(std::size_t i = 0; i < order.size(); ++i)
      place[order[i]] = static_cast<int>(i);
    for(int f : order) {
      table_.face.push_back(unsorted.face[f]);
      descriptor_.push_back(descriptor[f]);
      for(int h = 3 * f; h < 3 * f + 3; ++h)
        table_.twin.push_back(3 * place[unsorted.twin[h] / 3] + unsorted.twin[h] % 3);
    }
  }

  /// Of every vertex that face in which its smallest neighbour follows on it.
  void choose_some_faces()
  {
    some_face_.resize(point_.size());
    std::vector<int> smallest(point_.size(), (std::numeric_limits<int>::max)());
    for(int h = 0; h < table_.number_of_halfedges(); ++h)
      if(table_.target(h) < smallest[table_.origin(h)]) {
        smallest[table_.origin(h)] = table_.target(h);
        some_face_[table_.origin(h)] = h / 3;
      }
  }

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
    return {std::ldexp(q.x, exponent), std::ldexp(q.y, exponent), std::ldexp(q.z, exponent)};
  }

  int walk(internal::vec3 q, int f) const
  {
    std::uint32_t random = 1;
    for(int from = -1;;) {
      random = 1664525 * random + 1013904223; // D. Knuth, TAOCP 2, 3.3.4; the high bits are good
      const std::array<int, 3>& corner = table_.face[f];
      int next = -1;
      for(unsigned i = 0, k = (random >> 16) % 3; i < 3 && next < 0; ++i, k = (k + 1) % 3) {
        const int beyond = table_.twin[3 * f + k] / 3;
        if(beyond != from && internal::orientation(point_[corner[k]], point_[corner[(k + 1) % 3]], q) < 0)
          next = beyond;
      }
      if(next < 0)
        return f;
      from = f;
      f = next;
    }
  }

  const TriangleMesh* mesh_;
  internal::Kd_tree tree_;
  internal::Host_array<internal::vec3> point_; ///< in the order of the tree, and so are the numbers of vertices here
  std::vector<int> some_face_;                 ///< of every vertex
  internal::Corner_table table_;
  std::vector<face_descriptor> descriptor_;
};

/// @}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_LOCATE_H
