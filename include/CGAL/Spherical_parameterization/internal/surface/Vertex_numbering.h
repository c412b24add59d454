// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_NUMBERING_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_NUMBERING_H

#include <CGAL/Spherical_parameterization/values/Error.h>

#include <boost/functional/hash.hpp>
#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

template <class Descriptor, class = void>
struct Has_idx : std::false_type {};
template <class Descriptor>
struct Has_idx<Descriptor, std::void_t<decltype(static_cast<std::size_t>(std::declval<const Descriptor&>().idx()))>>
  : std::true_type {};

/// The position of every element of a range of descriptors, 0 ... n-1. The mesh's own indices are not relied upon: they
/// may have holes (Surface_mesh with garbage) or never have been set (Polyhedron_3). Descriptors that are an index
/// (Surface_mesh, OpenMesh) look their position up in an array, all others in a hash table.
template <class Descriptor>
class Numbering {
public:
  /// Throws Error if there are more than an int can number.
  template <class Range>
  explicit Numbering(const Range& descriptors)
  {
    if(std::distance(descriptors.begin(), descriptors.end()) > (std::numeric_limits<int>::max)())
      throw Input_error(Error_code::TOO_LARGE, "more than 2^31 - 1 elements of one kind");
    for(Descriptor d : descriptors)
      if constexpr(Has_idx<Descriptor>::value) {
        const std::size_t i = static_cast<std::size_t>(d.idx());
        if(i >= table_.size())
          table_.resize(i + 1, -1);
        table_[i] = size_++;
      } else
        table_.emplace(d, size_++);
  }

  /// -1 for a descriptor that is not of the range, as far as it can be told.
  int checked(Descriptor d) const
  {
    if constexpr(Has_idx<Descriptor>::value) {
      const auto i = static_cast<std::size_t>(d.idx());
      return i < table_.size() ? table_[i] : -1;
    } else {
      const auto entry = table_.find(d);
      return entry == table_.end() ? -1 : entry->second;
    }
  }

  int operator()(Descriptor d) const
  {
    if constexpr(Has_idx<Descriptor>::value)
      return table_[static_cast<std::size_t>(d.idx())];
    else
      return table_.at(d);
  }

  std::size_t size() const { return static_cast<std::size_t>(size_); }

private:
  typedef std::conditional_t<Has_idx<Descriptor>::value, std::vector<int>,
                             std::unordered_map<Descriptor, int, boost::hash<Descriptor>>>
    Table;

  int size_ = 0;
  Table table_;
};

/// Of vertices(mesh)
template <class TriangleMesh>
using Vertex_numbering = Numbering<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>;

/// Whether a mesh has been checked when it was made, and knows a breadth-first order of its vertices: the one in which
/// a walk round each vertex from its halfedge on meets its neighbours.
template <class TriangleMesh, class = void>
struct Has_breadth_first_order : std::false_type {};
template <class TriangleMesh>
struct Has_breadth_first_order<TriangleMesh,
                               std::void_t<decltype(std::declval<const TriangleMesh&>().breadth_first_order())>>
  : std::true_type {};

/// The numbering of all vertices or all faces of a mesh. One that has been checked when it was made numbers them
/// itself.
template <class Descriptor, class TriangleMesh, class Range>
auto numbering_of(const TriangleMesh&, const Range& descriptors)
{
  if constexpr(Has_breadth_first_order<TriangleMesh>::value)
    return [](Descriptor d) { return d.idx(); };
  else
    return Numbering<Descriptor>(descriptors);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_VERTEX_NUMBERING_H
