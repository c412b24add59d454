// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "collections/signature_index.h"

#include "input/files.h"
#include "output/csv.h"
#include "system/refusal.h"

#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>

namespace tool {
namespace {

constexpr std::size_t text_columns = 5;

template <class Number>
bool read_number(const std::string& text, Number& number)
{
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

std::string shortest(double number)
{
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return error == std::errc() ? std::string(buffer.data(), end) : "nan";
}

} // namespace

std::string index_header()
{
  std::string line = "name,vertices,status,map,message";
  const auto add = [&line](const char* name, std::size_t count) {
    for(std::size_t i = 0; i < count; ++i)
      line += ',' + std::string(name) + '_' + std::to_string(i);
  };
  add("girth_coarse", Shape_signature::coarse_bins);
  add("girth_fine", Shape_signature::fine_bins);
  add("limb_length", Shape_signature::limbs);
  add("limb_area", Shape_signature::limbs);
  return line;
}

std::string to_index_line(const Signature_row& row)
{
  std::string line = csv_quoted(row.name) + ',' + (row.vertices > 0 ? std::to_string(row.vertices) : "") + ',' +
                     csv_quoted(row.status) + ',' + csv_quoted(row.map) + ',' + csv_quoted(row.message);
  for(std::size_t i = 0; i < Shape_signature::size; ++i)
    line += ',' + (row.signature ? shortest(row.signature->values[i]) : "");
  return line;
}

std::optional<Signature_row> from_index_line(const std::string& line)
{
  const std::vector<std::string> field = csv_fields(line);
  if(field.size() != text_columns + Shape_signature::size)
    return std::nullopt;
  Signature_row row;
  row.name = field[0];
  row.status = field[2];
  row.map = field[3];
  row.message = field[4];
  if(row.name.empty() || row.status.empty() || (!field[1].empty() && !read_number(field[1], row.vertices)))
    return std::nullopt;
  if(row.status == "OK") {
    row.signature.emplace();
    for(std::size_t i = 0; i < Shape_signature::size; ++i)
      if(!read_number(field[text_columns + i], row.signature->values[i]) || !std::isfinite(row.signature->values[i]))
        return std::nullopt;
  }
  return row;
}

std::vector<Signature_row> read_index(const std::string& file)
{
  check_readable(file);
  std::ifstream in(file, std::ios::binary);
  const auto refuse = [&file](std::size_t line, const std::string& wrong) {
    throw Refusal(unreadable_file, file, "line " + std::to_string(line) + ' ' + wrong,
                  "write it again with the command 'signature'");
  };
  std::vector<Signature_row> rows;
  std::string text;
  for(std::size_t line = 1; std::getline(in, text); ++line) {
    if(!text.empty() && text.back() == '\r') // other programs may have written it
      text.pop_back();
    if(line == 1) {
      if(text != index_header())
        refuse(line, "is not the header of an index of signatures");
      continue;
    }
    const std::optional<Signature_row> row = from_index_line(text);
    if(!row)
      refuse(line, "is not a complete row");
    rows.push_back(*row);
  }
  if(in.bad())
    throw Refusal(unreadable_file, file, "could not be read completely", "check the disk");
  return rows;
}

} // namespace tool
