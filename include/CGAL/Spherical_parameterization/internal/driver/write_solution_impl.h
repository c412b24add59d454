// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_WRITE_SOLUTION_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_WRITE_SOLUTION_IMPL_H

#include <CGAL/Spherical_parameterization/internal/driver/write_solution.h>

#include <cmath>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_CORE void describe(const Solution& solution, Result& result)
{
  result.error = solution.error;
  result.detail = solution.detail;
  if(solution.has_map()) {
    result.flipped_faces = solution.certificate.flipped_faces;
    result.degree = solution.certificate.degree;
    result.smallest_area = solution.certificate.smallest_area;
    result.smallest_edge = std::ldexp(solution.certificate.smallest_edge, 52);
  }
  result.residual = solution.report.residual;
  result.energy = solution.report.energy;
  result.start_iterations = solution.report.start_iterations;
  result.iterations = solution.report.iterations;
  result.sweeps = solution.report.sweeps;
  result.method = solution.method;
  result.device = solution.device;
  result.attempts = solution.attempts;
  result.fallback_reason = solution.fallback_reason;
  const double read = result.seconds.read;
  result.seconds = solution.seconds;
  result.seconds.read = read;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_WRITE_SOLUTION_IMPL_H
