// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/compression.h"
#include "system/interruption.h"

#include <array>
#include <charconv>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace tool {

/// A field of a line of comma-separated values, in quotes where RFC 4180 asks for them, around commas, quotes and line
/// breaks; around what others take for separators, and blanks that they leave out; and where a file that begins with
/// the text would be taken for a compressed one ("BZh..."); or always.
inline std::string csv_quoted(const std::string& text, bool is_always = false)
{
  const bool has_blank = !text.empty() && (text.front() == ' ' || text.back() == ' ');
  if(!is_always && !has_blank && text.find_first_of(",\"\n\r;\t") == std::string::npos &&
     compression_of_content(text) == Compression::NONE)
    return text;
  std::string result = "\"";
  for(char c : text)
    result += c == '"' ? "\"\"" : std::string(1, c);
  return result + '"';
}

/// Number of bytes of the first character of a text in UTF-8 (RFC 3629); 0 if it is none that XML may have.
inline std::size_t size_of_character(std::string_view text)
{
  const auto byte = [text](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0; };
  const int a = byte(0), b = byte(1);
  const std::size_t size = a < 0x80 ? 1 : a < 0xc2 ? 0 : a < 0xe0 ? 2 : a < 0xf0 ? 3 : a < 0xf5 ? 4 : 0;
  for(std::size_t i = 1; i < size; ++i)
    if((byte(i) & 0xc0) != 0x80)
      return 0;
  const bool is_overlong = (a == 0xe0 && b < 0xa0) || (a == 0xf0 && b < 0x90), is_too_large = a == 0xf4 && b > 0x8f,
             is_surrogate = a == 0xed && b > 0x9f, is_none = a == 0xef && b == 0xbf && byte(2) > 0xbd;
  return is_overlong || is_too_large || is_surrogate || is_none ? 0 : size;
}

/// Text or the value of an attribute in XML, in which there are no control characters, and no bytes that are no UTF-8.
inline std::string xml_escaped(const std::string& text)
{
  std::string result;
  for(std::size_t i = 0; i < text.size();) {
    const std::size_t size = size_of_character(std::string_view(text).substr(i));
    const char c = text[i];
    if(size == 0)
      result += "\xef\xbf\xbd"; // U+FFFD, the sign for that
    else if(size > 1)
      result += text.substr(i, size);
    else
      switch(c) {
      case '&': result += "&amp;"; break;
      case '<': result += "&lt;"; break;
      case '>': result += "&gt;"; break;
      case '"': result += "&quot;"; break;
      default: result += c >= 0 && c < ' ' && c != '\n' && c != '\t' ? ' ' : c;
      }
    i += size == 0 ? 1 : size;
  }
  return result;
}

/// Writes text to a stream in large pieces, before each of which it may be interrupted. Numbers with a fraction have
/// the fewest digits from which the same number is read.
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
    if(text_.size() > 1 << 16) {
      stop_if_interrupted("output");
      flush();
    }
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
