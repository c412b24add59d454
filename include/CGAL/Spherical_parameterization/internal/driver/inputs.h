// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_INPUTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_INPUTS_H

#include <CGAL/Spherical_parameterization/Indexed_triangle_mesh.h>
#include <CGAL/Spherical_parameterization/edge_weights.h>
#include <CGAL/Spherical_parameterization/internal/base/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/base/precondition.h>

#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// What the caller of parameterize() gives besides the mesh.
template <class TriangleMesh, class NamedParameters>
struct Mesh_inputs {
  const TriangleMesh& mesh;
  const NamedParameters& np;

  auto points() const { return vertex_points(mesh, np); }

  auto weights() const
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, edge_weight_tag>::value)
      return conformal_weights(mesh, 5, 85, np);
    else
      return parameters::get_parameter(np, edge_weight_tag());
  }

  auto constraints() const
  {
    typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor Vertex;
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_is_constrained),
                                        Static_boolean_property_map<Vertex, false>());
  }
};

/// A map whose keys are numbers of points, or pairs of them, as a map of the vertices or edges of a mesh.
template <class Map, class Descriptor>
struct Map_of_numbers {
  typedef Descriptor key_type;
  typedef typename boost::property_traits<Map>::value_type value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;

  const Indexed_triangle_mesh* mesh;
  Map map;

  friend value_type get(const Map_of_numbers& m, Descriptor d)
  {
    using boost::get; // of pointers
    if constexpr(std::is_same_v<Descriptor, Indexed_triangle_mesh::Edge_index>) {
      const std::pair<int, int> ends = std::minmax(source(d, *m.mesh).idx(), target(d, *m.mesh).idx());
      return get(m.map, std::pair<std::size_t, std::size_t>(ends.first, ends.second));
    } else
      return get(m.map, static_cast<std::size_t>(d.idx()));
  }
};

/// What the caller of parameterize_triangle_soup() gives besides the soup.
template <class NamedParameters>
struct Soup_inputs {
  const Indexed_triangle_mesh& mesh;
  const NamedParameters& np;

  auto points() const { return get(CGAL::vertex_point, mesh); }

  auto weights() const
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, edge_weight_tag>::value)
      return conformal_weights(mesh);
    else
      return of_numbers<Indexed_triangle_mesh::Edge_index>(parameters::get_parameter(np, edge_weight_tag()));
  }

  auto constraints() const
  {
    typedef Indexed_triangle_mesh::Vertex_index Vertex;
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value)
      return Static_boolean_property_map<Vertex, false>();
    else
      return of_numbers<Vertex>(parameters::get_parameter(np, internal_np::vertex_is_constrained));
  }

private:
  template <class Descriptor, class Map>
  Map_of_numbers<Map, Descriptor> of_numbers(Map map) const
  {
    return {&mesh, map};
  }
};

/// A random access range as a map from the vertices of an indexed mesh.
template <class Range>
struct Range_map {
  typedef Indexed_triangle_mesh::Vertex_index key_type;
  typedef std::decay_t<decltype(std::declval<Range&>()[0])> value_type;
  typedef const value_type& reference;
  typedef boost::read_write_property_map_tag category;

  Range* range;

  friend reference get(const Range_map& map, key_type v) { return (*map.range)[v.idx()]; }
  friend void put(const Range_map& map, key_type v, const value_type& p) { (*map.range)[v.idx()] = p; }
};

template <class Range, class = void>
struct Has_resize : std::false_type {};
template <class Range>
struct Has_resize<Range, std::void_t<decltype(std::declval<Range&>().resize(std::size_t()))>> : std::true_type {};

/// Makes room for n points.
template <class Range>
void make_room(Range& range, std::size_t n)
{
  if(static_cast<std::size_t>(std::distance(std::begin(range), std::end(range))) == n)
    return;
  if constexpr(Has_resize<Range>::value)
    range.resize(n);
  else
    CGAL_SP_PRECONDITION(false, "the sphere points have to be as many as the points, or be resizable");
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_INPUTS_H
