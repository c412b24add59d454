// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_TOOL_PLY_HEADER_H
#define SPHERICAL_PARAMETERIZATION_TOOL_PLY_HEADER_H

#include <cstdint>
#include <istream>
#include <limits>
#include <string>
#include <vector>

namespace tool {

/// A number type of the PLY format; `smallest` and `largest` bound what a text file may say.
struct Ply_type {
  const char* name;
  const char* other_name;
  std::size_t size;
  bool is_integer;
  double smallest;
  double largest;
};

struct Ply_property {
  std::string name;
  const Ply_type* type = nullptr;       ///< of the value, or of each value of a list
  const Ply_type* count_type = nullptr; ///< of the length of a list; null if this is no list
};

struct Ply_element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Ply_property> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
  const Ply_property* find(const std::string& property) const;
};

struct Ply_header {
  enum Format { ASCII, LITTLE_ENDIAN_BINARY, BIG_ENDIAN_BINARY };
  Format format = ASCII;
  std::vector<Ply_element> elements;
};

/// Reads the header and leaves `in` at the first byte behind it. Throws a `Refusal` if `file` has none that CGAL's
/// reader would understand in the same way.
Ply_header read_ply_header(const std::string& file, std::istream& in);

} // namespace tool

#endif // SPHERICAL_PARAMETERIZATION_TOOL_PLY_HEADER_H
