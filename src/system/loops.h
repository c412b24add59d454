// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_LOOPS_H
#define SPHERICAL_PARAMETERIZATION_TOOL_LOOPS_H

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>

namespace tool {

/// Calls `f(i)` for all i below n, on all cores, or in their order on this one.
template <class F>
void for_each_index(bool on_all_cores, std::size_t n, const F& f)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(on_all_cores) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n), [&f](const tbb::blocked_range<std::size_t>& range) {
      for(std::size_t i = range.begin(); i < range.end(); ++i)
        f(i);
    });
    return;
  }
#endif
  static_cast<void>(on_all_cores);
  for(std::size_t i = 0; i < n; ++i)
    f(i);
}

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_LOOPS_H
