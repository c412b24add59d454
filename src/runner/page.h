// SPDX-License-Identifier: GPL-3.0-or-later

#pragma once

#include "input/mesh.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace tool {

/// One HTML file that shows a mesh, and loads nothing from elsewhere: web/viewer/view.html with data, which
/// web/src/view_page.ts reads. Values follow each other in the order in which they are added.
class Page {
public:
  /// Throws a `Refusal` of a mesh with more vertices than a page has numbers for.
  static void check_size(const std::string& input, std::size_t number_of_vertices);

  nlohmann::ordered_json header;

  /// Spreads values over two bytes each. Returns what 0 stands for, and one step.
  std::pair<double, double> add(const std::vector<double>& values);
  /// The x, then the y, then the z of all points; what they stand for goes to the header.
  void add(const std::vector<Point>& points);
  /// The corners of all faces.
  void add(const Mesh& mesh);

  /// Bytes of file names that are no UTF-8 are replaced.
  void write(std::ostream& out) const;

private:
  static constexpr int bytes_of_vertex = 3;
  void add(long number, int size);
  std::string bytes_; ///< whole numbers, the lowest byte first
};

} // namespace tool
