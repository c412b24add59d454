// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/mesh_readers.h"

#include "input/compression.h"
#include "input/files.h"
#include "input/text_lines.h"

#include <cstdint>
#include <limits>
#include <set>

namespace tool {

std::vector<Fixed_vertex> read_fixed_vertices(const std::string& file, std::size_t number_of_vertices)
{
  const std::string remedy = "a line must be 'index x y z'";
  std::vector<Fixed_vertex> fixed;
  std::set<std::size_t> seen;
  Text_lines lines(file, decompressed(file, read_file(file)));
  while(lines.next()) {
    const std::string_view token = lines.token();
    const std::optional<std::int64_t> number = to_integer(token);
    if(!number)
      lines.refuse(in_quotes(token) + " is not a vertex index", remedy);
    if(*number < 0 || *number >= std::int64_t(number_of_vertices))
      lines.refuse("vertex " + std::to_string(*number) + " is not in 0.." + std::to_string(number_of_vertices - 1),
                   "vertices are numbered from 0 in the order of the mesh file");
    const auto index = static_cast<std::size_t>(*number);
    if(!seen.insert(index).second)
      lines.refuse("vertex " + std::to_string(index) + " is fixed twice", "list every vertex once");

    std::array<double, 3> direction;
    for(double& x : direction) {
      const std::string_view coordinate = lines.token();
      if(to_number(coordinate, x) != Number::FINITE)
        lines.refuse(coordinate.empty() ? "fewer than three coordinates"
                                        : in_quotes(coordinate) + " is not a finite number",
                     remedy);
    }
    if(!lines.token().empty())
      lines.refuse("more than four values", remedy);
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if(length == 0 || !std::isfinite(length))
      lines.refuse("the coordinates are too small or too large for a direction", "give a point near the unit sphere");
    fixed.push_back({index, {direction[0], direction[1], direction[2]}});
  }
  if(fixed.empty())
    refuse_file(file, "has no fixed vertex", remedy);
  return fixed;
}

std::vector<double> read_densities(const std::string& file, std::size_t number_of_vertices, std::size_t number_of_faces)
{
  std::vector<double> density;
  Text_lines lines(file, decompressed(file, read_file(file)));
  while(lines.next())
    for(std::string_view token = lines.token(); !token.empty(); token = lines.token()) {
      double value = 0;
      if(to_number(token, value) != Number::FINITE || !(value > 0))
        lines.refuse(in_quotes(token) + " is not a positive number", "densities are positive and finite");
      density.push_back(value);
    }
  if(density.size() != number_of_vertices && density.size() != number_of_faces)
    throw Refusal(Error_code::BAD_DENSITY, file,
                  "has " + std::to_string(density.size()) + " numbers, but the mesh has " +
                    std::to_string(number_of_vertices) + " vertices and " + std::to_string(number_of_faces) + " faces",
                  "give one number for every vertex, or for every face, in their order");
  return density;
}

std::vector<std::size_t> read_labels(const std::string& file, std::size_t number_of_faces)
{
  std::vector<std::size_t> labels;
  Text_lines lines(file, decompressed(file, read_file(file)));
  while(lines.next())
    for(std::string_view token = lines.token(); !token.empty(); token = lines.token()) {
      const std::optional<std::int64_t> label = to_integer(token);
      if(!label || *label < 0 || *label > std::numeric_limits<std::int32_t>::max())
        lines.refuse(in_quotes(token) + " is not a label", "labels are whole numbers from 0 to 2147483647");
      labels.push_back(static_cast<std::size_t>(*label));
    }
  if(labels.size() != number_of_faces)
    refuse_file(file,
                "has " + std::to_string(labels.size()) + " labels, but the mesh has " +
                  std::to_string(number_of_faces) + " faces",
                "give one label for every face, in their order, as --labels does");
  return labels;
}

} // namespace tool
