// SPDX-License-Identifier: LGPL-3.0-or-later

#include "output/write_vertex_data.h"

#include "input/compression.h"
#include "input/files.h"
#include "input/mesh_format.h"
#include "input/text_lines.h"
#include "output/text_writer.h"
#include "system/refusal.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

namespace tool {
namespace {

/// With an entry for every key: of those that have none, their number is the name.
Vertex_column with_all_keys(Vertex_column column)
{
  std::set<int> keys;
  for(const Label& label : column.table)
    keys.insert(label.key);
  for(const double value : column.values)
    if(!std::isnan(value) && keys.insert(key_of(value)).second)
      add_label(column, key_of(value), std::to_string(key_of(value)));
  return column;
}

void write_csv(std::ostream& out, const Vertex_data& data)
{
  Text_writer write(out);
  std::vector<std::map<int, std::string>> words;
  for(const Vertex_column& column : data) {
    double number = 0; // a name in quotes is none
    write(words.empty() ? "" : ",", csv_quoted(column.name, to_number(column.name, number) != Number::NONE));
    words.emplace_back();
    for(const Label& label : column.table)
      words.back()[label.key] = csv_quoted(label.name);
  }
  write('\n');
  for(std::size_t v = 0; v < data.front().values.size(); ++v)
    for(std::size_t k = 0; k < data.size(); ++k) {
      const double value = data[k].values[v];
      if(!std::isnan(value) && data[k].is_label)
        write(words[k][key_of(value)]);
      else if(!std::isnan(value))
        write(value);
      write(k + 1 < data.size() ? ',' : '\n');
    }
}

/// FreeSurfer's numbers at some vertices: those that have one. Coordinates, which the surface has, are 0.
void write_label(std::ostream& out, const std::vector<double>& values)
{
  Text_writer write(out);
  const auto missing = std::count_if(values.begin(), values.end(), [](double x) { return std::isnan(x); });
  write("#!ascii label\n", values.size() - static_cast<std::size_t>(missing), '\n');
  for(std::size_t v = 0; v < values.size(); ++v)
    if(!std::isnan(values[v]))
      write(v, " 0 0 0 ", values[v], '\n');
}

} // namespace

int key_of(double value, int none) { return std::isnan(value) ? none : static_cast<int>(value); }

std::optional<Data_format> data_format_of_name(const std::string& file)
{
  const std::filesystem::path name = std::filesystem::path(without_compression(file)).filename();
  const std::string extension = lower_case_extension(name.string());
  if(extension == ".gii") {
    const std::string kind = lower_case_extension(name.stem().string());
    return kind == ".func"    ? std::optional(Data_format::FUNC_GII)
           : kind == ".shape" ? std::optional(Data_format::SHAPE_GII)
           : kind == ".label" ? std::optional(Data_format::LABEL_GII)
                              : std::nullopt;
  }
  if(extension == ".csv")
    return Data_format::CSV;
  if(extension == ".annot")
    return Data_format::ANNOT;
  if(extension == ".label")
    return Data_format::LABEL;
  return format_of_name(file) == Mesh_format::FREESURFER ? std::optional(Data_format::CURV) : std::nullopt;
}

void write_vertex_data(std::ostream& out, const std::string& file, const Vertex_data& data,
                       const Annotations& annotations)
{
  const Data_format format = data_format_of_name(file).value();
  const bool are_labels = format == Data_format::LABEL_GII || format == Data_format::ANNOT;
  Vertex_data held;
  for(const Vertex_column& column : data)
    if(format == Data_format::CSV || column.is_label == are_labels)
      held.push_back(column.is_label ? with_all_keys(column) : column);
  const std::string what = are_labels ? "labels" : "numbers";
  if(held.empty())
    throw Refusal(unwritable_data, file, "there are no columns of " + what + " to write",
                  "give a file that has some: --data");
  const bool holds_one = format == Data_format::ANNOT || format == Data_format::LABEL || format == Data_format::CURV;
  if(holds_one && held.size() > 1)
    throw Refusal(unwritable_data, file,
                  "the format holds one column, and there are " + std::to_string(held.size()) + " of " + what,
                  std::string("write ") + (are_labels ? ".label.gii" : ".func.gii") + " or .csv");
  if(format == Data_format::CURV || format == Data_format::FUNC_GII || format == Data_format::SHAPE_GII)
    for(const Vertex_column& column : held)
      for(const double x : column.values)
        if(std::isfinite(x) && std::abs(x) > std::numeric_limits<float>::max())
          throw Refusal(unwritable_data, file, "the format holds floats, and '" + column.name + "' has larger numbers",
                        "write .csv");
  switch(format) {
  case Data_format::CSV: return write_csv(out, held);
  case Data_format::ANNOT: return write_annot(out, file, held.front());
  case Data_format::LABEL: return write_label(out, held.front().values);
  case Data_format::CURV: return write_curv(out, held.front());
  default: return write_gifti_data(out, file, held, format, annotations);
  }
}

} // namespace tool
