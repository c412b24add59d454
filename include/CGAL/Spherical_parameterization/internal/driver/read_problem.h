// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_PROBLEM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_PROBLEM_H

#include <CGAL/Spherical_parameterization/values/Result.h>
#include <CGAL/Spherical_parameterization/internal/context/Watched_loop.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/surface/read_surface.h>
#include <CGAL/Spherical_parameterization/internal/driver/read_springs.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A problem, and where its vertices are in the mesh of the caller.
template <class TriangleMesh>
struct Input {
  typedef typename boost::graph_traits<TriangleMesh>::vertex_descriptor vertex_descriptor;

  Problem problem;
  Vertices<TriangleMesh> vertices; ///< empty for meshes that number their vertices themselves

  vertex_descriptor vertex(int i) const
  {
    if constexpr(Has_breadth_first_order<TriangleMesh>::value)
      return vertex_descriptor(problem.position[i]);
    else
      return vertices[i];
  }
};

/// A coordinate after a number of type FT has held it. It is volatile since g++ 12 takes two such conversions in a row,
/// of neighbouring coordinates, for nothing when it vectorizes them.
template <class FT>
double coordinate_as_stored(double x)
{
  if constexpr(std::is_floating_point_v<FT>) {
    const volatile FT stored = static_cast<FT>(x);
    return stored;
  } else
    return CGAL::to_double(static_cast<FT>(x));
}

/// A position after points of this type have held it.
template <class Point>
vec3 position_as_stored(vec3 p)
{
  typedef Coordinate_of<Point> FT;
  return {coordinate_as_stored<FT>(p.x), coordinate_as_stored<FT>(p.y), coordinate_as_stored<FT>(p.z)};
}

/// Whether points of this type round the coordinates of a position, which are doubles.
template <class Point>
constexpr bool are_positions_rounded()
{
  typedef std::numeric_limits<Coordinate_of<Point>> Limits;
  return Limits::is_specialized && Limits::radix == 2 && Limits::digits < std::numeric_limits<double>::digits;
}

/// Marks the constrained vertices; empty if there are none. One or two would leave a boost free, along which the map
/// collapses.
template <class Vertex, class ConstrainedMap>
std::vector<char> fixed_vertices(const std::vector<Vertex>& vertices, ConstrainedMap is_constrained)
{
  std::vector<char> is_fixed;
  for(const Vertex& v : vertices)
    is_fixed.push_back(get(is_constrained, v) ? 1 : 0);
  const auto count = std::count(is_fixed.begin(), is_fixed.end(), 1);
  if(count == 0)
    return {};
  if(count < 3)
    throw Input_error(Error_code::BAD_CONSTRAINTS,
                      "only " + counted(count, "vertex is", "vertices are") + " fixed; fix three or more, or none");
  return is_fixed;
}

/// The directions that the sphere map holds at the fixed vertices, or at all of them; others are left zero. Vectors of
/// length 1 up to rounding are kept to the last bit. Throws Error.
template <class Vertex, class VertexSphereMap>
Host_array<vec3> given_positions(const std::vector<Vertex>& vertices, const Host_array<int>& position,
                                 VertexSphereMap sphere_map, const std::vector<char>& is_fixed, bool all,
                                 double rounding)
{
  typedef typename boost::property_traits<VertexSphereMap>::category Category;
  if constexpr(std::is_convertible_v<Category, boost::readable_property_map_tag>) {
    Host_array<vec3> given(vertices.size(), vec3{0, 0, 0});
    std::vector<std::pair<std::array<double, 3>, int>> fixed;
    for(std::size_t i = 0; i < vertices.size(); ++i) {
      const bool is_fixed_vertex = !is_fixed.empty() && is_fixed[i];
      if(!all && !is_fixed_vertex)
        continue;
      vec3 p = coordinates(get(sphere_map, vertices[i]));
      const vec3 box = scaled_to_unit_box(p);
      if(!is_finite(p) || inner(box, box) == 0)
        throw Input_error(Error_code::BAD_CONSTRAINTS,
                          "the position given for vertex " + std::to_string(position[i]) + " is not a direction");
      if(!(std::abs(inner(p, p) - 1) <= rounding))
        p = unit(box);
      given[i] = p;
      if(is_fixed_vertex)
        fixed.push_back({{p.x, p.y, p.z}, position[i]});
    }
    std::sort(fixed.begin(), fixed.end());
    const auto same =
      std::adjacent_find(fixed.begin(), fixed.end(), [](const auto& a, const auto& b) { return a.first == b.first; });
    if(same != fixed.end())
      throw Input_error(Error_code::BAD_CONSTRAINTS, "the fixed vertices " + std::to_string(same->second) + " and " +
                                                       std::to_string(same[1].second) + " are at the same position");
    return given;
  } else
    throw Input_error(Error_code::BAD_CONSTRAINTS,
                      "the sphere map is not readable, and holds no positions to start from");
}

/// A positive number for each of a range of faces or vertices, scaled so that the largest is 1; empty if there is no
/// map. Throws Error.
template <class Range, class DensityMap>
Host_array<double> read_densities(const Range& range, const std::optional<DensityMap>& map, const std::string& what)
{
  Host_array<double> density;
  if(!map)
    return density;
  for(const auto& element : range) {
    density.push_back(as_double(get(*map, element)));
    if(!(density.back() > 0 && std::isfinite(density.back())))
      throw Input_error(Error_code::BAD_DENSITY, what + ' ' + std::to_string(density.size() - 1) + " has the density " +
                                                   to_string(density.back()) +
                                                   "; densities must be positive and finite");
  }
  if(density.empty())
    return density;
  const auto [least, largest] = std::minmax_element(density.begin(), density.end());
  const double unit = *largest;
  if(!(*least / unit >= (std::numeric_limits<double>::min)()))
    throw Input_error(Error_code::BAD_DENSITY, what + ' ' + std::to_string(least - density.begin()) +
                                                 " has the density " + to_string(*least) + ", and " + what + ' ' +
                                                 std::to_string(largest - density.begin()) + " has " +
                                                 to_string(*largest) + ", beside which it vanishes");
  for(double& d : density)
    d /= unit;
  return density;
}

/// The density of every face; that of vertices is taken to be linear in between. Empty if none is given.
template <class TriangleMesh, class Inputs>
Host_array<double> face_densities(const TriangleMesh& mesh, const Inputs& inputs,
                                  const Host_array<std::array<int, 3>>& face, const Host_array<int>& position)
{
  const Host_array<double> of_vertices = read_densities(vertices(mesh), inputs.vertex_densities(), "vertex");
  if(of_vertices.empty())
    return read_densities(faces(mesh), inputs.face_densities(), "face");
  Host_array<double> density;
  density.reserve(face.size());
  for(const auto& [i, j, k] : face)
    density.push_back((of_vertices[position[i]] + of_vertices[position[j]] + of_vertices[position[k]]) / 3);
  return density;
}

/// Reads mesh and property maps, each once, and checks them. Sets the sizes and `seconds.weights` of `result`. Throws
/// Error. Numbers that several threads may read at once are read on the threads of the policy. The callback is not
/// called before all has been read; conformal weights come after that.
template <class ExecutionPolicy, class TriangleMesh, class Solver, class VertexSphereMap, class Inputs>
Input<TriangleMesh> read_problem(const TriangleMesh& mesh, const Solver& solver, VertexSphereMap sphere_map,
                                 const Inputs& inputs, Monitor& monitor, Result& result)
{
  const bool has_face_density = inputs.face_densities().has_value();
  const bool has_density = has_face_density || inputs.vertex_densities().has_value();
  CGAL_SP_PRECONDITION(!(has_face_density && inputs.vertex_densities().has_value()),
                       "densities are of faces or of vertices, not of both");
  CGAL_SP_PRECONDITION(!has_density || solver.weights() != Weights::NEEDED,
                       "densities need the isometric or the automatic method: springs do not follow them");
  const auto points = inputs.points();
  typedef typename boost::property_traits<std::decay_t<decltype(points)>>::value_type Point;
  typedef typename boost::property_traits<VertexSphereMap>::value_type Sphere_point;
  const Host_loop loop = are_plain_coordinates<Point>() ? loop_of<ExecutionPolicy>() : Host_loop();
  Input<TriangleMesh> input;
  Problem& problem = input.problem;
  Vertices<TriangleMesh>& vertex = input.vertices;
  monitor.set_silent(true);
  static_cast<Surface&>(problem) = read_surface(mesh, points, Reading::BREADTH_FIRST, loop, vertex);
  result.number_of_vertices = vertex.size();
  result.number_of_faces = problem.face.size();
  monitor.advance_or_throw();
  problem.density = face_densities(mesh, inputs, problem.face, problem.position);
  problem.is_fixed = fixed_vertices(vertex, inputs.constraints());
  const bool needs_start = solver.needs_given_start();
  if(problem.has_fixed() || needs_start)
    problem.given = given_positions(vertex, problem.position, sphere_map, problem.is_fixed, needs_start,
                                    are_positions_rounded<Sphere_point>() ? 1e-6 : 1e-15);
  const Stopwatch weights_watch;
  if(has_density)
    problem.missing_weights = "springs do not follow densities";
  else if(solver.weights() != Weights::UNUSED)
    try {
      const auto weights = inputs.weights();
      monitor.set_silent(!is_of_surface(weights));
      Springs springs = read_springs(mesh, problem, vertex, weights, Watched_loop(loop, monitor));
      springs.graph.update_diagonal({}, loop);
      problem.graph = std::make_shared<const Weighted_graph>(std::move(springs.graph));
      problem.spring_lengths = std::move(springs.lengths);
      problem.weight_unit = springs.weight_unit;
    } catch(const Input_error& error) {
      result.seconds.weights = weights_watch.seconds();
      if(solver.weights() == Weights::NEEDED || error.code() != Error_code::DEGENERATE_FACE)
        throw;
      problem.missing_weights = error.detail();
    }
  monitor.set_silent(false);
  result.seconds.weights = weights_watch.seconds();
  if constexpr(are_positions_rounded<Sphere_point>()) {
    problem.as_stored = position_as_stored<Sphere_point>;
    problem.rounding = std::ldexp(1., -std::numeric_limits<Coordinate_of<Sphere_point>>::digits);
  }
  if constexpr(Has_breadth_first_order<TriangleMesh>::value)
    Vertices<TriangleMesh>().swap(vertex);
  return input;
}

/// Writes the positions, which are certified as the map stores them, and says what was done.
template <class TriangleMesh, class VertexSphereMap>
void write_solution(const Solution& solution, const Input<TriangleMesh>& input, VertexSphereMap sphere_map,
                    Result& result)
{
  typedef typename boost::property_traits<VertexSphereMap>::value_type Sphere_point;
  const Stopwatch watch;
  const int n = static_cast<int>(solution.position.size());
  for(int i = 0; i < n; ++i)
    put(sphere_map, input.vertex(i), stored_point<Sphere_point>(solution.position[i]));
  describe(solution, result);
  result.seconds.certify += watch.seconds();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_PROBLEM_H
