// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#pragma once

#include <pugixml.hpp>

#include <string>
#include <string_view>

namespace tool {

/// Parses the text of a file. Throws a `Refusal` that names the line where it is no XML.
void parse_xml(const std::string& file, std::string_view text, pugi::xml_document& document);

/// The child of this name. Throws a `Refusal` if there is none; the same of attributes.
pugi::xml_node child(const std::string& file, pugi::xml_node node, const char* name);
pugi::xml_attribute attribute(const std::string& file, pugi::xml_node node, const char* name);

/// An attribute that is a count, not above `largest_count`. Throws a `Refusal`.
std::size_t count_of(const std::string& file, pugi::xml_node node, const char* name);

} // namespace tool
