// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_TEXT_WRITER_H
#define SPHERICAL_PARAMETERIZATION_TOOL_TEXT_WRITER_H

#include "input/compression.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace tool {

/// A field of a line of comma-separated values, in quotes where RFC 4180 asks for them, around commas, quotes and line
/// breaks, and where a file that begins with the text would be taken for a compressed one ("BZh...").
inline std::string csv_quoted(const std::string& text)
{
  if(text.find_first_of(",\"\n\r") == std::string::npos && compression_of_content(text) == Compression::NONE)
    return text;
  std::string result = "\"";
  for(char c : text)
    result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

/// Text or the value of an attribute in XML, in which there are no control characters.
inline std::string xml_escaped(const std::string& text)
{
  std::string result;
  for(const char c : text)
    switch(c) {
    case '&': result += "&amp;"; break;
    case '<': result += "&lt;"; break;
    case '>': result += "&gt;"; break;
    case '"': result += "&quot;"; break;
    default: result += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? ' ' : c;
    }
  return result;
}

/// Writes text to a stream in large pieces. Numbers with a fraction have the fewest digits from which the same number
/// is read.
class Text_writer {
public:
  explicit Text_writer(std::ostream& out) : out_(out) {}
  ~Text_writer() { flush(); }
  Text_writer(const Text_writer&) = delete;
  Text_writer& operator=(const Text_writer&) = delete;

  /// Strings, characters, numbers, and arrays of numbers, between which there are spaces.
  template <class... Parts>
  void operator()(const Parts&... parts)
  {
    (append(parts), ...);
    if(text_.size() > 1 << 16)
      flush();
  }

private:
  template <class Part>
  void append(const Part& part)
  {
    if constexpr(std::is_same_v<Part, char>)
      text_ += part;
    else if constexpr(std::is_arithmetic_v<Part>) {
      std::array<char, 32> digits;
      char* const limit = digits.data() + digits.size();
      text_.append(digits.data(), std::to_chars(digits.data(), limit, part).ptr);
    } else
      text_ += std::string_view(part);
  }
  template <class Number, std::size_t n>
  void append(const std::array<Number, n>& numbers)
  {
    for(std::size_t i = 0; i < n; ++i) {
      append(i == 0 ? "" : " ");
      append(numbers[i]);
    }
  }

  void flush()
  {
    out_ << text_;
    text_.clear();
  }

  std::ostream& out_;
  std::string text_;
};

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_TEXT_WRITER_H
