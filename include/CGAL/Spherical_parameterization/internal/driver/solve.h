// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/isometric/solve_isometric.h>
#include <CGAL/Spherical_parameterization/internal/balanced/solve_balanced.h>
#include <CGAL/Spherical_parameterization/internal/problem/Method_solver.h>
#include <CGAL/Spherical_parameterization/internal/problem/Problem.h>
#include <CGAL/Spherical_parameterization/internal/problem/Solution.h>
#include <CGAL/Spherical_parameterization/internal/saddle_point/solve_saddle_point.h>
#include <CGAL/Spherical_parameterization/values/methods.h>

#include <CGAL/tags.h>

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

/// Solves a problem where the policy says.
template <class Host_loop, class ExecutionPolicy, class Method>
Solution solve(const ExecutionPolicy& policy, const Method& method, const Problem& problem, const Effort& effort,
               Monitor& monitor);

/// What the compiled library has of a policy, after the word `template` or `extern template`.
#define CGAL_SP_FOR_EACH_METHOD(PREFIX, POLICY)                                                                        \
  PREFIX Solution solve<Host_loop>(const POLICY&, const Balanced&, const Problem&, const Effort&, Monitor&);           \
  PREFIX Solution solve<Host_loop>(const POLICY&, const Saddle_point&, const Problem&, const Effort&, Monitor&);       \
  PREFIX Solution solve<Host_loop>(const POLICY&, const Isometric&, const Problem&, const Effort&, Monitor&);          \
  PREFIX Solution solve<Host_loop>(const POLICY&, const Automatic&, const Problem&, const Effort&, Monitor&);

#ifdef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
CGAL_SP_FOR_EACH_METHOD(extern template, CGAL::Sequential_tag)
#ifdef CGAL_LINKED_WITH_TBB
CGAL_SP_FOR_EACH_METHOD(extern template, CGAL::Parallel_tag)
#endif
#endif

} // namespace CGAL::Spherical_parameterization::internal

#ifdef CGAL_SP_INCLUDE_CORE
#include <CGAL/Spherical_parameterization/internal/driver/solve_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DRIVER_SOLVE_H
