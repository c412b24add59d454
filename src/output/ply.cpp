// SPDX-License-Identifier: LGPL-3.0-or-later

#include "output/write_mesh.h"

#include "input/binary.h"
#include "output/text_writer.h"
#include "output/write_vertex_data.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <type_traits>
#include <utility>

namespace tool {
namespace {

using Columns = std::vector<Ply_column>;

const char* name(Ply_column::Type type)
{
  return type == Ply_column::Type::UCHAR ? "uchar" : type == Ply_column::Type::INT ? "int" : "double";
}

/// Calls `write` with the value as a number of the type of the column.
template <class Write>
void write_typed(const Ply_column& column, std::size_t i, Write write)
{
  const double value = column.value(i);
  switch(column.type) {
  case Ply_column::Type::UCHAR: return write(static_cast<std::uint8_t>(value));
  case Ply_column::Type::INT: return write(static_cast<std::int32_t>(value));
  case Ply_column::Type::DOUBLE: return write(value);
  }
}

void write_header(std::ostream& out, bool is_text, const Mesh& mesh, const Ply_extras& extras)
{
  const auto write_columns = [&out](const Columns& columns) {
    for(const Ply_column& column : columns)
      out << "property " << name(column.type) << ' ' << column.name << '\n';
  };
  out << "ply\nformat " << (is_text ? "ascii" : "binary_little_endian") << " 1.0\n";
  if(!extras.comment.empty())
    out << "comment " << extras.comment << '\n';
  out << "element vertex " << mesh.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  write_columns(extras.of_vertices);
  out << "element face " << mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\n";
  write_columns(extras.of_faces);
  out << "end_header\n";
}

template <class Writer>
void write_rows(std::ostream& out, const Mesh& mesh, const std::vector<Point>& points, const Ply_extras& extras)
{
  constexpr bool is_text = std::is_same_v<Writer, Text_writer>;
  Writer write(out);
  const auto write_columns = [&write](const Columns& columns, std::size_t i) {
    for(const Ply_column& column : columns)
      write_typed(column, i, [&write](auto value) {
        if constexpr(is_text)
          write(' ', +value); // + makes a number of a character
        else
          write(value);
      });
    if constexpr(is_text)
      write('\n');
  };
  for(std::size_t v = 0; v < points.size(); ++v) {
    write(points[v]);
    write_columns(extras.of_vertices, v);
  }
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    if constexpr(is_text)
      write("3 ");
    else
      write(std::uint8_t(3));
    write(mesh.triangle(f));
    write_columns(extras.of_faces, f);
  }
}

} // namespace

std::vector<Ply_column> ply_columns(const Vertex_data& data)
{
  Columns columns;
  std::set<std::string> names;
  const auto exceeds_one = [](const Vertex_column& column) {
    return std::any_of(column.values.begin(), column.values.end(), [](double x) { return x > 1; });
  };
  const auto is_of_colour = [](const std::string& name) { return name == "red" || name == "green" || name == "blue"; };
  const auto is_in_range = [](const Vertex_column& column) { // a byte can hold all values; a missing one it cannot
    return std::all_of(column.values.begin(), column.values.end(), [](double x) { return x >= 0 && x <= 255; });
  };
  bool is_brighter = false, are_in_range = true;
  for(const Vertex_column& column : data)
    if(is_of_colour(column.name)) {
      is_brighter = is_brighter || exceeds_one(column);
      are_in_range = are_in_range && is_in_range(column);
    }
  const bool are_bytes = is_brighter && are_in_range;
  for(const Vertex_column& column : data) {
    std::string name = column.name;
    for(char& c : name)
      c = std::isgraph(static_cast<unsigned char>(c)) ? c : '_';
    while(is_point_or_normal(name) || !names.insert(name).second)
      name += '_';
    const std::vector<double>& values = column.values;
    if(is_of_colour(name) ? are_bytes : name == "alpha" && exceeds_one(column) && is_in_range(column))
      columns.push_back({Ply_column::Type::UCHAR, name, [&values](std::size_t v) { return std::round(values[v]); }});
    else if(column.is_label)
      columns.push_back({Ply_column::Type::INT, name, [&values](std::size_t v) { return double(key_of(values[v])); }});
    else
      columns.push_back({Ply_column::Type::DOUBLE, name, [&values](std::size_t v) { return values[v]; }});
  }
  return columns;
}

std::vector<Ply_column> colour_columns(const std::vector<Colour>& colours)
{
  std::vector<Ply_column> columns;
  for(const auto& [k, name] : {std::pair(0, "red"), std::pair(1, "green"), std::pair(2, "blue")})
    columns.push_back(
      {Ply_column::Type::UCHAR, name, [&colours, k = std::size_t(k)](std::size_t i) { return double(colours[i][k]); }});
  return columns;
}

void write_ply(std::ostream& out, bool is_text, const Mesh& mesh, const std::vector<Point>& points,
               const Ply_extras& extras)
{
  write_header(out, is_text, mesh, extras);
  (is_text ? write_rows<Text_writer> : write_rows<Byte_writer>)(out, mesh, points, extras);
}

} // namespace tool
