// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_GUARDED_H
#define SPHERICAL_PARAMETERIZATION_TOOL_GUARDED_H

#include "system/refusal.h"

#include <functional>
#include <optional>
#include <string>

namespace tool {

/// Calls `action`, which works on the file `input`. Whatever it throws is returned as a `Refusal`.
std::optional<Refusal> guarded(const std::string& input, const std::function<void()>& action);

/// Prints the refusal, if there is one, on stderr. Returns the exit code of the program: 0 or 1.
int exit_code_of(const std::optional<Refusal>& refusal);

/// Writes what is still in the buffer of the standard output. Throws a `Refusal` if that, or anything before, could not
/// be written.
void flush_standard_output();

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_GUARDED_H
