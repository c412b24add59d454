// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_CSV_H
#define SPHERICAL_PARAMETERIZATION_TOOL_CSV_H

#include <string>

namespace tool {

/// A field of a line of comma-separated values, in quotes where RFC 4180 asks for them: around commas, quotes and line
/// breaks.
std::string csv_quoted(const std::string& text);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_CSV_H
