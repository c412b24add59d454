// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_STOPWATCH_H
#define SPHERICAL_PARAMETERIZATION_TOOL_STOPWATCH_H

#include <chrono>

namespace tool {

/// Wall-clock seconds since its construction.
class Stopwatch {
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_STOPWATCH_H
