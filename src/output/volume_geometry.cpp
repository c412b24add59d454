// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/volume_geometry.h"

#include "input/binary.h"
#include "input/text_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace tool {
namespace {

/// A line "key = a b c", and what GIFTI calls the three numbers.
struct Line {
  std::string_view key;
  std::array<const char*, 3> names;
};

constexpr Line lines[] = {{"volume", {"VolGeomWidth", "VolGeomHeight", "VolGeomDepth"}},
                          {"voxelsize", {"VolGeomXsize", "VolGeomYsize", "VolGeomZsize"}},
                          {"xras", {"VolGeomX_R", "VolGeomX_A", "VolGeomX_S"}},
                          {"yras", {"VolGeomY_R", "VolGeomY_A", "VolGeomY_S"}},
                          {"zras", {"VolGeomZ_R", "VolGeomZ_A", "VolGeomZ_S"}},
                          {"cras", {"VolGeomC_R", "VolGeomC_A", "VolGeomC_S"}}};

/// The three words behind "key =" in the first line that begins so; empty ones if there are not three.
std::array<std::string, 3> values_of(std::string_view text, std::string_view key)
{
  while(!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if(next_token(line) != key || next_token(line) != "=")
      continue;
    std::array<std::string, 3> values;
    for(std::string& value : values)
      value = next_token(line);
    return values;
  }
  return {};
}

const std::string* value_of(const Annotations::Metadata& metadata, std::string_view name)
{
  const auto found =
    std::find_if(metadata.begin(), metadata.end(), [=](const auto& entry) { return entry.first == name; });
  return found == metadata.end() ? nullptr : &found->second;
}

} // namespace

Annotations::Metadata gifti_points_with_geometry(const Annotations& annotations)
{
  Annotations::Metadata metadata = annotations.gifti_points;
  const std::string_view tags = annotations.freesurfer;
  const std::size_t begin = tags.find("valid = 1");
  if(begin == std::string_view::npos || value_of(metadata, lines[0].names[0]))
    return metadata;
  for(const Line& line : lines) {
    const auto values = values_of(tags.substr(begin), line.key);
    if(values.back().empty())
      return annotations.gifti_points; // not complete
    for(std::size_t k = 0; k < 3; ++k)
      metadata.emplace_back(line.names[k], values[k]);
  }
  return metadata;
}

std::string freesurfer_tags(const Annotations& annotations)
{
  if(!annotations.freesurfer.empty())
    return annotations.freesurfer;
  std::string tags;
  constexpr std::int32_t use_real_ras = 2, no = 0, surface_geometry = 20;
  for(const std::int32_t number : {use_real_ras, no, surface_geometry})
    append_number(tags, number, Byte_order::BIG);
  tags += "valid = 1  # volume info valid\nfilename = unknown\n";
  for(const Line& line : lines) {
    tags += std::string(line.key) + " =";
    for(const char* name : line.names) {
      const std::string* const value = value_of(annotations.gifti_points, name);
      if(!value)
        return "";
      tags += ' ' + *value;
    }
    tags += '\n';
  }
  return tags;
}

} // namespace tool
