// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_ARGUMENTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_ARGUMENTS_H

#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/values/Conformal_weights.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/property_map.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace CGAL::Spherical_parameterization::internal {

/// \file
/// What the front doors are called with. It is looked at before anything is instantiated: a wrong argument is a
/// sentence, and not a page of the compiler.

template <class T, class = void>
struct Is_method : std::false_type {};
template <class T>
struct Is_method<T, std::enable_if_t<(sizeof(Method_solver<T>) > 0)>> : std::true_type {};

/// By its functions, since boost::graph_traits is an error, and not a missing type, for what is no graph.
template <class T, class = void>
struct Is_mesh : std::false_type {};
template <class T>
struct Is_mesh<T, std::void_t<decltype(faces(std::declval<const T&>())), decltype(halfedges(std::declval<const T&>()))>>
  : std::true_type {};

/// Whether T is a property map whose keys can be made of Key.
template <class T, class Key, class = void>
struct Is_map_of : std::false_type {};
template <class T, class Key>
struct Is_map_of<T, Key, std::void_t<typename boost::property_traits<T>::key_type>>
  : std::disjunction<std::is_void<typename boost::property_traits<T>::key_type>, // takes any key
                     std::is_convertible<Key, typename boost::property_traits<T>::key_type>> {};

/// Whether T says what the springs are: the conformal ones, those of a property map, or either.
template <class T, class Edge>
struct Is_weights_of : Is_map_of<T, Edge> {};
template <class Edge>
struct Is_weights_of<Conformal_weights, Edge> : std::true_type {};
template <class Map, class Edge>
struct Is_weights_of<std::variant<Conformal_weights, Map>, Edge> : Is_map_of<Map, Edge> {};

/// Whether points of this type have two coordinates only.
template <class Point, class = void>
struct Is_planar : std::false_type {};
template <class Point>
struct Is_planar<Point,
                 std::enable_if_t<!Has_xyz<Point>::value, std::void_t<decltype(std::declval<const Point&>().y())>>>
  : std::true_type {};
template <class T, std::size_t N>
struct Is_planar<std::array<T, N>> : std::bool_constant<N != 3> {};

/// Whether points of this type can hold a map: made of three coordinates, which are not integers.
template <class Point, class = void>
struct Holds_positions : std::false_type {};
template <class Point>
struct Holds_positions<
  Point, std::void_t<decltype(Point{std::declval<Coordinate_of<Point>>(), std::declval<Coordinate_of<Point>>(),
                                    std::declval<Coordinate_of<Point>>()})>>
  : std::bool_constant<!Is_planar<Point>::value && !std::is_integral_v<Coordinate_of<Point>>> {};

/// Whether T says what the densities are: a property map of numbers, or maybe one.
template <class T, class Key>
struct Is_density_of : Is_map_of<T, Key> {};
template <class Map, class Key>
struct Is_density_of<std::optional<Map>, Key> : Is_map_of<Map, Key> {};

/// The type of a named parameter; void if it is not given.
template <class NamedParameters, class Tag>
using Type_of_parameter =
  std::conditional_t<parameters::is_default_parameter<NamedParameters, Tag>::value, void,
                     std::decay_t<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(), Tag()))>>;

template <class Callback, class = void>
struct Is_callback : std::false_type {};
template <class Callback>
struct Is_callback<Callback, std::enable_if_t<std::is_invocable_v<Callback&, double>>>
  : std::is_same<std::decay_t<std::invoke_result_t<Callback&, double>>, bool> {};

/// static_assert()s about the named parameters of parameterize(); false where one has failed.
template <class Edge, class Vertex, class Face, class NamedParameters>
constexpr bool check_named_parameters()
{
  typedef Type_of_parameter<NamedParameters, edge_weight_tag> Weights_map;
  typedef Type_of_parameter<NamedParameters, internal_np::vertex_is_constrained_t> Constrained_map;
  typedef Type_of_parameter<NamedParameters, internal_np::callback_t> Callback;
  typedef Type_of_parameter<NamedParameters, internal_np::face_density_t> Face_density;
  typedef Type_of_parameter<NamedParameters, internal_np::vertex_density_t> Vertex_density;
  constexpr bool are_weights = std::is_void_v<Weights_map> || Is_weights_of<Weights_map, Edge>::value;
  constexpr bool are_constraints = std::is_void_v<Constrained_map> || Is_map_of<Constrained_map, Vertex>::value;
  constexpr bool is_callback = std::is_void_v<Callback> || Is_callback<Callback>::value;
  constexpr bool are_face_densities = std::is_void_v<Face_density> || Is_density_of<Face_density, Face>::value;
  constexpr bool are_vertex_densities = std::is_void_v<Vertex_density> || Is_density_of<Vertex_density, Vertex>::value;
  static_assert(
    are_weights,
    "edge_weight_map has to be Conformal_weights, or a readable property map whose keys are "
    "edges and whose values are numbers; boost::make_function_property_map<Edge>(f) makes one of a function");
  static_assert(are_constraints,
                "vertex_is_constrained_map has to be a readable property map whose keys are vertices and whose values "
                "are bool");
  static_assert(is_callback, "callback has to be callable as bool(double): it gets the fraction of the work done, and "
                             "returns whether to go on");
  static_assert(are_face_densities, "face_density_map has to be a readable property map whose keys are faces and whose "
                                    "values are numbers");
  static_assert(are_vertex_densities, "vertex_density_map has to be a readable property map whose keys are vertices "
                                      "and whose values are numbers");
  return are_weights && are_constraints && is_callback && are_face_densities && are_vertex_densities;
}

/// static_assert()s about all arguments; false where one has failed.
template <class TriangleMesh, class VertexSphereMap, class NamedParameters>
constexpr bool check_arguments()
{
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  constexpr bool is_sphere_map = Is_map_of<VertexSphereMap, typename Graph_traits::vertex_descriptor>::value;
  static_assert(is_sphere_map, "the sphere map has to be a property map whose keys are the vertices of the mesh");
  if constexpr(is_sphere_map) {
    constexpr bool holds = Holds_positions<typename boost::property_traits<VertexSphereMap>::value_type>::value;
    static_assert(holds,
                  "the sphere map has to hold points with three coordinates, in floating point or exact numbers");
    return holds &&
           check_named_parameters<typename Graph_traits::edge_descriptor, typename Graph_traits::vertex_descriptor,
                                  typename Graph_traits::face_descriptor, NamedParameters>();
  } else
    return false;
}

/// A map whose keys are given by those of this one. What std::optional holds: clang++ takes no optional of a
/// boost::function_property_map whose function cannot be made by default, as those of a lambda.
template <class Descriptor, class Map, class Key>
class Keyed_map {
public:
  typedef Descriptor key_type;
  typedef typename boost::property_traits<Map>::value_type value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;

  Keyed_map(const Map& map, const Key& key) : map_(map), key_(key) {}

  friend value_type get(const Keyed_map& m, const Descriptor& d) { return get(m.map_, m.key_(d)); }

private:
  Map map_;
  Key key_;
};

template <class Descriptor, class Map, class Key>
Keyed_map<Descriptor, Map, Key> keyed_map(const Map& map, const Key& key)
{
  return {map, key};
}

template <class Descriptor, class Map>
auto as_optional(const Map& map)
{
  return std::optional(keyed_map<Descriptor>(map, [](const Descriptor& d) -> const Descriptor& { return d; }));
}

template <class Descriptor, class Map>
std::optional<Map> as_optional(const std::optional<Map>& map)
{
  return map;
}

/// The densities that a named parameter gives, if it does.
template <class Tag, class Key, class NamedParameters>
auto densities(const NamedParameters& np)
{
  if constexpr(parameters::is_default_parameter<NamedParameters, Tag>::value)
    return std::optional<Constant_property_map<Key, double>>();
  else
    return as_optional<Key>(parameters::get_parameter(np, Tag()));
}

/// The weights that `edge_weight_map` gives, or the default.
template <class NamedParameters>
auto edge_weights(const NamedParameters& np)
{
  return parameters::choose_parameter(parameters::get_parameter(np, edge_weight_tag()), Conformal_weights());
}

/// What the caller of parameterize() gives besides the mesh.
template <class TriangleMesh, class NamedParameters>
struct Mesh_inputs {
  const TriangleMesh& mesh;
  const NamedParameters& np;

  auto points() const { return vertex_points(mesh, np); }

  auto weights() const { return edge_weights(np); }

  auto constraints() const
  {
    typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor Vertex;
    return parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_is_constrained),
                                        Static_boolean_property_map<Vertex, false>());
  }

  auto face_densities() const
  {
    return densities<internal_np::face_density_t, typename boost::graph_traits<TriangleMesh>::face_descriptor>(np);
  }
  auto vertex_densities() const
  {
    return densities<internal_np::vertex_density_t, typename boost::graph_traits<TriangleMesh>::vertex_descriptor>(np);
  }
};

/// What the caller of parameterize_triangle_soup() gives besides the soup.
/// \tparam Indexed_mesh  `Indexed_triangle_mesh`
template <class Indexed_mesh, class NamedParameters>
struct Soup_inputs {
  typedef typename Indexed_mesh::Vertex_index Vertex;

  const Indexed_mesh& mesh;
  const NamedParameters& np;

  auto points() const { return get(CGAL::vertex_point, mesh); }

  auto weights() const { return weights_of(edge_weights(np)); }

  auto constraints() const
  {
    if constexpr(parameters::is_default_parameter<NamedParameters, internal_np::vertex_is_constrained_t>::value)
      return Static_boolean_property_map<Vertex, false>();
    else
      return keyed_map<Vertex>(parameters::get_parameter(np, internal_np::vertex_is_constrained),
                               [](Vertex v) { return static_cast<std::size_t>(v.idx()); });
  }

  auto face_densities() const
  {
    return densities_of<typename Indexed_mesh::Face_index>(densities<internal_np::face_density_t, std::size_t>(np));
  }
  auto vertex_densities() const
  {
    return densities_of<Vertex>(densities<internal_np::vertex_density_t, std::size_t>(np));
  }

private:
  template <class Descriptor, class Map>
  auto densities_of(const std::optional<Map>& map) const
  {
    const auto number = [](Descriptor d) { return static_cast<std::size_t>(d.idx()); };
    return map ? std::optional(keyed_map<Descriptor>(*map, number)) : std::nullopt;
  }

  Conformal_weights weights_of(Conformal_weights weights) const { return weights; }

  template <class Map>
  auto weights_of(const Map& map) const
  {
    typedef typename Indexed_mesh::Edge_index Edge;
    return keyed_map<Edge>(map, [m = &mesh](Edge e) {
      const auto [first, second] = std::minmax({source(e, *m).idx(), target(e, *m).idx()});
      return std::pair<std::size_t, std::size_t>(first, second);
    });
  }

  template <class Map>
  auto weights_of(const std::variant<Conformal_weights, Map>& weights) const
  {
    typedef std::variant<Conformal_weights, decltype(weights_of(std::declval<const Map&>()))> Result;
    return std::visit([this](const auto& chosen) { return Result(weights_of(chosen)); }, weights);
  }
};

/// A random access range as a map from the vertices of an indexed mesh.
template <class Range>
struct Range_map {
  typedef void key_type; // any
  typedef std::decay_t<decltype(std::declval<Range&>()[0])> value_type;
  typedef const value_type& reference;
  typedef boost::read_write_property_map_tag category;

  Range* range;

  template <class Vertex>
  friend reference get(const Range_map& map, Vertex v)
  {
    return (*map.range)[v.idx()];
  }
  template <class Vertex>
  friend void put(const Range_map& map, Vertex v, const value_type& p)
  {
    (*map.range)[v.idx()] = p;
  }
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_ARGUMENTS_H
