// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/vertex_data.h"

#include "input/binary.h"
#include "input/compression.h"
#include "input/files.h"
#include "input/mesh_format.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#include <boost/algorithm/string/trim.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace tool {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Takes the numbers and words of FreeSurfer's binary files one after the other.
class Pieces {
public:
  Pieces(const std::string& file, std::string_view rest) : file_(file), rest_(rest) {}

  std::string_view bytes(std::size_t size)
  {
    if(size > rest_.size())
      refuse("cut short");
    const std::string_view piece = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return piece;
  }
  template <class Number>
  Number number()
  {
    return number_at<Number>(bytes(sizeof(Number)).data(), Byte_order::BIG);
  }
  /// A count of things of so many bytes, of which there are as many as that.
  std::size_t count(std::size_t size)
  {
    const auto n = number<std::int32_t>();
    if(n < 0 || std::size_t(n) > rest_.size() / size)
      refuse("announces " + std::to_string(n) + " entries, more than it has");
    return static_cast<std::size_t>(n);
  }
  /// With its length before and a zero behind.
  std::string word()
  {
    const std::string_view text = bytes(count(1));
    return std::string(text.substr(0, text.find('\0')));
  }
  bool is_at_end() const { return rest_.empty(); }

  [[noreturn]] void refuse(const std::string& wrong) const { refuse_file(file_, wrong); }

private:
  std::string file_;
  std::string_view rest_;
};

const char* const data_formats =
  "data are read from curv, .annot, .label, .csv and GIFTI files, and from PLY and VTK files of the surface";

Vertex_column new_column(const std::string& file, std::size_t vertices)
{
  return {name_of_column(file), std::vector<double>(vertices, none)};
}

std::size_t three_bytes(std::string_view bytes)
{
  const auto byte = [bytes](std::size_t i) { return std::size_t(std::uint8_t(bytes[i])); };
  return byte(0) << 16 | byte(1) << 8 | byte(2);
}

/// FreeSurfer's files of one number per vertex ("curv"): of floats, which begin with three bytes of ones, and the old
/// ones of hundredths.
Vertex_column read_curv(const std::string& file, std::string_view bytes)
{
  Pieces pieces(file, bytes);
  if(bytes.substr(0, 3) != "\xff\xff\xff") {
    Vertex_column column = new_column(file, three_bytes(pieces.bytes(3)));
    pieces.bytes(3); // the number of faces
    for(double& value : column.values)
      value = pieces.number<std::int16_t>() / 100.;
    return column;
  }
  pieces.bytes(3);
  const auto vertices = pieces.number<std::int32_t>();
  pieces.number<std::int32_t>(); // the number of faces, which some writers leave 0
  const auto values_per_vertex = pieces.number<std::int32_t>();
  const std::int64_t size = 15 + std::int64_t(4) * vertices;
  if(values_per_vertex != 1)
    pieces.refuse("has " + std::to_string(values_per_vertex) + " values per vertex, not one");
  if(vertices < 0 || std::int64_t(bytes.size()) != size)
    pieces.refuse("announces " + std::to_string(vertices) + " vertices in " + std::to_string(size) +
                  " bytes, and has " + std::to_string(bytes.size()) + " bytes");
  Vertex_column column = new_column(file, static_cast<std::size_t>(vertices));
  for(double& value : column.values)
    value = pieces.number<float>();
  return column;
}

/// Old files have no mark of their own, but a size that their first three bytes say.
bool is_curv(std::string_view bytes)
{
  return bytes.substr(0, 3) == "\xff\xff\xff" || (bytes.size() >= 6 && bytes.size() == 6 + 2 * three_bytes(bytes));
}

/// FreeSurfer's labels of all vertices, which are the colours of a table:
/// https://surfer.nmr.mgh.harvard.edu/fswiki/LabelsClutsAnnotationFiles
Vertex_column read_annot(const std::string& file, std::string_view bytes)
{
  Pieces pieces(file, bytes);
  Vertex_column column = new_column(file, pieces.count(8));
  column.is_label = true;
  std::vector<std::int32_t> colours(column.values.size());
  for(std::size_t i = 0; i < colours.size(); ++i) {
    const auto vertex = pieces.number<std::int32_t>();
    if(vertex < 0 || std::size_t(vertex) >= colours.size())
      pieces.refuse("has the vertex " + std::to_string(vertex) + ", which is not in the range 0.." +
                    std::to_string(std::int64_t(colours.size()) - 1));
    colours[static_cast<std::size_t>(vertex)] = pieces.number<std::int32_t>();
  }
  if(pieces.is_at_end() || pieces.number<std::int32_t>() != 1)
    refuse_file(file, "has no table of colours, by which its labels are known", "export it again with its table");
  const auto first = pieces.number<std::int32_t>(); // the number of entries, or that of the version
  if(first < 0 && first != -2)
    pieces.refuse("has a table of colours of version " + std::to_string(-std::int64_t(first)) + ", which is unknown");
  if(first < 0)
    pieces.number<std::int32_t>(); // the largest key and one
  pieces.word();                   // the file that the table was made from
  const std::int64_t entries = first < 0 ? pieces.number<std::int32_t>() : first;
  std::map<std::int32_t, int> keys; // by colours
  std::set<int> seen;
  for(std::int64_t i = 0; i < entries; ++i) {
    Label label;
    label.key = first < 0 ? pieces.number<std::int32_t>() : static_cast<int>(i);
    label.name = pieces.word();
    std::array<std::int32_t, 4> rgb;
    for(std::size_t k = 0; k < 4; ++k) {
      rgb[k] = pieces.number<std::int32_t>(); // the last one is 255 less opacity
      if(rgb[k] < 0 || rgb[k] > 255)
        pieces.refuse("has the colour " + std::to_string(rgb[k]) + ", which is not in the range 0..255");
      label.rgba[k] = static_cast<float>(k < 3 ? rgb[k] : 255 - rgb[k]) / 255;
    }
    keys.emplace(rgb[0] | rgb[1] << 8 | rgb[2] << 16, label.key);
    if(!seen.insert(label.key).second)
      pieces.refuse("has two labels of the number " + std::to_string(label.key));
    column.table.push_back(std::move(label));
  }
  for(std::size_t v = 0; v < colours.size(); ++v)
    if(const auto key = keys.find(colours[v]); key != keys.end())
      column.values[v] = key->second;
  return column;
}

/// FreeSurfer's values of some vertices, in lines of vertex, place and value.
Vertex_column read_label(const std::string& file, std::string text, std::size_t vertices)
{
  Vertex_column column = new_column(file, vertices);
  Text_lines lines(file, std::move(text));
  const auto count = lines.next() ? to_integer(lines.token()) : std::nullopt;
  if(!count || *count < 0 || !lines.token().empty())
    lines.refuse("expected the number of the lines that follow", damaged);
  std::int64_t read = 0;
  for(; lines.next(); ++read) {
    const std::string_view token = lines.token();
    const auto vertex = to_integer(token);
    if(!vertex || *vertex < 0 || *vertex >= std::int64_t(vertices))
      lines.refuse("the vertex " + in_quotes(token) + " is not in the range 0.." +
                     std::to_string(std::int64_t(vertices) - 1),
                   "give the label of this mesh");
    double& value = column.values[static_cast<std::size_t>(*vertex)];
    for(int k = 0; k < 4; ++k) // the place, and the value
      if(const std::string_view word = lines.token(); to_number(word, value) == Number::NONE)
        lines.refuse(in_quotes(word) + " is not a number", "a line must be 'vertex x y z value'");
  }
  if(read != *count)
    refuse_file(file, "announces " + std::to_string(*count) + " vertices and has " + std::to_string(read));
  return column;
}

/// Takes the fields of the next line off the text of a CSV file (RFC 4180); in quotes it may end later. Blanks around
/// what is not in quotes do not count.
std::vector<std::string> next_fields(const std::string& file, std::string_view& text)
{
  std::vector<std::string> fields(1);
  bool is_quoted = false, has_quotes = false;
  const auto end_field = [&fields, &has_quotes] {
    if(!has_quotes)
      boost::trim(fields.back());
    has_quotes = false;
  };
  std::size_t i = 0;
  const auto is_end_of_line = [&](char c) { return c == '\n' || (c == '\r' && text.substr(i + 1, 1) != "\n"); };
  for(; i < text.size() && (is_quoted || !is_end_of_line(text[i])); ++i)
    if(text[i] == '"' && is_quoted && text.substr(i + 1, 1) == "\"")
      fields.back() += text[++i];
    else if(text[i] == '"') {
      if(!has_quotes)
        boost::trim_left(fields.back());
      is_quoted = !is_quoted;
      has_quotes = true;
    } else if(text[i] == ',' && !is_quoted) {
      end_field();
      fields.emplace_back();
    } else if(is_quoted || (text[i] != '\r' && !(has_quotes && (text[i] == ' ' || text[i] == '\t'))))
      fields.back() += text[i];
  if(is_quoted)
    refuse_file(file, "a quotation mark has no end");
  end_field();
  text.remove_prefix(std::min(i + 1, text.size()));
  return fields;
}

/// Whether a word is a number, NaN and infinity included; other words with these letters, as in "information", are
/// none.
bool is_number(const std::string& word, double& value)
{
  const Number kind = to_number(word, value);
  if(kind != Number::NOT_FINITE)
    return kind == Number::FINITE;
  const std::string text = lower_case(word.substr(word[0] == '-' || word[0] == '+' ? 1 : 0));
  return text == "nan" || text == "inf" || text == "infinity" || (text[0] >= '0' && text[0] <= '9');
}

/// The columns of a CSV file below a line of names, a line per vertex. Columns of words are labels. Nothing, "NaN" and
/// "NA" are no value.
Vertex_data read_csv(const std::string& file, std::string_view text)
{
  const auto refuse = [&file](std::size_t row, const std::string& wrong, const std::string& remedy) {
    refuse_file(file, (row == 0 ? "the first line: " : "vertex " + std::to_string(row - 1) + ": ") + wrong, remedy);
  };
  text = without_mark(text);
  const std::string_view first_line = text.substr(0, text.find_first_of("\r\n"));
  const std::vector<std::string> names = next_fields(file, text);
  double value = 0;
  if(first_line.find('"') == std::string_view::npos &&
     std::all_of(names.begin(), names.end(), [&value](const std::string& name) { return is_number(name, value); }))
    refuse(0, "there are only numbers", "begin with a line of names");
  if(names.size() == 1 && first_line.find('"') == std::string_view::npos &&
     names[0].find_first_of(";\t") < names[0].size())
    refuse(0, "there is no comma between names", "separate columns by commas; the decimal point is '.'");
  if(std::find(names.begin(), names.end(), "") != names.end())
    refuse(0, "a column has no name", "name all of them, and leave out numbers of lines (pandas: index=False)");
  std::vector<std::vector<std::string>> columns(names.size());
  for(std::size_t row = 1; !text.empty(); ++row) {
    if(names.size() > 1 && text.find_first_not_of(" \t\r\n") == std::string_view::npos)
      break; // blank lines at the end
    std::vector<std::string> fields = next_fields(file, text);
    if(fields.size() != names.size())
      refuse(row,
             std::to_string(fields.size()) + " values, but the first line has " + std::to_string(names.size()) +
               " names",
             "give every vertex one value per column; the decimal point is '.'");
    for(std::size_t k = 0; k < fields.size(); ++k)
      columns[k].push_back(std::move(fields[k]));
  }
  Vertex_data data;
  for(std::size_t k = 0; k < names.size(); ++k) {
    data.push_back({names[k], std::vector<double>(columns[k].size(), none)});
    Vertex_column& column = data.back();
    const auto is_nothing = [](const std::string& word) {
      return word.empty() || word == "NA" || lower_case(word) == "nan";
    };
    for(std::size_t v = 0; v < column.values.size(); ++v)
      if(!is_nothing(columns[k][v]) && !is_number(columns[k][v], column.values[v]))
        column.is_label = true;
    std::map<std::string, int> keys;
    for(std::size_t v = 0; column.is_label && v < column.values.size(); ++v) {
      const std::string& word = columns[k][v];
      if(is_nothing(word))
        continue;
      const auto [entry, is_new] = keys.emplace(word, static_cast<int>(keys.size()) + 1);
      if(is_new)
        add_label(column, entry->second, word);
      column.values[v] = entry->second;
    }
  }
  return data;
}

/// A file that has nothing but data.
std::optional<Vertex_data> read_data(const std::string& file, std::string& bytes, std::size_t vertices)
{
  const std::string extension = lower_case_extension(without_compression(file));
  if(extension == ".csv")
    return read_csv(file, bytes);
  if(extension == ".annot")
    return Vertex_data{read_annot(file, bytes)};
  if(extension == ".label" || bytes.compare(0, 13, "#!ascii label") == 0)
    return Vertex_data{read_label(file, std::move(bytes), vertices)};
  if(is_curv(bytes))
    return Vertex_data{read_curv(file, bytes)};
  if(format_of_content(bytes, bytes.size()) == Mesh_format::GIFTI)
    return read_gifti_data(file, bytes, vertices);
  return std::nullopt;
}

} // namespace

std::string name_of_column(const std::string& file)
{
  std::string name = std::filesystem::path(without_compression(file)).filename().string();
  if(name.compare(0, 3, "lh.") == 0 || name.compare(0, 3, "rh.") == 0)
    name.erase(0, 3);
  for(const std::string extension : {".annot", ".gii", ".label", ".func", ".shape"})
    if(name.size() > extension.size() && lower_case_extension(name) == extension)
      name.resize(name.size() - extension.size());
  return name.empty() ? "data" : name;
}

Vertex_data read_vertex_data(const std::string& file, std::size_t number_of_vertices)
{
  check_readable(file);
  for(const char* extension : {".mgh", ".mgz", ".w"})
    if(lower_case_extension(file) == extension)
      refuse_file(file, "is of a format that is not read", data_formats);
  std::string bytes = decompressed(file, read_file(file));
  std::optional<Vertex_data> data = read_data(file, bytes, number_of_vertices);
  if(!data && !format_of_content(bytes, bytes.size()) && !format_of_name(file))
    refuse_file(file, "has an unknown content", data_formats);
  if(!data)
    data = read_soup(file, std::move(bytes), Coordinates::ANY).data;
  number_equal_names(*data);
  if(data->empty())
    refuse_file(file, "has no values at its vertices", data_formats);
  for(const Vertex_column& column : *data)
    if(column.values.size() != number_of_vertices)
      refuse_file(file,
                  "has values for " + std::to_string(column.values.size()) + " vertices, but the mesh has " +
                    std::to_string(number_of_vertices),
                  "give the data of this mesh");
  return std::move(*data);
}

bool is_point_or_normal(std::string_view name)
{
  return name == "x" || name == "y" || name == "z" || name == "nx" || name == "ny" || name == "nz";
}

Vertex_data carried(const Vertex_data& data, const std::vector<int>& old_vertex)
{
  Vertex_data result = data;
  for(std::size_t k = 0; k < data.size(); ++k) {
    result[k].values.clear();
    for(const int old : old_vertex)
      result[k].values.push_back(old < 0 ? none : data[k].values[static_cast<std::size_t>(old)]);
  }
  return result;
}

void number_equal_names(Vertex_data& data)
{
  std::map<std::string, int> taken; // and the last number that was tried with it
  for(Vertex_column& column : data) {
    std::string name = column.name;
    while(!taken.emplace(name, 1).second)
      name = column.name + '_' + std::to_string(++taken[column.name]);
    column.name = name;
  }
}

void add_label(Vertex_column& column, int key, const std::string& name)
{
  const auto [red, green, blue] = distinct_colour(column.table.size());
  column.table.push_back({key, name, {red / 255.F, green / 255.F, blue / 255.F, 1}});
}

std::array<double, 3> colour_of_hue(double hue)
{
  std::array<double, 3> colour;
  for(std::size_t k = 0; k < 3; ++k) {
    const double phase = std::abs(std::remainder(hue - static_cast<double>(k) / 3, 1.)); // 0 to 1/2
    colour[k] = std::clamp(2 - 6 * phase, 0., 1.);
  }
  return colour;
}

std::array<std::uint8_t, 3> distinct_colour(std::size_t i)
{
  // Hues by the golden ratio: every new one falls into the largest gap. Lightness alternates, so that hues that have
  // come close by then still differ.
  const double hue = std::fmod(0.58 + 0.61803398874989485 * static_cast<double>(i), 1.);
  const double light = i % 3 == 0 ? 0.95 : i % 3 == 1 ? 0.75 : 0.55;
  const double saturation = i % 2 == 0 ? 0.55 : 0.8;
  const std::array<double, 3> pure = colour_of_hue(hue);
  std::array<std::uint8_t, 3> colour;
  for(std::size_t k = 0; k < 3; ++k)
    colour[k] = static_cast<std::uint8_t>(std::lround(255 * light * (1 - saturation * (1 - pure[k]))));
  return colour;
}

} // namespace tool
