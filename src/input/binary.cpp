// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"

#include "input/text_lines.h"

#include <cstdint>
#include <limits>

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

template <class Number>
constexpr Number_type type_of(std::string_view name)
{
  using Limits = std::numeric_limits<Number>;
  return {name,
          sizeof(Number),
          Limits::is_integer,
          static_cast<double>(Limits::lowest()),
          static_cast<double>(Limits::max()),
          [](const char* bytes, Byte_order order) { return static_cast<double>(number_at<Number>(bytes, order)); }};
}

struct Names {
  Number_type type;
  std::array<std::string_view, 3> others;
};

constexpr Names number_types[] = {{type_of<std::int8_t>("char"), {"int8", "signed_char"}},
                                  {type_of<std::uint8_t>("uchar"), {"uint8", "unsigned_char"}},
                                  {type_of<std::int16_t>("short"), {"int16"}},
                                  {type_of<std::uint16_t>("ushort"), {"uint16", "unsigned_short"}},
                                  {type_of<std::int32_t>("int"), {"int32"}},
                                  {type_of<std::uint32_t>("uint"), {"uint32", "unsigned_int"}},
                                  {type_of<std::int64_t>("long"), {"int64", "vtktypeint64"}},
                                  {type_of<std::uint64_t>("ulong"), {"uint64", "unsigned_long", "vtktypeuint64"}},
                                  {type_of<float>("float"), {"float32"}},
                                  {type_of<double>("double"), {"float64"}}};

} // namespace

const Number_type* number_type(std::string_view name)
{
  const std::string word = lower_case(name);
  for(const auto& [type, others] : number_types)
    if(!word.empty() && (word == type.name || std::find(others.begin(), others.end(), word) != others.end()))
      return &type;
  return nullptr;
}

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
