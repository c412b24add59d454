// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "input/compression.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "input/xml.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

namespace tool {
namespace {

/// GIFTI files as of "GIFTI Surface Data Format, version 1.0" (2011).
///
/// Not by the library giftiio: version 1.0.9 reads named files only, not bytes that were decompressed or came from a
/// pipe, and takes arrays that are cut short, or have words for numbers, for good ones.
class Gifti_reader {
public:
  Gifti_reader(const std::string& file, const std::string& text) : file_(file)
  {
    parse_xml(file, text, document_);
    root_ = child(file, document_, "GIFTI");
  }

  Soup surface()
  {
    pugi::xml_node points, triangles;
    for(const pugi::xml_node array : root_.children("DataArray")) {
      pugi::xml_node* const place = is(array, pointset) ? &points : is(array, triangle) ? &triangles : nullptr;
      if(place && *place)
        refuse("has several sets of points or of triangles", "give a surface with one set of points and triangles");
      if(place)
        *place = array;
    }
    if(!points)
      refuse("has no points (NIFTI_INTENT_POINTSET)",
             "give the surface, not data on it: its name often ends in .surf.gii");
    if(!triangles)
      throw Refusal(Error_code::EMPTY_MESH, file_, "has points, but no triangles (NIFTI_INTENT_TRIANGLE)",
                    "give the surface that belongs to them");
    read_points(points);
    read_triangles(triangles);
    soup_.annotations.gifti = metadata_of(root_);
    soup_.annotations.gifti_points = metadata_of(points);
    for(const pugi::xml_node transform : points.children("CoordinateSystemTransformMatrix"))
      soup_.annotations.gifti_transforms.push_back({transform.child_value("DataSpace"),
                                                    transform.child_value("TransformedSpace"),
                                                    transform.child_value("MatrixData")});
    const std::optional<std::vector<int>> rows = vertices_of_rows(soup_.points.size());
    for(const pugi::xml_node array : root_.children("DataArray"))
      if(is_column(array) && count_of(file_, array, "Dim0") == (rows ? rows->size() : soup_.points.size()))
        soup_.data.push_back(column(array, rows, soup_.points.size()));
    return std::move(soup_);
  }

  /// \param vertices  their number
  Vertex_data data(std::size_t vertices) const
  {
    Vertex_data data;
    const std::optional<std::vector<int>> rows = vertices_of_rows(vertices);
    for(const pugi::xml_node array : root_.children("DataArray"))
      if(is_column(array))
        data.push_back(column(array, rows, vertices));
      else if(!is(array, pointset) && !is(array, triangle) && !is(array, indices))
        refuse("has an array that is not one number per vertex (" + std::string(array.attribute("Intent").value()) +
                 ')',
               "give one array for each column");
    return data;
  }

private:
  static constexpr const char* pointset = "NIFTI_INTENT_POINTSET";
  static constexpr const char* triangle = "NIFTI_INTENT_TRIANGLE";
  static constexpr const char* indices = "NIFTI_INTENT_NODE_INDEX";

  static bool is(pugi::xml_node array, std::string_view intent) { return array.attribute("Intent").value() == intent; }

  static bool is_column(pugi::xml_node array)
  {
    const std::string_view dimensions = array.attribute("Dimensionality").value();
    return !is(array, pointset) && !is(array, triangle) && !is(array, indices) &&
           (dimensions == "1" || (dimensions == "2" && array.attribute("Dim1").value() == std::string_view("1")));
  }

  static Annotations::Metadata metadata_of(pugi::xml_node node)
  {
    Annotations::Metadata metadata;
    for(const pugi::xml_node entry : node.child("MetaData").children("MD"))
      metadata.emplace_back(entry.child_value("Name"), entry.child_value("Value"));
    return metadata;
  }

  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy = damaged) const
  {
    refuse_file(file_, wrong, remedy);
  }

  /// How many rows of three a set has.
  std::size_t number_of_rows(pugi::xml_node array) const
  {
    if(attribute(file_, array, "Dimensionality").value() != std::string_view("2") ||
       count_of(file_, array, "Dim1") != 3)
      refuse("points or triangles are not an array of rows of three");
    return count_of(file_, array, "Dim0");
  }

  /// The programs of before the standard wrote the names that its words have in C.
  std::string_view encoding_of(pugi::xml_node array) const
  {
    const std::string_view encoding = attribute(file_, array, "Encoding").value();
    return encoding == "GIFTI_ENCODING_ASCII"    ? "ASCII"
           : encoding == "GIFTI_ENCODING_B64BIN" ? "Base64Binary"
           : encoding == "GIFTI_ENCODING_B64GZ"  ? "GZipBase64Binary"
           : encoding == "GIFTI_ENCODING_EXTBIN" ? "ExternalFileBinary"
                                                 : encoding;
  }

  /// The numbers of a set by row and column, whatever type and encoding they have.
  /// `use(row, column, value)` is called for each.
  template <class Use>
  void read_numbers(pugi::xml_node array, std::size_t rows, std::size_t columns, Use use) const
  {
    const std::string_view type_name = attribute(file_, array, "DataType").value(), prefix = "NIFTI_TYPE_";
    const std::string_view encoding = encoding_of(array), text = array.child_value("Data");
    const Number_type* const type =
      type_name.substr(0, prefix.size()) == prefix ? number_type(type_name.substr(prefix.size())) : nullptr;
    if(!type)
      refuse("a DataArray has numbers of type " + in_quotes(type_name), "save it with 32-bit floats and integers");
    if(encoding == "ExternalFileBinary")
      refuse("has its numbers in another file", "convert it to one file, as with gifti_tool -encoding B64GZ");
    if(encoding != "ASCII" && encoding != "Base64Binary" && encoding != "GZipBase64Binary")
      refuse("a DataArray has the encoding " + in_quotes(encoding));
    const std::size_t count = columns * rows;
    // in text a digit and a space; Base64 has three bytes in four letters, and zlib unfolds to 1032 times at most
    const bool fits = encoding == "ASCII"          ? 2 * count <= text.size() + 1
                      : encoding == "Base64Binary" ? count * type->size <= text.size()
                                                   : count * type->size <= 1032 * text.size();
    if(!fits)
      refuse("cut short: a DataArray announces " + std::to_string(rows) + " rows, more than its " +
             std::to_string(text.size()) + " letters can hold");

    const std::string_view indexing = attribute(file_, array, "ArrayIndexingOrder").value();
    const bool is_column_major = indexing == "ColumnMajorOrder" || indexing == "GIFTI_IND_ORD_COL_MAJOR";
    if(!is_column_major && indexing != "RowMajorOrder" && indexing != "GIFTI_IND_ORD_ROW_MAJOR")
      refuse("a DataArray has the order of indices " + in_quotes(indexing));
    const auto put = [&](std::size_t i, double value) {
      is_column_major ? use(i % rows, i / rows, value) : use(i / columns, i % columns, value);
    };
    if(encoding == "ASCII") {
      std::string_view rest = text;
      for(std::size_t i = 0; i < count; ++i) {
        const std::string_view token = next_token(rest);
        double value = 0;
        if(to_number(token, value) == Number::NONE)
          refuse("number " + std::to_string(i) + " of a DataArray is " + in_quotes(token));
        put(i, value);
      }
      if(!next_token(rest).empty())
        refuse("a DataArray has more numbers than the " + std::to_string(count) + " that it announces");
      return;
    }
    std::optional<std::string> bytes = from_base64(text);
    if(!bytes)
      refuse("a DataArray is no Base64 text");
    if(encoding == "GZipBase64Binary") {
      bytes = from_zlib(*bytes, count * type->size);
      if(!bytes)
        refuse("a DataArray cannot be decompressed to the size that it announces");
    }
    if(bytes->size() != count * type->size)
      refuse("a DataArray announces " + std::to_string(count * type->size) + " bytes and has " +
             std::to_string(bytes->size()));
    const std::string_view endian = array.attribute("Endian").value();
    const Byte_order order =
      endian == "BigEndian" || endian == "GIFTI_ENDIAN_BIG" ? Byte_order::BIG : Byte_order::LITTLE;
    for(std::size_t i = 0; i < count; ++i)
      put(i, type->read(&(*bytes)[i * type->size], order));
  }

  void read_points(pugi::xml_node array)
  {
    soup_.points.resize(number_of_rows(array));
    read_numbers(array, soup_.points.size(), 3, [this](std::size_t row, std::size_t column, double x) {
      soup_.set_coordinate(file_, row, column, x);
    });
  }

  void read_triangles(pugi::xml_node array)
  {
    soup_.triangles.resize(number_of_rows(array));
    soup_.faces = soup_.triangles.size();
    if(soup_.faces == 0)
      refuse_point_cloud(file_, soup_.points.size());
    read_numbers(array, soup_.faces, 3, [&](std::size_t row, std::size_t column, double corner) {
      soup_.triangles[row][column] = checked_corner(file_, row, corner, soup_.points.size());
    });
  }

  /// The vertex of each row of the columns, where there is an array of these.
  std::optional<std::vector<int>> vertices_of_rows(std::size_t vertices) const
  {
    const auto arrays = root_.children("DataArray");
    const auto array = std::find_if(arrays.begin(), arrays.end(), [](pugi::xml_node a) { return is(a, indices); });
    if(array == arrays.end())
      return std::nullopt;
    std::vector<int> result;
    std::vector<bool> is_known(vertices, false);
    read_numbers(*array, count_of(file_, *array, "Dim0"), 1, [&](std::size_t, std::size_t, double value) {
      if(!is_key(value) || value < 0 || value >= static_cast<double>(vertices) || is_known[place(value)])
        refuse("has the values of vertex " + std::to_string(value) + ", which does not exist or is there twice",
               "give the data of this mesh");
      is_known[place(value)] = true;
      result.push_back(static_cast<int>(value));
    });
    return result;
  }

  /// \param vertex_of_row  if rows are not in the order of the vertices; others have no value
  Vertex_column column(pugi::xml_node array, const std::optional<std::vector<int>>& vertex_of_row,
                       std::size_t vertices) const
  {
    Vertex_column column = {name_of_column(file_), {}, is(array, "NIFTI_INTENT_LABEL")};
    for(const auto& [name, value] : metadata_of(array))
      if(name == "Name" && !value.empty())
        column.name = value;
    const std::size_t rows = count_of(file_, array, "Dim0");
    if(column.is_label)
      column.table = table();
    std::set<double> keys;
    for(const Label& label : column.table)
      keys.insert(label.key);
    read_numbers(array, rows, 1, [&](std::size_t, std::size_t, double value) {
      if(column.is_label && !is_key(value))
        refuse("a label has the key " + std::to_string(value), "save its keys as integers");
      column.values.push_back(keys.empty() || keys.count(value) > 0 ? value : std::nan(""));
    });
    if(!vertex_of_row)
      return column;
    if(vertex_of_row->size() != column.values.size())
      refuse("has " + std::to_string(column.values.size()) + " values in a column for " +
             std::to_string(vertex_of_row->size()) + " vertices");
    std::vector<double> values(vertices, std::nan(""));
    for(std::size_t i = 0; i < vertex_of_row->size(); ++i)
      values[place((*vertex_of_row)[i])] = column.values[i];
    column.values = std::move(values);
    return column;
  }

  static std::size_t place(double vertex) { return static_cast<std::size_t>(vertex); }

  static bool is_key(double value)
  {
    using Limits = std::numeric_limits<int>;
    return value >= Limits::min() && value <= Limits::max() && value == std::floor(value);
  }

  std::vector<Label> table() const
  {
    std::vector<Label> table;
    std::set<int> keys;
    for(const pugi::xml_node node : root_.child("LabelTable").children("Label")) {
      const std::string_view text = node.attribute(node.attribute("Key") ? "Key" : "Index").value(); // in old files
      const auto key = to_integer(text);
      if(!key || !is_key(static_cast<double>(*key)) || !keys.insert(static_cast<int>(*key)).second)
        refuse("has a label with the key " + in_quotes(text), "give every label an integer of its own");
      Label label = {static_cast<int>(*key), node.child_value()};
      const std::array<const char*, 4> channels = {"Red", "Green", "Blue", "Alpha"};
      for(std::size_t k = 0; k < 4; ++k) {
        to_number(node.attribute(channels[k]).value(), label.rgba[k]); // whatever the decimal point of the host
        label.rgba[k] = std::fmin(1.F, std::fmax(0.F, label.rgba[k]));
      }
      table.push_back(std::move(label));
    }
    return table;
  }

  std::string file_;
  pugi::xml_document document_;
  pugi::xml_node root_;
  Soup soup_;
};

} // namespace

Soup read_gifti(const std::string& file, std::string text) { return Gifti_reader(file, text).surface(); }

Vertex_data read_gifti_data(const std::string& file, const std::string& text, std::size_t number_of_vertices)
{
  return Gifti_reader(file, text).data(number_of_vertices);
}

} // namespace tool
