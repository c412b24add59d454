// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_SOLVE_ISOMETRIC_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_SOLVE_ISOMETRIC_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <cmath>

#include <string>

namespace CGAL::Spherical_parameterization::internal {

CGAL_SP_CORE Solution solve_isometric(const Host_loop& loop, const Isometric& method, const Problem& problem,
                                      const Effort& effort, Monitor& monitor);

/// See solve_isometric_impl.h, and doc/isometric_method.md.
template <>
class Method_solver<Isometric> {
public:
  explicit Method_solver(const Isometric& method) : method_(method)
  {
    const double exponent = method.area_exponent.value_or(Isometric::default_area_exponent);
    CGAL_SP_PRECONDITION(exponent >= 0 && std::isfinite(exponent),
                         "the area exponent has to be 0 or larger, and finite");
    CGAL_SP_PRECONDITION(method.landmark_weight > 0, "the weight of landmarks has to be positive");
  }

  static Weights weights() { return Weights::UNUSED; }
  bool needs_given_start() const { return false; }
  std::string name() const { return "isometric"; }

  template <class Backend>
  Solution solve(const Backend& backend, const Problem& problem, const Effort& effort, Monitor& monitor) const
  {
    return solve_isometric(backend.host_loop(), method_, problem, effort, monitor);
  }

private:
  Isometric method_;
};

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/isometric/solve_isometric_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_ISOMETRIC_SOLVE_ISOMETRIC_H
