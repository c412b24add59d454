// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_CSV_H
#define SPHERICAL_PARAMETERIZATION_TOOL_CSV_H

#include <string>
#include <vector>

namespace tool {

/// A field of a line of comma-separated values, in quotes where RFC 4180 asks for them: around commas, quotes and line
/// breaks. `csv_fields()` reads lines without line breaks in their fields.
std::string csv_quoted(const std::string& text);

/// The fields of a line; none if a quote is left open.
std::vector<std::string> csv_fields(const std::string& line);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_CSV_H
