// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "options/help_formatter.h"

#include <cstddef>
#include <sstream>

namespace tool {
namespace {

constexpr std::size_t line_length = 100;

/// Line breaks between words, so that no line is longer than `width` unless a word is.
std::string wrapped(const std::string& text, std::size_t width)
{
  std::istringstream words(text);
  std::string result, word;
  std::size_t length = 0;
  while(words >> word) {
    const bool fits = length + 1 + word.size() <= width;
    if(length > 0)
      result += fits ? ' ' : '\n';
    length = length > 0 && fits ? length + 1 + word.size() : word.size();
    result += word;
  }
  return result;
}

} // namespace

std::string Help_formatter::make_option_opts(const CLI::Option* option) const
{
  if(option->get_type_size() == 0) // a flag
    return "";
  // CLI11 has TYPE:CHECK of values that are checked; the check says more
  const std::string type = option->get_type_name();
  const std::size_t colon = type.find(':');
  return " " + (colon == std::string::npos ? type : type.substr(colon + 1)) +
         (option->get_expected_max() > 1 ? " ..." : "");
}

std::string Help_formatter::make_option_desc(const CLI::Option* option) const
{
  std::string text = option->get_description();
  if(!option->get_default_str().empty())
    text += " [" + option->get_default_str() + "]";
  if(option->get_required() && !option->get_positional())
    text += " (required)";
  return wrapped(text, line_length - get_column_width());
}

} // namespace tool
