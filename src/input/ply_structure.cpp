// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/ply_structure.h"

#include "input/ply_header.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace tool {
namespace {

const char* const damaged = "the file is damaged, or the counts in its header are wrong; export it again";

/// The numbers behind the header, one after the other.
class Body {
public:
  Body(const std::string& file, std::istream& in, Ply_header::Format format)
    : file_(file), in_(in), format_(format),
      bytes_left_(std::filesystem::file_size(file) - static_cast<std::uintmax_t>(in.tellg()))
  {}

  std::uintmax_t bytes_left() const { return bytes_left_; }

  /// How many bytes a number of this type takes at least: in text, a digit and a space.
  std::size_t smallest_size(const Ply_type& type) const { return format_ == Ply_header::ASCII ? 2 : type.size; }

  /// The next number, which is part of `element` number `index`.
  double next(const Ply_type& type, const Ply_element& element, std::uint64_t index)
  {
    return format_ == Ply_header::ASCII ? next_token(type, element, index) : next_bytes(type, element, index);
  }

  /// Whether there is enough behind the last number for another `bytes`.
  bool has_more(std::uintmax_t bytes)
  {
    if(format_ == Ply_header::ASCII)
      return bool(in_ >> token_);
    return bytes_left_ >= bytes;
  }

  [[noreturn]] void refuse_cut_short(const Ply_element& element, std::uint64_t index) const
  {
    throw Refusal(unreadable_file, file_,
                  "cut short: the header announces " + std::to_string(element.count) + " elements " +
                    in_quotes(element.name) + ", the file ends in number " + std::to_string(index),
                  damaged);
  }

private:
  double next_token(const Ply_type& type, const Ply_element& element, std::uint64_t index)
  {
    if(!(in_ >> token_))
      refuse_cut_short(element, index);
    const std::string name = type.name;
    double value = 0;
    const Number number = to_number(token_, value);
    if(number == Number::NONE || (type.is_integer && !to_integer(token_)))
      throw Refusal(unreadable_file, file_,
                    element.name + " " + std::to_string(index) + " has " + in_quotes(token_) + " for a value of type " +
                      name,
                    damaged);
    if(number == Number::NOT_FINITE || value < type.smallest || value > type.largest)
      throw Refusal(type.is_integer ? unreadable_file : "NON_FINITE_COORDINATE", file_,
                    element.name + " " + std::to_string(index) + " has the value " + in_quotes(token_) +
                      ", which is not finite or too large for type " + name,
                    "every value must be a finite number");
    return value;
  }

  double next_bytes(const Ply_type& type, const Ply_element& element, std::uint64_t index)
  {
    std::array<char, 8> bytes;
    if(bytes_left_ < type.size || !in_.read(bytes.data(), static_cast<std::streamsize>(type.size)))
      refuse_cut_short(element, index);
    bytes_left_ -= type.size;
    if(format_ == Ply_header::BIG_ENDIAN_BINARY) // CGAL takes the machine to be little-endian
      std::reverse(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(type.size));
    if(!type.is_integer)
      return type.size == 4 ? as<float>(bytes) : as<double>(bytes);
    switch(type.size) {
    case 1: return type.smallest < 0 ? as<std::int8_t>(bytes) : as<std::uint8_t>(bytes);
    case 2: return type.smallest < 0 ? as<std::int16_t>(bytes) : as<std::uint16_t>(bytes);
    default: return type.smallest < 0 ? as<std::int32_t>(bytes) : as<std::uint32_t>(bytes);
    }
  }

  template <class T>
  static double as(const std::array<char, 8>& bytes)
  {
    T value;
    std::memcpy(&value, bytes.data(), sizeof(value));
    return static_cast<double>(value);
  }

  std::string file_;
  std::istream& in_;
  Ply_header::Format format_;
  std::uintmax_t bytes_left_;
  std::string token_;
};

class Structure_check {
public:
  explicit Structure_check(const std::string& file)
    : file_(file), in_(file, std::ios::binary), header_(read_ply_header(file, in_)), body_(file, in_, header_.format)
  {}

  Ply_counts run()
  {
    Ply_counts counts;
    std::uintmax_t smallest_row = 1;
    for(const Ply_element& element : header_.elements) {
      smallest_row = smallest_size(element);
      if(element.count > (body_.bytes_left() + 1) / smallest_row)
        throw Refusal(unreadable_file, file_,
                      "cut short: the header announces " + std::to_string(element.count) + " elements " +
                        in_quotes(element.name) + ", more than " + std::to_string(body_.bytes_left()) +
                        " bytes can hold",
                      damaged);
      if(element.is_vertex())
        counts.vertices = element.count;
      if(element.is_face())
        counts.faces = element.count;
    }
    for(const Ply_element& element : header_.elements)
      for(std::uint64_t row = 0; row < element.count; ++row)
        for(const Ply_property& property : element.properties)
          check_property(element, row, property, counts.vertices);
    if(body_.has_more(smallest_row))
      throw Refusal(unreadable_file, file_, "has more data than the header announces",
                    "the counts in the header are wrong; export it again");
    return counts;
  }

private:
  static bool is_vertex_list(const Ply_element& element, const Ply_property& property)
  {
    return element.is_face() && (property.name == "vertex_indices" || property.name == "vertex_index");
  }

  std::uintmax_t smallest_size(const Ply_element& element) const
  {
    std::uintmax_t size = 0;
    for(const Ply_property& p : element.properties) {
      size += body_.smallest_size(p.count_type ? *p.count_type : *p.type);
      if(p.count_type && is_vertex_list(element, p))
        size += 3 * body_.smallest_size(*p.type);
    }
    return std::max<std::uintmax_t>(size, 1);
  }

  void check_property(const Ply_element& element, std::uint64_t row, const Ply_property& property, std::size_t vertices)
  {
    if(!property.count_type) {
      const double value = body_.next(*property.type, element, row);
      if(element.is_vertex() && property.name.size() == 1 && std::strchr("xyz", property.name[0]) &&
         !std::isfinite(value))
        throw Refusal("NON_FINITE_COORDINATE", file_,
                      "vertex " + std::to_string(row) + " has the coordinate " + property.name + " = " +
                        std::to_string(value),
                      "every coordinate must be a finite number");
      return;
    }
    const double length = body_.next(*property.count_type, element, row);
    if(length < 0 || length * double(body_.smallest_size(*property.type)) > double(body_.bytes_left() + 1))
      body_.refuse_cut_short(element, row);
    const bool is_face = is_vertex_list(element, property);
    if(is_face && length < 3)
      throw Refusal(unreadable_file, file_,
                    "face " + std::to_string(row) + " has only " + std::to_string(int(length)) + " vertices", damaged);
    for(double i = 0; i < length; ++i) {
      const double value = body_.next(*property.type, element, row);
      if(is_face && (value < 0 || value >= double(vertices)))
        throw Refusal(unreadable_file, file_,
                      "face " + std::to_string(row) + " has the vertex " +
                        std::to_string(static_cast<std::int64_t>(value)) + ", which is not in the range 0.." +
                        std::to_string(std::int64_t(vertices) - 1),
                      damaged);
    }
  }

  std::string file_;
  std::ifstream in_;
  Ply_header header_;
  Body body_;
};

} // namespace

Ply_counts check_ply_structure(const std::string& file) { return Structure_check(file).run(); }

} // namespace tool
