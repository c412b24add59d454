// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_STANDARD_OUTPUT_H
#define SPHERICAL_PARAMETERIZATION_TOOL_STANDARD_OUTPUT_H

namespace tool {

/// Writes what is still in the buffer of the standard output. Throws a `Refusal` if that, or anything before, could not
/// be written.
void flush_standard_output();

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_STANDARD_OUTPUT_H
