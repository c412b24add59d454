// SPDX-License-Identifier: LGPL-3.0-or-later
// The files of VTK, as of https://docs.vtk.org/en/latest/design_documents/VTKFileFormats.html: the older ones of text
// or bytes below lines of words (.vtk), and those of XML (.vtp, .vtu).

#include "input/binary.h"
#include "input/compression.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "input/xml.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>

namespace tool {
namespace {

/// The kinds of cells that are read, as numbered in vtkCellType.h.
enum Kind { VERTEX = 1, POLY_VERTEX, LINE, POLY_LINE, TRIANGLE, TRIANGLE_STRIP, POLYGON, PIXEL, QUAD };

/// What both have in common: a mesh, and arrays at its points.
class Vtk_mesh {
public:
  explicit Vtk_mesh(const std::string& file) : file_(file) {}

protected:
  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy = damaged) const
  {
    refuse_file(file_, wrong, remedy);
  }

  const Number_type& type(std::string_view name) const
  {
    // VTK writes its indices, of whatever size, with 32 bits
    if(const Number_type* const found = number_type(lower_case(name) == "vtkidtype" ? "int" : name))
      return *found;
    refuse("has numbers of type " + in_quotes(name), "leave that array out");
  }

  /// Of cells: whole numbers, each larger than the one before, and the first one than `before`.
  void check_offsets(const std::vector<double>& offsets, double before) const
  {
    for(double offset : offsets)
      if(!(offset > std::exchange(before, offset)) || offset != std::floor(offset) || offset > 4. * largest_count)
        refuse("has offsets of faces that are not in order");
  }

  /// Appends a corner, and with its last one the cell, if it is a face; points and lines are left out.
  void add_corner(double vertex, bool is_last, double kind)
  {
    corners_.push_back(checked_corner(file_, cells_read_, vertex, soup_.points.size()));
    if(!is_last)
      return;
    const std::size_t cell = cells_read_++, size = corners_.size();
    if(!(kind >= VERTEX && kind <= QUAD) || kind != std::floor(kind))
      refuse("cell " + std::to_string(cell) + " is no face", "save the triangles of its surface");
    if((kind >= TRIANGLE && size < 3) || (kind == TRIANGLE && size > 3) || (kind >= PIXEL && size != 4))
      refuse("face " + std::to_string(cell) + " has " + (size < 3 ? "only " : "") + std::to_string(size) + " vertices");
    if(kind == PIXEL)
      std::swap(corners_[2], corners_[3]); // row by row, not around
    if(kind == TRIANGLE_STRIP)
      soup_.add_strip(corners_);
    else if(kind >= TRIANGLE)
      soup_.add_face(corners_);
    corners_.clear();
  }

  /// A column for each component of an array, in which the components of a point are together. Normals are left out:
  /// the surface has them.
  void add_array(const std::string& name, const Number_type& type, std::size_t components,
                 const std::vector<double>& values)
  {
    if(values.empty() || (components == 3 && lower_case(name) == "normals"))
      return;
    for(std::size_t k = 0; k < components; ++k) {
      const std::string component = components == 1 ? "" : '_' + std::to_string(k);
      Vertex_column column = {(name.empty() ? "data" : name) + component, {}, type.is_integer && type.size >= 4};
      for(std::size_t i = k; i < values.size(); i += components) {
        column.values.push_back(values[i]);
        column.is_label = column.is_label && values[i] >= std::numeric_limits<int>::min() &&
                          values[i] <= std::numeric_limits<int>::max();
      }
      soup_.data.push_back(std::move(column));
    }
  }

  Soup finished()
  {
    if(soup_.faces == 0)
      refuse_point_cloud(file_, soup_.points.size());
    return std::move(soup_);
  }

  std::string file_;
  Soup soup_;

private:
  std::vector<int> corners_; ///< of the next cell
  std::size_t cells_read_ = 0;
};

class Vtk_reader : private Vtk_mesh {
public:
  Vtk_reader(const std::string& file, std::string_view bytes) : Vtk_mesh(file), rest_(bytes) {}

  Soup read()
  {
    std::string_view line = next_line();
    if(lower_case(line.substr(0, 14)) != "# vtk datafile")
      refuse("does not begin with '# vtk DataFile Version'", "check that this is a VTK file");
    for(int i = 0; i < 5; ++i)
      version_ = next_token(line);
    next_line(); // a title
    is_at_end(); // skips empty lines, which VTK does not mind
    const std::string format = lower_case(next_line());
    if(format != "ascii" && format != "binary")
      refuse("its format is " + in_quotes(format) + ", and neither ASCII nor BINARY");
    is_text_ = format == "ascii";
    while(!is_at_end()) {
      line_ = next_line();
      read_section(lower_case(next_token(line_)));
    }
    if(!ends_.empty())
      refuse("has CELLS without CELL_TYPES");
    return finished();
  }

private:
  bool is_at_end()
  {
    const std::size_t begin = rest_.find_first_not_of(" \t\r\n");
    rest_.remove_prefix(std::min(begin, rest_.size()));
    return rest_.empty();
  }

  std::string_view next_line()
  {
    std::string_view line = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    if(!line.empty() && line.back() == '\r')
      line.remove_suffix(1);
    return line;
  }

  /// The next word of the line, which is a number not below `least`.
  std::size_t next_count(std::int64_t least = 0)
  {
    const std::string_view token = next_token(line_);
    const auto count = to_integer(token);
    if(!count || *count < least || *count > 4 * std::int64_t(largest_count))
      refuse("has the count " + in_quotes(token));
    return static_cast<std::size_t>(*count);
  }

  void read_section(const std::string& keyword)
  {
    if(keyword == "dataset") {
      const std::string kind = lower_case(next_token(line_));
      if(kind != "polydata" && kind != "unstructured_grid")
        refuse("is a dataset of the kind " + in_quotes(kind), "save its surface as PolyData");
    } else if(keyword == "points")
      read_points();
    else if(keyword == "polygons" || keyword == "triangle_strips") {
      const Kind kind = keyword == "polygons" ? POLYGON : TRIANGLE_STRIP;
      read_cells([&](double x, bool is_last) { add_corner(x, is_last, kind); });
    } else if(keyword == "vertices" || keyword == "lines")
      read_cells([](double, bool) {});
    else if(keyword == "cells")
      read_cells([this](double x, bool is_last) {
        cells_.push_back(x);
        if(is_last)
          ends_.push_back(cells_.size());
      });
    else if(keyword == "cell_types")
      read_types();
    else if(keyword == "point_data" || keyword == "cell_data") {
      is_at_points_ = keyword == "point_data";
      size_ = next_count();
      if(is_at_points_ && size_ != soup_.points.size())
        refuse("has data for " + std::to_string(size_) + " points, and " + std::to_string(soup_.points.size()) +
               " points");
    } else if(keyword == "metadata")
      while(!rest_.empty() && !next_line().empty())
        continue;
    else
      read_attribute(keyword);
  }

  /// Calls `use(i, number)` for so many numbers.
  template <class Use>
  void read_numbers(const Number_type& type, std::size_t count, Use use)
  {
    if(count > (is_text_ ? (rest_.size() + 1) / 2 : rest_.size() / type.size)) // in text a digit and a space
      refuse("cut short: " + std::to_string(count) + " numbers are announced where " + std::to_string(rest_.size()) +
             " bytes are left");
    for(std::size_t i = 0; i < count; ++i) {
      use(i, is_text_ ? next_number(file_, rest_) : type.read(&rest_[i * type.size], Byte_order::BIG));
    }
    if(!is_text_)
      rest_.remove_prefix(count * type.size);
  }

  void read_points()
  {
    const std::size_t count = next_count();
    const Number_type& of_coordinates = type(next_token(line_));
    if(!soup_.points.empty() || count > rest_.size())
      refuse("has the points twice, or is cut short: " + std::to_string(count) + " points are announced");
    soup_.points.resize(count);
    read_numbers(of_coordinates, 3 * count,
                 [this](std::size_t i, double x) { soup_.set_coordinate(file_, i / 3, i % 3, x); });
  }

  /// Up to version 4 each cell as the number of its corners and the corners, from version 5 on all places where cells
  /// begin and all corners. Calls `use(corner, is_last)`.
  template <class Use>
  void read_cells(Use use)
  {
    const std::size_t first = next_count(), second = next_count();
    if(version_.compare(0, 1, "5") < 0) {
      std::int64_t left = 0;
      std::size_t cells = 0;
      read_numbers(type("int"), second, [&](std::size_t, double x) {
        if(left > 0) {
          --left;
          use(x, left == 0);
        } else if(++cells, x >= 1 && x <= double(second))
          left = std::int64_t(x);
        else
          refuse("cell " + std::to_string(cells - 1) + " has an impossible number of vertices");
      });
      if(left > 0 || cells != first)
        refuse("announces " + std::to_string(first) + " cells and has " + std::to_string(cells));
      return;
    }
    std::vector<double> begin;
    line_ = is_at_end() ? std::string_view() : next_line(); // OFFSETS vtktypeint64
    next_token(line_);
    read_numbers(type(next_token(line_)), first, [&](std::size_t, double x) { begin.push_back(x); });
    line_ = is_at_end() ? std::string_view() : next_line(); // CONNECTIVITY vtktypeint64
    next_token(line_);
    std::size_t cell = 0;
    if(begin.empty() || begin.front() != 0 || begin.back() != double(second))
      refuse("has offsets of cells that do not fit their " + std::to_string(second) + " corners");
    check_offsets(begin, -1);
    read_numbers(type(next_token(line_)), second, [&](std::size_t i, double x) {
      while(begin[cell + 1] <= double(i))
        ++cell;
      use(x, begin[cell + 1] == double(i + 1));
    });
  }

  /// Of the cells of an unstructured grid, which are read before.
  void read_types()
  {
    const std::size_t count = next_count();
    if(count != ends_.size())
      refuse("has the types of " + std::to_string(count) + " cells, and " + std::to_string(ends_.size()) + " cells");
    std::size_t corner = 0;
    read_numbers(type("int"), count, [&](std::size_t cell, double kind) {
      for(; corner < ends_[cell]; ++corner)
        add_corner(cells_[corner], corner + 1 == ends_[cell], kind);
    });
    cells_.clear();
    ends_.clear();
  }

  /// Leaves out so many texts: a line each, or bytes behind their number, whose first two bits say how long it is.
  void skip_texts(std::size_t count)
  {
    for(; count > 0; --count) {
      const std::size_t width =
        rest_.empty() || is_text_ ? 0 : std::size_t(8) >> (static_cast<unsigned char>(rest_[0]) >> 6);
      if(rest_.size() <= width)
        refuse("cut short: " + std::to_string(count) + " more texts are announced");
      if(is_text_) {
        next_line();
        continue;
      }
      std::uint64_t size = static_cast<unsigned char>(rest_[0]) & 0x3F;
      for(std::size_t i = 1; i < width; ++i)
        size = size << 8 | static_cast<unsigned char>(rest_[i]);
      rest_.remove_prefix(width);
      if(size > rest_.size())
        refuse("cut short: a text of " + std::to_string(size) + " bytes is announced");
      rest_.remove_prefix(static_cast<std::size_t>(size));
    }
  }

  void read_attribute(const std::string& keyword)
  {
    const std::string name = percent_decoded(next_token(line_));
    if(keyword == "field") {
      const std::size_t arrays = next_count();
      for(std::size_t i = 0; i < arrays; ++i) {
        while(!is_at_end() && lower_case(rest_.substr(0, 8)) == "metadata") // of the array before
          while(!next_line().empty())
            continue;
        line_ = is_at_end() ? std::string_view() : next_line();
        const std::string of_array = percent_decoded(next_token(line_));
        const std::size_t components = next_count(), tuples = next_count();
        read_array(of_array, next_token(line_), components, tuples);
      }
    } else if(keyword == "scalars") {
      const std::string_view of_numbers = next_token(line_);
      const std::size_t components = line_.find_first_not_of(' ') < line_.size() ? next_count(1) : 1;
      if(is_text_)
        is_at_end(); // which skips spaces; bytes that look like these are numbers
      if(lower_case(rest_.substr(0, 12)) == "lookup_table")
        next_line();
      read_array(name, of_numbers, components, size_);
    } else if(keyword == "color_scalars") // in text shares of 255, of a few digits
      read_array(name, is_text_ ? "float" : "uchar", next_count(), size_,
                 [this](double x) { return is_text_ ? std::round(255 * x) : x; });
    else if(keyword == "lookup_table") // colours of values
      read_numbers(type(is_text_ ? "float" : "uchar"), 4 * next_count(), [](std::size_t, double) {});
    else if(keyword == "texture_coordinates") {
      const std::size_t components = next_count();
      read_array(name, next_token(line_), components, size_);
    } else {
      static const std::map<std::string_view, std::size_t> components = {
        {"vectors", 3},    {"normals", 3},      {"tensors", 9},   {"tensors6", 6},
        {"global_ids", 1}, {"pedigree_ids", 1}, {"edge_flags", 1}};
      const auto known = components.find(keyword);
      if(known == components.end())
        refuse("has the unknown keyword " + in_quotes(keyword));
      read_array(keyword == "normals" ? keyword : name, next_token(line_), known->second, size_);
    }
  }

  /// Kept, as `value(x)`, if it is at the points, and of numbers.
  void read_array(
    const std::string& name, std::string_view type_name, std::size_t components, std::size_t tuples,
    const std::function<double(double)>& value = [](double x) { return x; })
  {
    if(components > 0 && tuples > 4 * largest_count / components)
      refuse("cut short: an array of " + std::to_string(tuples) + " rows is announced");
    if(lower_case(type_name) == "string")
      return skip_texts(components * tuples);
    const Number_type& of_numbers = type(type_name);
    std::vector<double> values;
    read_numbers(of_numbers, components * tuples, [&](std::size_t, double x) { values.push_back(value(x)); });
    if(is_at_points_ && tuples == soup_.points.size())
      add_array(name, of_numbers, components, values);
  }

  std::string_view rest_; ///< of the bytes
  std::string_view line_; ///< as far as it has not been read
  std::string version_;
  bool is_text_ = false;
  bool is_at_points_ = false;     ///< where the arrays are that follow
  std::size_t size_ = 0;          ///< of each
  std::vector<double> cells_;     ///< the corners of all cells whose types are not known yet
  std::vector<std::size_t> ends_; ///< of each among them
};

class Vtk_xml_reader : private Vtk_mesh {
public:
  Vtk_xml_reader(const std::string& file, std::string_view bytes) : Vtk_mesh(file)
  {
    // What is appended may be bytes, which are no XML.
    const std::size_t begin = std::min(bytes.find("<AppendedData"), bytes.size());
    const std::size_t end = std::min(bytes.find('>', begin), bytes.size());
    std::string text(bytes.substr(0, end));
    if(begin < bytes.size()) {
      text += "/></VTKFile>";
      const std::size_t mark = bytes.find('_', end);
      if(mark == std::string_view::npos)
        refuse("has no '_' before its appended data");
      appended_ = bytes.substr(mark + 1);
    }
    parse_xml(file, text, document_);
    root_ = child(file_, document_, "VTKFile");
    if(root_.attribute("byte_order").value() == std::string_view("BigEndian"))
      order_ = Byte_order::BIG;
    is_raw_ = root_.child("AppendedData").attribute("encoding").value() == std::string_view("raw");
  }

  Soup read()
  {
    const std::string_view dataset = root_.attribute("type").value(),
                           compressor = root_.attribute("compressor").value();
    if(dataset != "PolyData" && dataset != "UnstructuredGrid")
      refuse("is a VTK file of the type " + in_quotes(dataset), "save its surface as PolyData");
    if(!compressor.empty() && compressor != "vtkZLibDataCompressor")
      refuse("is compressed by " + in_quotes(compressor), "save it with the compressor zlib, or with none");
    const pugi::xml_node piece = child(file_, child(file_, root_, std::string(dataset).c_str()), "Piece");
    if(piece.next_sibling("Piece"))
      refuse("has several pieces", "save it as one");
    const std::size_t points = count_of(file_, piece, "NumberOfPoints");
    const std::vector<double> coordinates =
      numbers(child(file_, child(file_, piece, "Points"), "DataArray"), 3 * points);
    soup_.points.resize(points);
    for(std::size_t i = 0; i < coordinates.size(); ++i)
      soup_.set_coordinate(file_, i / 3, i % 3, coordinates[i]);
    const auto read = [&](const char* part, std::optional<Kind> kind) {
      const std::string announced = std::string("NumberOf") + part;
      if(const std::size_t cells = piece.attribute(announced.c_str()) ? count_of(file_, piece, announced.c_str()) : 0)
        read_cells(child(file_, piece, part), cells, kind);
    };
    read("Polys", POLYGON);
    read("Strips", TRIANGLE_STRIP);
    read("Cells", std::nullopt);
    for(const pugi::xml_node array : piece.child("PointData").children("DataArray")) {
      const std::size_t components = array.attribute("NumberOfComponents").as_uint(1);
      if(components > largest_count / std::max<std::size_t>(points, 1))
        refuse("has an array of " + std::to_string(components) + " components");
      if(attribute(file_, array, "type").value() == std::string_view("String")) // of older versions of VTK
        continue;
      add_array(array.attribute("Name").value(), type(attribute(file_, array, "type").value()), components,
                numbers(array, components * points));
    }
    return finished();
  }

private:
  /// Cells of one kind, or each with its own.
  void read_cells(pugi::xml_node node, std::size_t cells, std::optional<Kind> kind)
  {
    const auto array = [&](const char* name) {
      const pugi::xml_node found = node.find_child_by_attribute("DataArray", "Name", name);
      if(!found)
        refuse("has cells without an array '" + std::string(name) + "'");
      return found;
    };
    const std::vector<double> ends = numbers(array("offsets"), cells);
    check_offsets(ends, 0);
    const std::vector<double> corners = numbers(array("connectivity"), static_cast<std::size_t>(ends.back()));
    const std::vector<double> kinds = kind ? std::vector<double>(cells, *kind) : numbers(array("types"), cells);
    std::size_t cell = 0;
    for(std::size_t i = 0; i < corners.size(); ++i) {
      while(ends[cell] <= double(i))
        ++cell;
      add_corner(corners[i], ends[cell] == double(i + 1), kinds[cell]);
    }
  }

  /// The numbers of an array, of which there have to be so many.
  std::vector<double> numbers(pugi::xml_node array, std::size_t count) const
  {
    const Number_type& of_numbers = type(attribute(file_, array, "type").value());
    const std::string_view format = attribute(file_, array, "format").value();
    std::vector<double> values;
    if(format == "ascii") {
      std::string_view rest = array.child_value();
      double value = 0;
      for(std::string_view token = next_token(rest); !token.empty(); token = next_token(rest)) {
        if(to_number(token, value) == Number::NONE)
          refuse(in_quotes(token) + " stands where a number should be");
        values.push_back(value);
      }
      check_size(values.size(), count);
      return values;
    }
    if(count == 0)
      return values;
    std::string_view stream = array.child_value();
    const bool is_appended = format == "appended";
    if(is_appended)
      stream = appended_.substr(std::min<std::size_t>(array.attribute("offset").as_ullong(), appended_.size()));
    else if(format != "binary")
      refuse("has an array of the format " + in_quotes(format));
    else
      stream.remove_prefix(std::min(stream.find_first_not_of(" \t\r\n"), stream.size()));
    const std::string bytes = bytes_of(stream, is_appended && is_raw_, count * of_numbers.size);
    values.reserve(count);
    for(std::size_t i = 0; i < count; ++i)
      values.push_back(of_numbers.read(&bytes[i * of_numbers.size], order_));
    return values;
  }

  void check_size(std::uint64_t size, std::size_t announced) const
  {
    if(size != announced)
      refuse("an array has the size " + std::to_string(size) + ", where " + std::to_string(announced) +
             " is announced");
  }

  /// A block of so many bytes, which in Base64 is encoded by itself.
  std::string take(std::string_view& stream, bool is_raw, std::size_t size) const
  {
    const std::size_t letters = is_raw ? size : size / 3 * 4 + (size % 3 > 0 ? 4 : 0);
    if(letters > stream.size())
      refuse("cut short: an array of " + std::to_string(size) + " bytes is announced");
    const std::optional<std::string> bytes =
      is_raw ? std::string(stream.substr(0, letters)) : from_base64(stream.substr(0, letters));
    if(!bytes || bytes->size() < size)
      refuse("an array is no Base64 text");
    stream.remove_prefix(letters);
    return bytes->substr(0, size);
  }

  /// The bytes of an array, of which there should be `size`: behind their number, or in blocks behind the number of
  /// blocks, the size of a block and that of a last, smaller one, and the sizes of all of them when compressed.
  std::string bytes_of(std::string_view stream, bool is_raw, std::size_t size) const
  {
    const std::size_t width = root_.attribute("header_type").value() == std::string_view("UInt64") ? 8 : 4;
    const auto number = [&](const std::string& bytes, std::size_t i) -> std::uint64_t {
      return width == 8 ? number_at<std::uint64_t>(&bytes[8 * i], order_)
                        : number_at<std::uint32_t>(&bytes[4 * i], order_);
    };
    std::string_view first = stream;
    const std::uint64_t announced = number(take(first, is_raw, width), 0);
    if(!root_.attribute("compressor")) {
      check_size(announced, size);
      return take(stream, is_raw, width + size).substr(width);
    }
    if(announced > stream.size())
      refuse("cut short: an array of " + std::to_string(announced) + " compressed blocks is announced");
    const std::string header = take(stream, is_raw, (3 + announced) * width);
    std::uint64_t sum = 0;
    for(std::size_t i = 0; i < announced; ++i)
      sum += std::min<std::uint64_t>(number(header, 3 + i), stream.size() + 1);
    const std::string compressed = take(stream, is_raw, sum);
    std::string bytes;
    std::size_t at = 0;
    for(std::size_t i = 0; i < announced && bytes.size() <= size; ++i) {
      const bool is_last = i + 1 == announced && number(header, 2) > 0;
      const auto block = from_zlib(std::string_view(compressed).substr(at, number(header, 3 + i)),
                                   std::min<std::uint64_t>(number(header, is_last ? 2 : 1), size + 1));
      if(!block)
        refuse("an array cannot be decompressed to the size that it announces");
      bytes += *block;
      at += number(header, 3 + i);
    }
    check_size(bytes.size(), size);
    return bytes;
  }

  pugi::xml_document document_;
  pugi::xml_node root_;
  Byte_order order_ = Byte_order::LITTLE;
  std::string_view appended_;
  bool is_raw_ = false;
};

} // namespace

Soup read_vtk(const std::string& file, std::string bytes) { return Vtk_reader(file, bytes).read(); }

Soup read_vtk_xml(const std::string& file, std::string bytes) { return Vtk_xml_reader(file, bytes).read(); }

} // namespace tool
