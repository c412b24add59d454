// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "input/compression.h"
#include "output/text_writer.h"
#include "output/write_mesh.h"
#include "output/write_vertex_data.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

namespace tool {
namespace {

/// A name as one word of a .vtk file.
std::string encoded(const std::string& name)
{
  std::string word;
  for(const char c : name)
    if(std::isgraph(static_cast<unsigned char>(c)) && c != '%' && c != '"')
      word += c;
    else
      for(const char digit : {'%', "0123456789ABCDEF"[static_cast<unsigned char>(c) >> 4], "0123456789ABCDEF"[c & 15]})
        word += digit;
  return word;
}

/// Calls `write` with the values of a column in its type.
template <class Write>
void for_each_value(const Vertex_column& column, Write write)
{
  for(const double value : column.values)
    if(column.is_label)
      write(std::int32_t(key_of(value)));
    else
      write(value);
}

} // namespace

void write_vtk(std::ostream& out, bool is_text, const Mesh& mesh, const std::vector<Point>& points,
               const Vertex_data& data)
{
  // numbers in lines, or bytes
  const auto write = [&](auto for_each_row) {
    if(is_text) {
      Text_writer text(out);
      for_each_row([&text](const auto& row) { text(row, '\n'); });
    } else {
      Byte_writer bytes(out, Byte_order::BIG);
      for_each_row([&bytes](const auto& row) { bytes(row); });
    }
    out << '\n';
  };
  const std::size_t faces = mesh.number_of_faces();
  out << "# vtk DataFile Version 4.2\nspherical-parameterization\n"
      << (is_text ? "ASCII" : "BINARY") << "\nDATASET POLYDATA\nPOINTS " << points.size() << " double\n";
  write([&](auto row) { std::for_each(points.begin(), points.end(), row); });
  out << "POLYGONS " << faces << ' ' << 4 * faces << '\n';
  write([&](auto row) {
    for(std::size_t f = 0; f < faces; ++f) {
      const auto [a, b, c] = mesh.triangle(f);
      row(std::array<std::int32_t, 4>{3, a, b, c});
    }
  });
  if(!data.empty())
    out << "POINT_DATA " << points.size() << '\n';
  for(const Vertex_column& column : data) {
    out << "SCALARS " << encoded(column.name) << (column.is_label ? " int" : " double") << "\nLOOKUP_TABLE default\n";
    write([&](auto row) { for_each_value(column, row); });
  }
}

void write_vtp(std::ostream& out, bool is_text, const Mesh& mesh, const std::vector<Point>& points,
               const Vertex_data& data)
{
  const std::size_t faces = mesh.number_of_faces();
  // `attributes` follow type and format; numbers as text, or one compressed block in Base64 behind its sizes
  const auto write = [&](const std::string& type, const std::string& attributes, auto for_each_row) {
    out << "<DataArray type=\"" << type << "\" format=\"" << (is_text ? "ascii" : "binary") << '"' << attributes
        << ">\n";
    if(is_text) {
      Text_writer text(out);
      for_each_row([&text](const auto& row) { text(row, '\n'); });
    } else {
      std::string bytes;
      for_each_row([&bytes](const auto& row) { bytes.append(reinterpret_cast<const char*>(&row), sizeof(row)); });
      const std::string compressed = to_zlib(bytes);
      std::string header;
      for(const std::size_t number : {std::size_t(1), bytes.size(), std::size_t(0), compressed.size()})
        append_number(header, std::uint64_t(number));
      out << to_base64(header) << to_base64(compressed) << '\n';
    }
    out << "</DataArray>\n";
  };
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n<Piece NumberOfPoints=\""
      << points.size() << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" << faces
      << "\">\n<PointData>\n";
  for(const Vertex_column& column : data)
    write(column.is_label ? "Int32" : "Float64", " Name=\"" + xml_escaped(column.name) + '"',
          [&](auto row) { for_each_value(column, row); });
  out << "</PointData>\n<Points>\n";
  write("Float64", " Name=\"Points\" NumberOfComponents=\"3\"",
        [&](auto row) { std::for_each(points.begin(), points.end(), row); });
  out << "</Points>\n<Polys>\n";
  write("Int32", " Name=\"connectivity\"", [&](auto row) {
    for(std::size_t f = 0; f < faces; ++f)
      row(mesh.triangle(f));
  });
  write("Int32", " Name=\"offsets\"", [&](auto row) {
    for(std::size_t f = 0; f < faces; ++f)
      row(static_cast<std::int32_t>(3 * (f + 1)));
  });
  out << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

} // namespace tool
