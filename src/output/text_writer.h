// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_TEXT_WRITER_H
#define SPHERICAL_PARAMETERIZATION_TOOL_TEXT_WRITER_H

#include <array>
#include <charconv>
#include <cstddef>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace tool {

/// Writes text to a stream in large pieces. Numbers with a fraction have the 17 digits
/// that give the same number when read.
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
      if constexpr(std::is_floating_point_v<Part>)
        text_.append(digits.data(), std::to_chars(digits.data(), limit, part, std::chars_format::general, 17).ptr);
      else
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
