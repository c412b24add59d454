// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AUTOMATIC_SOLVE_AUTOMATIC_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AUTOMATIC_SOLVE_AUTOMATIC_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/balanced/solve_balanced.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/isometric/solve_isometric.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// The first valid solution of several methods, else the best one.
template <>
class Method_solver<Automatic> {
public:
  explicit Method_solver(const Automatic& method) : method_(method)
  {
    const Method_solver<Balanced> first(Balanced{method.spring_exponent});
    const Method_solver<Isometric> second(Isometric{method.area_exponent});
    CGAL_SP_PRECONDITION(method.largest_shrinkage >= 1, "the largest shrinkage has to be 1 or more");
  }

  static Weights weights() { return Weights::IF_AVAILABLE; }
  bool needs_given_start() const { return false; }
  std::string name() const { return Method_solver<Balanced>(Balanced{method_.spring_exponent}).name(); }

  template <class Backend>
  Solution solve(const Backend& backend, const Problem& problem, const Effort& effort, Monitor& monitor) const;

private:
  Automatic method_;
};

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/automatic/solve_automatic_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_AUTOMATIC_SOLVE_AUTOMATIC_H
