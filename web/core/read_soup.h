// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef SPHERICAL_PARAMETERIZATION_PAGE_READ_SOUP_H
#define SPHERICAL_PARAMETERIZATION_PAGE_READ_SOUP_H

#include <array>
#include <string>
#include <vector>

namespace page {

/// A mesh as a file has it: nothing is known yet about how the faces fit together.
struct Soup {
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<int, 3>> triangles;
};

/// Reads a file that the user has dropped, with the readers of the tool. Throws a `tool::Refusal` in its words.
/// \param name         of the file; its extension says which format it is
/// \param bytes        all of it
/// \param triangulate  whether to cut polygons into fans; otherwise they are refused
Soup read_soup(const std::string& name, const std::string& bytes, bool triangulate);

} // namespace page

#endif // SPHERICAL_PARAMETERIZATION_PAGE_READ_SOUP_H
