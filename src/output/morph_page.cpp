// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/morph_page.h"

#include "input/binary.h"
#include "morph_html.h"

#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace tool {

void write_morph_page(std::ostream& out, const std::string& title, const Mesh& mesh,
                      const std::vector<std::vector<Point>>& frames)
{
  std::array<double, 3> low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for(const auto& points : frames)
    for(const Point& p : points)
      for(std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
  const double size = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2], 1e-300});
  std::string bytes;
  const auto add = [&bytes](long number, int length) {
    for(int byte = 0; byte < length; ++byte)
      bytes += static_cast<char>(number >> 8 * byte & 255);
  };
  for(const auto& points : frames)
    for(const Point& p : points)
      for(std::size_t k = 0; k < 3; ++k)
        add(std::lround(65535 * (0.5 + (p[k] / 2 - low[k] / 4 - high[k] / 4) * 2 / size)), 2);
  bytes.append((4 - bytes.size() % 4) % 4, '\0');
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.triangle(f))
      add(v, 4);

  const std::string name = nlohmann::json(title).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  out << morph_page_before_header()
      << "name: " << boost::replace_all_copy(name, "<", "\\u003c") // no end of the element
      << ", vertices: " << mesh.number_of_vertices() << ", faces: " << mesh.number_of_faces()
      << ", frames: " << frames.size() << morph_page_before_data() << to_base64(bytes) << morph_page_after_data();
}

} // namespace tool
