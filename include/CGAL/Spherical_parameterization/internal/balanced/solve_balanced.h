// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_H

#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/text/text.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// See solve_balanced_impl.h, and doc/balanced_method.md.
template <>
class Method_solver<Balanced> {
public:
  /// Whether a map with many flipped faces is not worth any more work.
  typedef std::function<bool(const Host_array<vec3>&)> Rejection;

  explicit Method_solver(const Balanced& method, Rejection rejects = nullptr)
    : method_(method), rejects_(std::move(rejects))
  {
    CGAL_SP_PRECONDITION(method.spring_exponent >= 2 && std::isfinite(method.spring_exponent),
                         "the spring exponent has to be 2 or larger, and finite");
  }

  static Weights weights() { return Weights::NEEDED; }
  bool needs_given_start() const { return false; }
  std::string name() const
  {
    const double exponent = method_.spring_exponent;
    return exponent == 2 ? "balanced" : "balanced with exponent " + to_string(exponent, 15);
  }

  template <class Backend>
  Solution solve(const Backend& backend, const Problem& problem, const Effort& effort, Monitor& monitor) const;

private:
  Balanced method_;
  Rejection rejects_;
};

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/balanced/solve_balanced_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_BALANCED_SOLVE_BALANCED_H
