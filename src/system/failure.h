// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_FAILURE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_FAILURE_H

#include <functional>
#include <string>

namespace tool {

/// Why a command did not do what it should.
struct Failure {
  std::string code = "OK"; ///< for programs
  std::string text;        ///< for users: one line; empty if there is no failure
  std::string build_log;   ///< of OpenCL kernels that did not compile; many lines

  explicit operator bool() const { return !text.empty(); }
};

/// Calls `action`, which works on the file `input`, and catches everything that it throws.
Failure guarded(const std::string& input, const std::function<void()>& action);

/// Tells the user on stderr if there is a failure. Returns the exit code of the program: 0 or 1.
int report_failure(const Failure& failure);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_FAILURE_H
