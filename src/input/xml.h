// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/mesh_readers.h"
#include "input/text_lines.h"

#include <pugixml.hpp>

#include <algorithm>
#include <new>
#include <string>
#include <string_view>

namespace tool {

/// Parses the text of a file. Throws a `Refusal` that names the line where it is no XML.
inline void parse_xml(const std::string& file, std::string_view text, pugi::xml_document& document)
{
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if(result.status == pugi::status_out_of_memory)
    throw std::bad_alloc();
  if(!result) {
    const auto end = text.begin() + std::min(result.offset, static_cast<std::ptrdiff_t>(text.size()));
    refuse_file(file, "line " + std::to_string(std::count(text.begin(), end, '\n') + 1) + ": " + result.description());
  }
}

/// The child of this name. Throws a `Refusal` if there is none; the same of attributes.
inline pugi::xml_node child(const std::string& file, pugi::xml_node node, const char* name)
{
  const pugi::xml_node found = node.child(name);
  if(!found)
    refuse_file(file, "there is no element '" + std::string(name) + "' in '" + node.name() + "'");
  return found;
}

inline pugi::xml_attribute attribute(const std::string& file, pugi::xml_node node, const char* name)
{
  const pugi::xml_attribute found = node.attribute(name);
  if(!found)
    refuse_file(file, std::string("a ") + node.name() + " has no attribute '" + name + "'");
  return found;
}

/// An attribute that is a count, not above `largest_count`. Throws a `Refusal`.
inline std::size_t count_of(const std::string& file, pugi::xml_node node, const char* name)
{
  const std::string_view text = attribute(file, node, name).value();
  const auto value = to_integer(text);
  if(!value || *value < 0 || std::size_t(*value) > largest_count)
    refuse_file(file, std::string("a ") + node.name() + " has the " + name + ' ' + in_quotes(text));
  return static_cast<std::size_t>(*value);
}

} // namespace tool
