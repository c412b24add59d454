// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_LANDMARKS_IN_PLACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_LANDMARKS_IN_PLACE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/correspondence/Registered_surface.h>
#include <CGAL/Spherical_parameterization/internal/isometric/solve_isometric.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>
#include <CGAL/Spherical_parameterization/internal/surface/Surface.h>
#include <CGAL/Spherical_parameterization/values/Error.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// For the isometric method: a surface, of which no vertex is fixed.
inline Problem isometric_problem(const Host_array<std::array<int, 3>>& face, const Host_array<vec3>& point)
{
  Problem problem;
  problem.face = face;
  problem.point = point;
  scale_to_unit_box(problem.point);
  const int n = problem.number_of_vertices = static_cast<int>(point.size());
  problem.position.resize(n);
  std::iota(problem.position.begin(), problem.position.end(), 0);
  problem.is_fixed.assign(n, 0);
  problem.given.assign(n, {0, 0, 0});
  return problem;
}

inline void hold(Problem& problem, int vertex, vec3 place)
{
  problem.is_fixed[vertex] = 1;
  problem.given[vertex] = place;
}

/// Changes a map x so that all landmarks are exactly in place, and that little else is moved: x itself is taken for the
/// surface of which an isometric map with these fixed vertices is sought. If there is none without flips, x stays.
/// Returns whether landmarks were put in place that had not been there.
CGAL_SP_INLINE bool put_in_place(const Host_loop& loop, const Host_array<std::array<int, 3>>& face,
                                 const std::vector<Registration_landmark>& landmarks, Monitor& monitor,
                                 Host_array<vec3>& x)
{
  if(std::all_of(landmarks.begin(), landmarks.end(), [&](const Registration_landmark& l) { return l.is_in_place(x); }))
    return false;
  Problem problem = isometric_problem(face, x);
  for(const Registration_landmark& l : landmarks)
    hold(problem, l.vertex, l.place);
  try {
    Solution solution = solve_isometric(loop, Isometric(), problem, {}, monitor);
    if(!solution.certificate.is_valid())
      return false;
    x = std::move(solution.position);
    return true;
  } catch(const Input_error& error) { // the mesh is too coarse, or no more time
    if(error.code() != Error_code::BAD_CONSTRAINTS && error.code() != Error_code::NOT_BIJECTIVE &&
       error.code() != Error_code::INTERRUPTED)
      throw;
    return false;
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_LANDMARKS_IN_PLACE_H
