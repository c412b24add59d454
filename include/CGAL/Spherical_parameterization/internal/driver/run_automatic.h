// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_RUN_AUTOMATIC_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_RUN_AUTOMATIC_H

#include <CGAL/Spherical_parameterization/internal/base/Failure.h>
#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/problem/Map_task.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solver_report.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/run_balanced.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/run_isometric.h>
#include <CGAL/Spherical_parameterization/internal/predicates/spherical_triangles.h>
#include <CGAL/Spherical_parameterization/internal/driver/verdict.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

inline void check_options(const Automatic& method)
{
  check_options(Balanced{method.spring_exponent});
  check_options(Balanced{method.larger_spring_exponent});
  check_options(Isometric{method.area_exponent});
}

inline bool needs_given_start(const Automatic&) { return false; }
inline std::string name(const Automatic& method) { return name(Balanced{method.spring_exponent}); }

/// Returns why there are no weights, if it is because of a face without area. Throws Failure otherwise.
template <class Set_weights>
std::string weigh(const Automatic&, Set_weights set_weights)
{
  try {
    set_weights();
  } catch(const Failure& failure) {
    if(failure.code != Error_code::DEGENERATE_FACE)
      throw;
    return failure.detail;
  }
  return {};
}

/// One map after the other, until one is valid.
template <class Backend>
class Automatic_run {
public:
  Automatic_run(const Backend& backend, Map_task& task, Solver_report& report)
    : backend_(backend), task_(task), report_(report)
  {}

  Host_array<vec3> operator()(const Automatic& method)
  {
    // How many will be needed nobody knows: each takes half of the progress that is left, the last one the rest.
    if(task_.missing_weights.empty()) {
      task_.monitor.begin_stage(0, 0.5);
      if(attempt(Balanced{method.spring_exponent}) || !can_go_on())
        return std::move(map_);
      if(method.larger_spring_exponent > method.spring_exponent) {
        const auto iterations = task_.number_of_iterations;
        task_.number_of_iterations = (std::min)(iterations.value_or(patience), patience);
        task_.monitor.begin_stage(0.5, 0.75);
        const bool is_valid = attempt(Balanced{method.larger_spring_exponent});
        task_.number_of_iterations = iterations;
        if(is_valid || !can_go_on())
          return std::move(map_);
      }
    } else
      task_.result.fallback_reason = task_.missing_weights;

    if(task_.has_fixed()) { // which the isometric method cannot keep: the last map is handed over as it is
      if(map_.empty())
        throw Failure{Error_code::DEGENERATE_FACE, task_.result.fallback_reason};
      return std::move(map_);
    }
    const Isometric last{method.area_exponent};
    task_.monitor.begin_stage(map_.empty() ? 0 : 0.75, 1);
    task_.result.method = name(last);
    task_.accuracy.reset(); // these are for the springs
    task_.number_of_iterations.reset();
    report_ = Solver_report();
    return run(backend_, last, task_, report_);
  }

private:
  /// Iterations of the larger exponent: where it helps, it does so soon.
  static constexpr std::size_t patience = 100;

  /// Returns whether the map is valid, and says what is wrong with it if not.
  bool attempt(const Balanced& method)
  {
    std::string& reason = task_.result.fallback_reason;
    const std::string before = reason.empty() ? "" : reason + "; ";
    task_.result.method = name(method);
    try {
      report_ = Solver_report();
      map_ = run(backend_, method, task_, report_);
    } catch(const Failure& failure) {
      reason = before + name(method) + ": " + failure.detail;
      if(!can_go_on() && map_.empty())
        throw Failure{Error_code::INTERRUPTED, task_.monitor.reason() + " before there was a map"};
      return false;
    }
    const Certificate certificate = certify(backend_.host_loop(), task_.faces, map_);
    if(report_.has_converged && certificate.is_valid())
      return true;
    reason = before + name(method) + ": ";
    if(!report_.has_converged)
      reason += "residual " + to_string(report_.residual) + " after " +
                counted(report_.iterations, "iteration", "iterations") + ", ";
    reason += counted(certificate.flipped_faces, "face is", "faces are") + " flipped, the degree is " +
              std::to_string(certificate.degree);
    return false;
  }

  bool can_go_on() const { return !task_.monitor.is_interrupted(); }

  const Backend& backend_;
  Map_task& task_;
  Solver_report& report_;
  Host_array<vec3> map_;
};

template <class Backend>
Host_array<vec3> run(const Backend& backend, const Automatic& method, Map_task& task, Solver_report& report)
{
  return Automatic_run<Backend>(backend, task, report)(method);
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_RUN_AUTOMATIC_H
