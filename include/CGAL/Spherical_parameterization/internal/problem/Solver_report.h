// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLVER_REPORT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLVER_REPORT_H

#include <cstddef>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// What a solver has to say about its run.
struct Solver_report {
  std::size_t iterations = 0;
  std::size_t sweeps = 0;
  double residual = 0;
  double energy = 0;
  bool has_converged = false;
  bool has_stalled = false; ///< gave up before the limit of iterations, since nothing improved any more
};

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLVER_REPORT_H
