// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_PAGE_H
#define SPHERICAL_PARAMETERIZATION_TOOL_PAGE_H

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace tool {

constexpr int bytes_of_vertex = 3; ///< its number, in a page

/// Throws a `Refusal` of a mesh with more vertices than a page has numbers for.
void check_size_of_page(const std::string& input, std::size_t number_of_vertices);

/// JSON as text inside of an HTML element, which it does not end. Bytes of file names that are no UTF-8 are replaced.
std::string inside_of_page(const nlohmann::json& json);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_PAGE_H
