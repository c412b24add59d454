// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_NUMBERING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_NUMBERING_H

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

template <class Descriptor, class = void>
struct Has_idx : std::false_type {};
template <class Descriptor>
struct Has_idx<Descriptor, std::void_t<decltype(static_cast<std::size_t>(std::declval<const Descriptor&>().idx()))>>
  : std::true_type {};

/// The position of every vertex in vertices(mesh), 0 ... n-1. The mesh's own indices are not relied upon: they may have
/// holes (Surface_mesh with garbage) or never have been set (Polyhedron_3). Descriptors that are an index
/// (Surface_mesh, OpenMesh) look their position up in an array, all others in a hash table.
template <class TriangleMesh>
class Vertex_numbering {
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

public:
  explicit Vertex_numbering(const TriangleMesh& mesh)
  {
    for(vertex_descriptor v : vertices(mesh))
      insert(v, size_++);
  }

  int operator()(vertex_descriptor v) const
  {
    if constexpr(Has_idx<vertex_descriptor>::value)
      return table_[static_cast<std::size_t>(v.idx())];
    else
      return table_.at(v);
  }

  std::size_t size() const { return static_cast<std::size_t>(size_); }

private:
  typedef std::conditional_t<Has_idx<vertex_descriptor>::value, std::vector<int>,
                             std::unordered_map<vertex_descriptor, int, boost::hash<vertex_descriptor>>>
    Table;

  void insert(vertex_descriptor v, int position)
  {
    if constexpr(Has_idx<vertex_descriptor>::value) {
      const std::size_t i = static_cast<std::size_t>(v.idx());
      if(i >= table_.size())
        table_.resize(i + 1, -1);
      table_[i] = position;
    } else
      table_.emplace(v, position);
  }

  int size_ = 0;
  Table table_;
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERTEX_NUMBERING_H
