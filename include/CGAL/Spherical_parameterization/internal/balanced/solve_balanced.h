// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_H

#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <cmath>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// See solve_balanced_impl.h, and doc/balanced_method.md.
template <>
class Method_solver<Balanced> {
public:
  explicit Method_solver(const Balanced& method) : method_(method)
  {
    CGAL_SP_PRECONDITION(method.spring_exponent >= 2 && std::isfinite(method.spring_exponent),
                         "the spring exponent has to be 2 or larger, and finite");
  }

  static Weights weights() { return Weights::NEEDED; }
  bool needs_given_start() const { return false; }
  std::string name() const
  {
    return method_.spring_exponent == 2 ? "balanced" : "balanced with exponent " + to_string(method_.spring_exponent);
  }

  template <class Backend>
  Solution solve(const Backend& backend, const Problem& problem, const Effort& effort, Monitor& monitor) const;

private:
  Balanced method_;
};

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/balanced/solve_balanced_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_H
