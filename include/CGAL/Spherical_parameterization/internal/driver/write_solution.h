// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_WRITE_SOLUTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_WRITE_SOLUTION_H

#include <CGAL/Spherical_parameterization/Result.h>
#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/driver/read_problem.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Everything in a solution but its positions.
CGAL_SP_CORE void describe(const Solution& solution, Result& result);

/// Writes the positions, which are certified as the map stores them, and says what was done.
template <class Vertex, class VertexSphereMap>
void write_solution(const Solution& solution, const std::vector<Vertex>& vertex, VertexSphereMap sphere_map,
                    Result& result)
{
  typedef typename boost::property_traits<VertexSphereMap>::value_type Sphere_point;
  const Stopwatch watch;
  for(std::size_t i = 0; i < solution.position.size(); ++i)
    put(sphere_map, vertex[i], stored_point<Sphere_point>(solution.position[i]));
  describe(solution, result);
  result.seconds.certify += watch.seconds();
}

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/driver/write_solution_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_WRITE_SOLUTION_H
