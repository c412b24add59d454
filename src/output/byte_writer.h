// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_BYTE_WRITER_H
#define SPHERICAL_PARAMETERIZATION_TOOL_BYTE_WRITER_H

#include "input/binary.h"

#include <array>
#include <cstddef>
#include <ostream>
#include <string>

namespace tool {

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

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_BYTE_WRITER_H
