// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_VERDICT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_VERDICT_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/Result.h>
#include <CGAL/Spherical_parameterization/internal/base/Failure.h>
#include <CGAL/Spherical_parameterization/internal/base/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solver_report.h>
#include <CGAL/Spherical_parameterization/internal/predicates/spherical_triangles.h>

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

/// Why the solver may have converged to what is no map, and what to do about it.
inline const char* reason_for_flips(double smallest_area, bool has_fixed)
{
  // A triangle of this area has corners 1e-13 apart or, if it is a sliver, a height near the rounding of unit vectors.
  constexpr double area_of_rounding = 1e-26;
  if(smallest_area < area_of_rounding)
    return has_fixed ? "limbs shrink below the resolution of the coordinates, or the fixed vertices contradict each "
                       "other; use a larger spring exponent or barycentric weights, and fix no vertices in limbs"
                     : "limbs shrink below the resolution of the coordinates; use the automatic or the isometric "
                       "method, a larger spring exponent, or barycentric weights";
  return has_fixed
           ? "the fixed vertices contradict each other, or are too few to hold the map; fix more of them, better "
             "spread, or none"
           : "the critical point found is degenerate; use the automatic or the isometric method, a larger "
             "spring exponent, or other weights";
}

/// Fills in the certificate and decides: nothing but a converged map of degree 1 without flipped faces is `OK`.
template <class Loop>
void pass_verdict(const Loop& loop, const Host_array<std::array<int, 3>>& faces, const Host_array<vec3>& v,
                  bool has_fixed, const Solver_report& report, const Monitor& monitor, Result& result)
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
    result.detail = state + ": " + reason_for_flips(result.smallest_area, has_fixed);
  }
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_VERDICT_H
