// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_READABLE_FILE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_READABLE_FILE_H

#include <string>

namespace tool {

/// Throws a `Refusal` if the file does not exist, is not a regular file, is empty or cannot be opened.
void check_readable(const std::string& file);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_READABLE_FILE_H
