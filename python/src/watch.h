// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "arrays.h"

#include <CGAL/Named_function_parameters.h>

#include <chrono>
#include <functional>

/// The callback of a call: asks Python now and then whether to go on.
struct Watch {
  py::object progress = py::none(); ///< or a callable
  bool was_ctrl_c = false;
  std::chrono::steady_clock::time_point last = {}; ///< long ago: the first call asks

  bool operator()(double fraction)
  {
    constexpr std::chrono::milliseconds interval(50); // the lock may be some way off
    const bool is_last = fraction >= 1;
    if((is_last && progress.is_none()) || (!is_last && std::chrono::steady_clock::now() - last < interval))
      return true;
    const py::gil_scoped_acquire lock;
    try {
      if(PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      const bool is_stopped = !progress.is_none() && progress(fraction).is(py::bool_(false));
      last = std::chrono::steady_clock::now();
      return !is_stopped;
    } catch(py::error_already_set& error) {
      if(!error.matches(PyExc_KeyboardInterrupt))
        throw;
      was_ctrl_c = true;
      return false;
    }
  }
};

/// Calls f(policy, np) as on() does, with named parameters by which Ctrl-C ends it with a KeyboardInterrupt.
template <class F>
auto on_watched(const std::string& policy, F f)
{
  Watch watch;
  try {
    return on(policy, [&](const auto& p) { return f(p, CGAL::parameters::callback(std::ref(watch))); });
  } catch(const SP::Error&) {
    if(!watch.was_ctrl_c)
      throw;
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw py::error_already_set();
  }
}
