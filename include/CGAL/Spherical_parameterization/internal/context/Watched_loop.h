// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_WATCHED_LOOP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_WATCHED_LOOP_H

#include <CGAL/Spherical_parameterization/internal/context/Monitor.h>

namespace CGAL::Spherical_parameterization::internal {

/// A loop that can be ended: `Loop`, and the monitor is asked before each step. Whatever is written for a loop so
/// observes callback and time limit. It is run from the thread of the monitor; inside of its loops the bare one is
/// used, and `check()`, which any thread may call.
template <class Loop>
class Watched_loop {
public:
  Watched_loop(const Loop& loop, Monitor& monitor) : loop_(loop), monitor_(monitor) {}

  const Loop& bare() const { return loop_; }
  Monitor& monitor() const { return monitor_; }

  /// How far the stage of the work has come. Throws Error if it has to end.
  void advance(double fraction) const { monitor_.advance_or_throw(fraction); }

  /// Throws Error if the work has to end.
  void check() const { monitor_.go_on_if(monitor_.may_go_on()); }

  /// From here on fractions are within this part of the work.
  void begin_stage(double begin, double end) const
  {
    monitor_.begin_stage(begin, end);
    advance(0);
  }

  /// Runs f(0) ... f(count-1), in any order. Throws Error if it has to end.
  template <class F>
  void for_each(int count, F f) const
  {
    loop_.for_each(count, [&](int i) {
      monitor_.go_on_if(monitor_.may_loop_go_on());
      f(i);
    });
  }

private:
  Loop loop_;
  Monitor& monitor_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CONTEXT_WATCHED_LOOP_H
