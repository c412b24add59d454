// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_AUTOMATIC_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_AUTOMATIC_H

#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/solve_isometric.h>
#include <CGAL/Spherical_parameterization/internal/harmonic/solve_balanced.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/methods.h>

#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// The first valid solution of several methods, else the best one.
template <>
class Method_solver<Automatic> {
public:
  explicit Method_solver(const Automatic& method) : method_(method)
  {
    const Method_solver<Balanced> first(Balanced{method.spring_exponent});
    const Method_solver<Balanced> second(Balanced{method.larger_spring_exponent});
    const Method_solver<Isometric> third(Isometric{method.area_exponent});
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
#include <CGAL/Spherical_parameterization/internal/driver/solve_automatic_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_AUTOMATIC_H
