// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLUTION_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLUTION_IMPL_H

#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// Why the solver may have converged to what is no map, and what may help, besides other methods.
struct Reason_for_flips {
  const char *cause, *remedy;
};

CGAL_SP_INLINE Reason_for_flips reason_for_flips(const Problem& problem, const Certificate& certificate)
{
  const char* const other_springs = "a larger spring exponent or other weights";
  // Corners at this distance have three digits of their own; the area of triangles that are as small.
  constexpr double edge_of_rounding = 1e-12, area_of_rounding = 1e-26;
  // The same for the 24 bits of floats, which are what maps that do not keep doubles are made of.
  constexpr double area_of_float_rounding = 1e-9;
  if(problem.as_stored && certificate.smallest_area < area_of_float_rounding)
    return {"the sphere map rounds the coordinates to fewer digits than doubles have", "a sphere map of doubles"};
  if(problem.has_fixed())
    return {"the harmonic map with these fixed vertices is not bijective: they contradict each other, or are too few",
            "more fixed vertices, better spread"};
  if(certificate.degree != 1)
    return {"the map found does not cover the sphere once", other_springs};
  if(certificate.smallest_area < area_of_rounding && certificate.smallest_edge < edge_of_rounding)
    return {"its smallest faces are below the resolution of the coordinates, as those of thin limbs are",
            "a larger spring exponent or barycentric weights"};
  return {"the critical point that was found has flipped faces, for which large faces or noise in the mesh can be "
          "the reason",
          other_springs};
}

/// Why a map is what it is.
CGAL_SP_INLINE Termination termination_of(const Monitor& monitor, const Solution& solution)
{
  const Solver_report& report = solution.report;
  const bool has_converged = report.residual <= solution.accuracy;
  if(monitor.is_interrupted() && !(has_converged && solution.certificate.is_valid())) // faces were still being mended
    return monitor.termination();
  if(has_converged)
    return Termination::CONVERGED;
  const bool was_moved = std::count(solution.is_moved.begin(), solution.is_moved.end(), 1) > 0;
  return report.has_stalled || was_moved ? Termination::STALLED : Termination::ITERATIONS;
}

CGAL_SP_CORE void pass_verdict(const Problem& problem, const Monitor& monitor, Solution& solution)
{
  const Solver_report& report = solution.report;
  const Certificate& certificate = solution.certificate;
  solution.termination = termination_of(monitor, solution);
  const bool is_done = report.has_converged || *solution.termination == Termination::CONVERGED;
  const auto after = [&](const std::string& what) {
    const std::string where = std::isnan(report.residual) ? "" : ", at residual " + to_string(report.residual);
    return what + " after " + counted(report.iterations, "iteration", "iterations") + where + "; ";
  };
  const std::string state = counted(certificate.flipped_faces, "face is", "faces are") + " flipped, the degree is " +
                            std::to_string(certificate.degree) + ", the smallest spherical area is " +
                            to_string(certificate.smallest_area);
  if(monitor.is_interrupted() && !(is_done && certificate.is_valid())) {
    solution.error = Error_code::INTERRUPTED;
    solution.detail = after(monitor.reason()) + state;
  } else if(!is_done) {
    solution.error = Error_code::NOT_CONVERGED;
    solution.detail = after(report.has_stalled ? "no progress" : "stopped") + state;
  } else if(!certificate.is_valid()) {
    solution.error = Error_code::NOT_BIJECTIVE;
    const auto [cause, remedy] = reason_for_flips(problem, certificate);
    solution.detail = state + ": " + cause;
    solution.remedy = remedy;
  }
}

CGAL_SP_CORE void describe(const Solution& solution, Result& result)
{
  result.error = solution.error;
  result.detail = solution.detail;
  result.remedy = solution.remedy;
  if(solution.has_map()) {
    result.flipped_faces = solution.certificate.flipped_faces;
    result.degree = solution.certificate.degree;
    result.moved_vertices = static_cast<std::size_t>(std::count(solution.is_moved.begin(), solution.is_moved.end(), 1));
    result.smallest_area = solution.certificate.smallest_area;
    result.smallest_edge = std::ldexp(solution.certificate.smallest_edge, 52);
  }
  result.termination = solution.termination;
  result.residual = solution.report.residual;
  result.energy = solution.report.energy;
  result.density_deviation = solution.report.density_deviation;
  result.start_iterations = solution.report.start_iterations;
  result.iterations = solution.report.iterations;
  result.sweeps = solution.report.sweeps;
  result.method = solution.method;
  result.device = solution.device;
  result.attempts = solution.attempts;
  result.fallback_reason = solution.fallback_reason;
  const Result::Seconds before = result.seconds;
  result.seconds = solution.seconds;
  result.seconds.read = before.read;
  result.seconds.weights = before.weights;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PROBLEM_SOLUTION_IMPL_H
