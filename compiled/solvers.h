// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

// The solvers of one policy, method by method: each is compiled in a file of its own, and only there.
#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_SOLVERS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_SOLVERS_H

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/driver/solve.h>
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
#include <CGAL/Spherical_parameterization/OpenCL_device.h>
#endif

#define CGAL_SP_SOLVER(PREFIX, METHOD, POLICY)                                                                         \
  PREFIX Solution Method_solver<METHOD>::solve(const Backend<POLICY>&, const Problem&, const Effort&, Monitor&) const;
#define CGAL_SP_SOLVERS(PREFIX, POLICY)                                                                                \
  CGAL_SP_SOLVER(PREFIX, Balanced, POLICY)                                                                             \
  CGAL_SP_SOLVER(PREFIX, Saddle_point, POLICY)

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_SOLVERS(extern template, CGAL::Sequential_tag)
#ifdef CGAL_LINKED_WITH_TBB
CGAL_SP_SOLVERS(extern template, CGAL::Parallel_tag)
#endif
#ifdef CGAL_SPHERICAL_PARAMETERIZATION_WITH_OPENCL
CGAL_SP_SOLVERS(extern template, OpenCL_device)
#endif

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_COMPILED_SOLVERS_H
