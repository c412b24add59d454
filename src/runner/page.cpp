// SPDX-License-Identifier: GPL-3.0-or-later

#include "runner/page.h"

#include "input/binary.h"
#include "system/refusal.h"
#include "view_page.h"

#include <boost/algorithm/string/replace.hpp>

#include <algorithm>
#include <cmath>

namespace tool {

void Page::check_size(const std::string& input, std::size_t number_of_vertices)
{
  constexpr std::size_t most = std::size_t(1) << 8 * bytes_of_vertex;
  if(number_of_vertices > most)
    throw Refusal(Error_code::TOO_LARGE, input,
                  "has " + std::to_string(number_of_vertices) + " vertices, and a page holds " + std::to_string(most),
                  "simplify the mesh");
}

void Page::add(long number, int size)
{
  for(int byte = 0; byte < size; ++byte)
    bytes_ += static_cast<char>(number >> 8 * byte & 255);
}

std::pair<double, double> Page::add(const std::vector<double>& values)
{
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double step = std::max(*high - *low, 1e-300) / 65535;
  for(double x : values)
    add(std::lround((x - *low) / step), 2);
  return {*low, step};
}

void Page::add(const std::vector<Point>& points)
{
  for(std::size_t k = 0; k < 3; ++k) {
    std::vector<double> coordinates;
    for(const Point& p : points)
      coordinates.push_back(p[k]);
    header["coordinates"].push_back(add(coordinates));
  }
}

void Page::add(const Mesh& mesh)
{
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(int v : mesh.triangle(f))
      add(v, bytes_of_vertex);
}

void Page::write(std::ostream& out) const
{
  // as text inside of an HTML element, which it does not end
  const std::string json = boost::replace_all_copy(
    header.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace), "<", "\\u003c");
  out << view_page_before_header() << json << view_page_before_data() << to_base64(bytes_) << view_page_after_data();
}

} // namespace tool
