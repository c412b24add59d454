// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/binary.h"

#include <cstdint>

namespace tool {
namespace {

constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// What a character stands for; 64 for white space, 65 for what is none of the alphabet.
std::array<std::uint8_t, 256> values_of_characters()
{
  std::array<std::uint8_t, 256> value;
  value.fill(65);
  for(const char c : {' ', '\t', '\n', '\r'})
    value[static_cast<unsigned char>(c)] = 64;
  for(std::size_t i = 0; i < digits.size(); ++i)
    value[static_cast<unsigned char>(digits[i])] = static_cast<std::uint8_t>(i);
  return value;
}

} // namespace

std::string to_base64(std::string_view bytes)
{
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view group = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for(std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < group.size() ? static_cast<unsigned char>(group[k]) : 0);
    for(std::size_t k = 0; k < 4; ++k)
      text += k <= group.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

std::optional<std::string> from_base64(std::string_view text)
{
  static const std::array<std::uint8_t, 256> values = values_of_characters();
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  std::size_t number = 0; // of characters
  std::size_t padding = 0;
  for(const char c : text) {
    const std::uint8_t value = values[static_cast<unsigned char>(c)];
    if(value == 64)
      continue;
    if(c == '=') {
      ++padding;
      continue;
    }
    if(value > 63 || padding > 0)
      return std::nullopt;
    bits = bits << 6 | value;
    if(++number % 4 != 1)
      bytes += static_cast<char>(bits >> (6 - 2 * ((number - 1) % 4)) & 255);
  }
  if(number % 4 == 1 || padding > 2)
    return std::nullopt;
  return bytes;
}

} // namespace tool
