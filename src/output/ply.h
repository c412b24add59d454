// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "input/mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace tool {

/// A property of vertices or faces.
struct Ply_column {
  enum class Type { UCHAR, INT, DOUBLE };
  Type type;
  std::string name;
  std::function<double(std::size_t)> value; ///< of vertex or face i; in the range of the type
};

/// What a PLY file has beside points and triangles.
struct Ply_extras {
  std::string comment; ///< one line, or empty
  std::vector<Ply_column> of_vertices;
  std::vector<Ply_column> of_faces;
};

/// The columns under names that a PLY file can have: without spaces, and each once. Colours are bytes, labels integers.
std::vector<Ply_column> ply_columns(const Vertex_data& data);

using Colour = std::array<std::uint8_t, 3>;

/// Red, green and blue of vertices or faces. The colours are kept by reference.
std::vector<Ply_column> colour_columns(const std::vector<Colour>& colours);

/// Writes a PLY file: little-endian binary, or text with the fewest digits from which the same numbers are read.
void write_ply(std::ostream& out, bool is_text, const Mesh& mesh, const std::vector<Point>& points,
               const Ply_extras& extras = {});

} // namespace tool
