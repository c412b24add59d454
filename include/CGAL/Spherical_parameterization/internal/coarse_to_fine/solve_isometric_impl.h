// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_SOLVE_ISOMETRIC_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_SOLVE_ISOMETRIC_IMPL_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Coarse_to_fine_map.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/solve_isometric.h>

#include <string>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// Throws the Error if there is no map whose edges are geodesic: these are determined by their ends.
inline void check_simplicial(const Weighted_graph& graph)
{
  const char* const problem = "there is no map with geodesic edges: ";
  if(graph.size() < 4)
    throw Input_error(Error_code::NOT_BIJECTIVE, std::string(problem) + "the mesh has fewer than four vertices");
  for(int i = 0; i < graph.size(); ++i)
    for(int k = graph.offset[i]; k < graph.offset[i + 1]; ++k)
      if(graph.target[k] == i || (k > graph.offset[i] && graph.target[k] == graph.target[k - 1]))
        throw Input_error(Error_code::NOT_BIJECTIVE, std::string(problem) + "two edges of the mesh have the same ends");
}

CGAL_SP_CORE Solution solve_isometric(const Host_loop& loop, const Isometric& method, const Problem& problem,
                                      const Effort& effort, Monitor& monitor)
{
  if(problem.has_fixed())
    throw Input_error(Error_code::BAD_CONSTRAINTS, "the isometric method cannot keep vertices fixed");
  check_simplicial(*problem.graph);
  const Stopwatch watch;
  Solution solution;
  solution.position = Coarse_to_fine_map(loop, method, problem, effort, monitor).run(solution.report);
  solution.seconds.solve = watch.seconds();

  const Stopwatch certify_watch;
  make_storable(loop, problem, false, solution.position);
  solution.certificate = certify(loop, problem.face, solution.position);
  solution.seconds.certify = certify_watch.seconds();
  return solution;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_SOLVE_ISOMETRIC_IMPL_H
