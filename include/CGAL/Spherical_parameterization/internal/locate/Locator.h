// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_LOCATOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_LOCATOR_H

#include <CGAL/Spherical_parameterization/internal/locate/Kd_tree.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/internal/surface/breadth_first.h>
#include <CGAL/Spherical_parameterization/values/Error.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The face of a valid map that contains the direction q: a stochastic walk from face f on, which ends with probability
/// 1 whatever the triangles look like (O. Devillers, S. Pion, M. Teillaud, "Walking in a triangulation", 2002). Exact
/// tests decide every step: no direction is lost, however small the faces.
inline int face_at(const Corner_table& table, const Host_array<vec3>& image, vec3 q, int f)
{
  std::uint32_t random = 1;
  for(int from = -1;;) {
    random = 1664525 * random + 1013904223; // D. Knuth, TAOCP 2, 3.3.4; the high bits are good
    const std::array<int, 3>& corner = table.face[f];
    int next = -1;
    for(unsigned i = 0, k = (random >> 16) % 3; i < 3 && next < 0; ++i, k = (k + 1) % 3) {
      const int beyond = table.twin[3 * f + k] / 3;
      if(beyond != from && orientation(image[corner[k]], image[corner[(k + 1) % 3]], q) < 0)
        next = beyond;
    }
    if(next < 0)
      return f;
    from = f;
    f = next;
  }
}

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

/// The inverse of a map: a kd-tree of the vertices says where to start, and a walk goes on from there.
class Locator {
public:
  Locator(const Host_loop& loop, Valid_map map) : tree_(loop, map.image)
  {
    const auto n = static_cast<int>(map.image.size());
    Host_array<int> rank(n);
    point_.resize(n);
    for_each_index(loop, n, [&](int i) {
      const int of_tree = tree_.order()[i];
      rank[of_tree] = i;
      point_[i] = map.image[of_tree];
    });
    Corner_table table = map.copy_of_corner_table(loop);
    for_each_index(loop, static_cast<int>(table.face.size()), [&](int f) {
      for(int& v : table.face[f])
        v = rank[v];
    });
    sort_faces(loop, table);
    choose_some_faces();
  }

  /// A face by its number in the mesh, and the weights of its corners.
  typedef std::pair<int, std::array<double, 3>> Place;

  /// Throws Error for what is no direction.
  Place locate(vec3 direction) const
  {
    if(!is_finite(direction) || (direction.x == 0 && direction.y == 0 && direction.z == 0))
      throw Input_error(Error_code::NON_FINITE_COORDINATE, "no direction to locate: zero or not finite");
    const int exponent = binary_exponent(direction);
    const vec3 q = scaled(direction, -exponent);
    // Where one coordinate is 1e300 times smaller than another, scaling takes digits off; the tests do with any length.
    const bool is_same = is_equal(scaled(q, exponent), direction);
    const int f = face_at(table_, point_, is_same ? q : direction, some_face_[tree_.near(unit(q), point_)]);
    const auto [a, b, c] = table_.face[f];
    return {number_of_face_[f], barycentric_coordinates({point_[a], point_[b], point_[c]}, q)};
  }

private:
  /// Faces are sorted by their first vertex, so that walks stay in a small part of the memory.
  void sort_faces(const Host_loop& loop, const Corner_table& unsorted)
  {
    const auto m = static_cast<int>(unsorted.face.size());
    std::vector<int> begin; // of no use
    number_of_face_ =
      sorted_by_key(m, static_cast<int>(point_.size()), begin, [&](int f) { return unsorted.face[f][0]; });
    const Host_array<int> place = inverse_permutation(loop, number_of_face_);
    table_.face.resize(m);
    table_.twin.resize(unsorted.twin.size());
    for_each_index(loop, m, [&](int f) {
      table_.face[place[f]] = unsorted.face[f];
      for(int k = 0; k < 3; ++k)
        table_.twin[3 * place[f] + k] = 3 * place[unsorted.twin[3 * f + k] / 3] + unsorted.twin[3 * f + k] % 3;
    });
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
  static int binary_exponent(vec3 q)
  {
    const double square = inner(q, q);
    if(square > 0.5 && square < 2)
      return 0;
    return 1 + std::ilogb((std::max)({std::abs(q.x), std::abs(q.y), std::abs(q.z)}));
  }

  static vec3 scaled(vec3 q, int exponent)
  {
    return {std::ldexp(q.x, exponent), std::ldexp(q.y, exponent), std::ldexp(q.z, exponent)};
  }

  Kd_tree tree_;
  Host_array<vec3> point_;     ///< in the order of the tree, and so are the numbers of vertices here
  std::vector<int> some_face_; ///< of every vertex
  Corner_table table_;
  Host_array<int> number_of_face_; ///< in the mesh
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOCATE_LOCATOR_H
