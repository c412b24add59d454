// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_PROBLEM_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_PROBLEM_H

#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/mesh/Source_mesh.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>
#include <CGAL/Spherical_parameterization/internal/problem/fixed_vertices.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A problem, and where its vertices are in the mesh of the caller.
template <class Vertex>
struct Input {
  std::vector<Vertex> vertex;
  Problem problem;
};

/// A position as points of this type hold it.
template <class Point>
Point stored_point(vec3 p)
{
  typedef Coordinate_of<Point> FT;
  return Point{static_cast<FT>(p.x), static_cast<FT>(p.y), static_cast<FT>(p.z)};
}

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

/// Weights as far as the method needs them; returns why there are none although it could use them.
template <class Read_weights>
std::string read_weights(Weights use, Read_weights read)
{
  if(use == Weights::UNUSED)
    return {};
  try {
    read();
  } catch(const Input_error& error) {
    if(use == Weights::NEEDED || error.code() != Error_code::DEGENERATE_FACE)
      throw;
    return error.detail();
  }
  return {};
}

/// Reads mesh and property maps, each once, and checks them. Sets the sizes of `result`. Throws Error. Numbers that
/// several threads may read at once are read on the threads of the policy.
template <class ExecutionPolicy, class TriangleMesh, class Solver, class VertexSphereMap, class Inputs>
Input<typename boost::graph_traits<TriangleMesh>::vertex_descriptor>
read_problem(const TriangleMesh& mesh, const Solver& solver, VertexSphereMap sphere_map, const Effort& effort,
             const Inputs& inputs, Result& result)
{
  const auto points = inputs.points();
  typedef typename boost::property_traits<std::decay_t<decltype(points)>>::value_type Point;
  typedef typename boost::property_traits<VertexSphereMap>::value_type Sphere_point;
  const Host_loop loop = are_plain_coordinates<Point>() ? loop_of<ExecutionPolicy>() : Host_loop();
  Source_mesh<TriangleMesh> source(mesh, points, loop);
  result.number_of_vertices = source.vertex.size();
  result.number_of_faces = source.face.size();
  Problem problem;
  problem.missing_weights = read_weights(solver.weights(), [&] { source.set_weights(mesh, inputs.weights(), loop); });
  problem.is_fixed = fixed_vertices(source.vertex, inputs.constraints());
  const bool needs_start = solver.needs_given_start();
  if(problem.has_fixed() || needs_start)
    problem.given = given_positions(source.vertex, source.position, sphere_map, problem.is_fixed, needs_start,
                                    are_positions_rounded<Sphere_point>() ? 1e-6 : 1e-15);
  if(!source.graph->weight.empty() && problem.missing_weights.empty())
    source.graph->update_diagonal({}, loop);
  problem.face = std::move(source.face);
  problem.point = std::move(source.point);
  problem.area = std::move(source.area);
  problem.position = std::move(source.position);
  problem.graph = std::move(source.graph);
  problem.weight_unit = source.weight_unit;
  problem.effort = effort;
  if(are_positions_rounded<Sphere_point>())
    problem.as_stored = position_as_stored<Sphere_point>;
  return {std::move(source.vertex), std::move(problem)};
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_READ_PROBLEM_H
