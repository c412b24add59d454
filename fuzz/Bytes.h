// SPDX-License-Identifier: GPL-3.0-or-later
// Arbitrary bytes as a source of decisions.

#ifndef FUZZ_BYTES_H
#define FUZZ_BYTES_H

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

namespace fuzz {

/// Reads from the front; after the end everything is 0.
class Bytes {
public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  bool is_empty() const { return next_ == end_; }
  std::uint8_t byte() { return is_empty() ? std::uint8_t(0) : *next_++; }

  /// 0 ... n-1, n at most 65536
  std::size_t below(std::size_t n)
  {
    std::size_t value = byte();
    if(n > 256)
      value = value << 8 | byte();
    return value % n;
  }

  /// -127 ... 127, over 16
  double small() { return static_cast<std::int8_t>(byte()) / 16.; }

  /// 10^k, k in -320 ... 308
  double magnitude() { return std::pow(10., static_cast<double>(below(629)) - 320); }

  /// A small number, one of those at the ends of the range, or any eight bytes.
  double number()
  {
    typedef std::numeric_limits<double> Limits;
    const double ends[] = {0.,
                           -0.,
                           1.,
                           Limits::min(),
                           -Limits::denorm_min(),
                           1e-160,
                           1e160,
                           Limits::max(),
                           Limits::lowest(),
                           1 + Limits::epsilon(),
                           Limits::infinity(),
                           -Limits::infinity(),
                           Limits::quiet_NaN()};
    constexpr std::size_t number_of_ends = sizeof(ends) / sizeof(*ends);
    switch(byte() % 4) {
    case 0: return small();
    case 1: return ends[below(number_of_ends)];
    case 2: return small() * magnitude();
    default: {
      std::uint64_t bits = 0;
      for(int i = 0; i < 8; ++i)
        bits = bits << 8 | byte();
      double value;
      std::memcpy(&value, &bits, sizeof(value));
      return value;
    }
    }
  }

private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

} // namespace fuzz

#endif // FUZZ_BYTES_H
