// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERDICT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERDICT_H

#include <CGAL/Spherical_parameterization/internal/Host_array.h>
#include <CGAL/Spherical_parameterization/Result.h>
#include <CGAL/Spherical_parameterization/internal/Failure.h>
#include <CGAL/Spherical_parameterization/internal/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/Solver_report.h>
#include <CGAL/Spherical_parameterization/internal/spherical_triangles.h>

#include <array>
#include <cmath>
#include <sstream>
#include <string>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline std::string to_string(double x)
{
  std::ostringstream out;
  out.precision(3);
  out << x;
  return out.str();
}

/// Fills in the certificate and decides: nothing but a converged map of degree 1 without flipped faces is `OK`.
template <class Loop>
void pass_verdict(const Loop& loop, const Host_array<std::array<int, 3>>& faces, const Host_array<vec3>& v,
                  const Solver_report& report, const Monitor& monitor, Result& result)
{
  const Certificate certificate = certify(loop, faces, v);
  result.flipped_faces = certificate.flipped_faces;
  result.degree = certificate.degree;
  result.smallest_area = certificate.smallest_area;
  result.smallest_edge = std::ldexp(certificate.smallest_edge, 52);
  result.iterations = report.iterations;
  result.sweeps = report.sweeps;
  result.residual = report.residual;
  result.energy = report.energy;

  // A triangle of this area has corners 1e-13 apart or, if it is a sliver, a height near the rounding of unit vectors.
  constexpr double area_of_rounding = 1e-26;
  const bool is_valid = result.flipped_faces == 0 && result.degree == 1;
  const std::string state = counted(result.flipped_faces, "face is", "faces are") + " flipped, the degree is " +
                            std::to_string(result.degree) + ", the smallest spherical area is " +
                            to_string(result.smallest_area);
  if(monitor.is_interrupted() && !report.has_converged) {
    result.error = Error_code::INTERRUPTED;
    result.detail = monitor.reason() + " after " + counted(report.iterations, "iteration", "iterations") +
                    ", at residual " + to_string(report.residual) + "; " + state;
  } else if(!report.has_converged) {
    result.error = Error_code::NOT_CONVERGED;
    result.detail = (report.has_stalled ? "no progress after " : "stopped after ") +
                    counted(report.iterations, "iteration", "iterations") + ", at residual " +
                    to_string(report.residual) + "; " + state;
  } else if(!is_valid) {
    result.error = Error_code::NOT_BIJECTIVE;
    result.detail = state;
    result.detail += result.smallest_area < area_of_rounding
                       ? ": limbs shrink below the resolution of the coordinates; use barycentric weights, a "
                         "larger spring exponent, or the isometric method"
                       : ": the critical point found is degenerate; use other weights, a larger spring exponent, "
                         "or the isometric method";
  }
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_VERDICT_H
