// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_FOR_EACH_INDEX_H
#define CGAL_SPHERICAL_PARAMETERIZATION_FOR_EACH_INDEX_H

#include <CGAL/Spherical_parameterization/internal/backend/execution.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

namespace CGAL::Spherical_parameterization {

/// \ingroup PkgSphericalParameterizationPolicies
/// The loop of the functions of this package on the threads of a policy, for what is done beside them, such as
/// `Spherical_locator::locate()` in many directions.
/// \tparam ExecutionPolicy  a device leaves loops to all cores; without TBB they run on the calling thread
/// \param count  a number, 0 or more
/// \param f      called as f(0) ... f(count - 1), in any order; what it throws is passed on
template <class ExecutionPolicy, class F, internal::If_policy<ExecutionPolicy> = 0>
void for_each_index(const ExecutionPolicy&, int count, F f)
{
  internal::loop_of<ExecutionPolicy>().for_each(count, [&f](int i) { f(i); });
}

} // namespace CGAL::Spherical_parameterization

#endif // CGAL_SPHERICAL_PARAMETERIZATION_FOR_EACH_INDEX_H
