// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/xml.h"

#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#include <algorithm>
#include <new>

namespace tool {

void parse_xml(const std::string& file, std::string_view text, pugi::xml_document& document)
{
  const pugi::xml_parse_result result = document.load_buffer(text.data(), text.size());
  if(result.status == pugi::status_out_of_memory)
    throw std::bad_alloc();
  if(!result) {
    const auto end = text.begin() + std::min(result.offset, static_cast<std::ptrdiff_t>(text.size()));
    refuse_file(file, "line " + std::to_string(std::count(text.begin(), end, '\n') + 1) + ": " + result.description());
  }
}

pugi::xml_node child(const std::string& file, pugi::xml_node node, const char* name)
{
  const pugi::xml_node found = node.child(name);
  if(!found)
    refuse_file(file, "there is no element '" + std::string(name) + "' in '" + node.name() + "'");
  return found;
}

pugi::xml_attribute attribute(const std::string& file, pugi::xml_node node, const char* name)
{
  const pugi::xml_attribute found = node.attribute(name);
  if(!found)
    refuse_file(file, std::string("a ") + node.name() + " has no attribute '" + name + "'");
  return found;
}

std::size_t count_of(const std::string& file, pugi::xml_node node, const char* name)
{
  const std::string_view text = attribute(file, node, name).value();
  const auto value = to_integer(text);
  if(!value || *value < 0 || std::size_t(*value) > largest_count)
    refuse_file(file, std::string("a ") + node.name() + " has the " + name + ' ' + in_quotes(text));
  return static_cast<std::size_t>(*value);
}

} // namespace tool
