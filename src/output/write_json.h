// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_WRITE_JSON_H
#define SPHERICAL_PARAMETERIZATION_TOOL_WRITE_JSON_H

#include <nlohmann/json.hpp>

#include <ostream>

namespace tool {

/// Writes a file for people and programs: indented, with a line end. Bytes of file names that are no UTF-8 are
/// replaced.
inline void write_json(std::ostream& out, const nlohmann::ordered_json& json)
{
  out << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
}

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_WRITE_JSON_H
