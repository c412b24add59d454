// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_MAKE_MONITOR_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_MAKE_MONITOR_H

#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>
#include <CGAL/Spherical_parameterization/internal/api/named_parameters.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>

#include <functional>
#include <limits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

/// The monitor that the named parameters ask for.
template <class NamedParameters>
Monitor make_monitor(const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  std::function<bool(double)> callback;
  if constexpr(!parameters::is_default_parameter<NamedParameters, internal_np::callback_t>::value)
    callback = get_parameter(np, internal_np::callback);
  const double longest =
    choose_parameter(get_parameter(np, internal_np::maximum_running_time), std::numeric_limits<double>::infinity());
  CGAL_SP_PRECONDITION(longest >= 0, "maximum_running_time has to be a number that is not negative");
  return Monitor(longest, std::move(callback), choose_parameter(get_parameter(np, internal_np::verbose), false));
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_MAKE_MONITOR_H
