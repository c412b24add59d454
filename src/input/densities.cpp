// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/mesh_readers.h"

#include "input/files.h"
#include "input/text_lines.h"
#include "system/refusal.h"

namespace tool {

std::vector<double> read_densities(const std::string& file, std::size_t number_of_vertices, std::size_t number_of_faces)
{
  std::vector<double> density;
  Text_lines lines(file, read_file(file));
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

} // namespace tool
