// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_BINARY_H
#define SPHERICAL_PARAMETERIZATION_TOOL_BINARY_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace tool {

/// \name Numbers as bytes
/// The machine is taken to be little-endian, as all are that matter.
/// @{
enum class Byte_order { LITTLE, BIG };

/// The number that begins at `bytes`.
template <class Number>
Number number_at(const char* bytes, Byte_order order = Byte_order::LITTLE)
{
  std::array<char, sizeof(Number)> copy;
  std::memcpy(copy.data(), bytes, copy.size());
  if(order == Byte_order::BIG)
    std::reverse(copy.begin(), copy.end());
  Number number;
  std::memcpy(&number, copy.data(), copy.size());
  return number;
}

template <class Number>
void append_number(std::string& bytes, Number number, Byte_order order = Byte_order::LITTLE)
{
  std::array<char, sizeof(Number)> copy;
  std::memcpy(copy.data(), &number, copy.size());
  if(order == Byte_order::BIG)
    std::reverse(copy.begin(), copy.end());
  bytes.append(copy.data(), copy.size());
}
/// @}

/// \name Base64 (RFC 4648)
/// @{
std::string to_base64(std::string_view bytes);

/// White space is skipped. Nothing if there are other characters, or bits are missing.
std::optional<std::string> from_base64(std::string_view text);
/// @}

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_BINARY_H
