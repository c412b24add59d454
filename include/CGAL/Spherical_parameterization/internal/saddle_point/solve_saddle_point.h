// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_H

#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// See solve_saddle_point_impl.h.
template <>
class Method_solver<Saddle_point> {
public:
  explicit Method_solver(const Saddle_point& method) : method_(method)
  {
    CGAL_SP_PRECONDITION(method.relaxation > 0, "the relaxation has to be positive");
    CGAL_SP_PRECONDITION(method.relaxation < (method.splitting == Saddle_point::Splitting::JACOBI ? 1 : 2),
                         "the relaxation has to be below 1 for Jacobi, below 2 for Gauss-Seidel sweeps");
    CGAL_SP_PRECONDITION(method.check_interval > 0, "the interval between two checks has to be 1 or larger");
  }

  static Weights weights() { return Weights::NEEDED; }
  bool needs_given_start() const { return method_.start == Saddle_point::Start::GIVEN; }
  std::string name() const { return "saddle-point"; }

  template <class Backend>
  Solution solve(const Backend& backend, const Problem& problem, const Effort& effort, Monitor& monitor) const;

private:
  Saddle_point method_;
};

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SADDLE_POINT_SOLVE_SADDLE_POINT_H
