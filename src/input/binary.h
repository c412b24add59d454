// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <optional>
#include <ostream>
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
  Number number;
  const auto begin = reinterpret_cast<char*>(&number);
  std::memcpy(begin, bytes, sizeof(Number));
  if(order == Byte_order::BIG)
    std::reverse(begin, begin + sizeof(Number));
  return number;
}

template <class Number>
void append_number(std::string& bytes, Number number, Byte_order order = Byte_order::LITTLE)
{
  const auto begin = reinterpret_cast<char*>(&number);
  if(order == Byte_order::BIG)
    std::reverse(begin, begin + sizeof(Number));
  bytes.append(begin, sizeof(Number));
}

/// A type of the numbers in a file; `smallest` and `largest` bound what text may say.
struct Number_type {
  std::string_view name;
  std::size_t size;
  bool is_integer;
  double smallest;
  double largest;
  double (*read)(const char* bytes, Byte_order order);
};

/// By any of the names that it has in PLY, VTK and VTP files, as in "uint8", "uchar" and "unsigned_char", in lower or
/// upper case; null if it is none.
const Number_type* number_type(std::string_view name);
/// @}

/// Writes numbers as bytes to a stream in large pieces.
class Byte_writer {
public:
  explicit Byte_writer(std::ostream& out, Byte_order order = Byte_order::LITTLE) : out_(out), order_(order) {}
  ~Byte_writer() { flush(); }
  Byte_writer(const Byte_writer&) = delete;
  Byte_writer& operator=(const Byte_writer&) = delete;

  template <class Number>
  void operator()(Number number)
  {
    append_number(bytes_, number, order_);
    if(bytes_.size() > 1 << 16)
      flush();
  }
  template <class Number, std::size_t n>
  void operator()(const std::array<Number, n>& numbers)
  {
    for(const Number number : numbers)
      (*this)(number);
  }

private:
  void flush()
  {
    out_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    bytes_.clear();
  }

  std::ostream& out_;
  Byte_order order_;
  std::string bytes_;
};

/// \name Base64 (RFC 4648)
/// @{
std::string to_base64(std::string_view bytes);

/// White space is skipped. Nothing if there are other characters, or bits are missing.
std::optional<std::string> from_base64(std::string_view text);
/// @}

} // namespace tool
