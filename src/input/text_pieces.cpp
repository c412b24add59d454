// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/text_pieces.h"

#include "system/refusal.h"

#include <CGAL/Spherical_parameterization/for_each_index.h>

#include <algorithm>
#include <cstddef>

namespace tool {
std::vector<std::string_view> pieces_of(std::string_view text)
{
  constexpr std::size_t least = 1 << 19; // bytes
  std::vector<std::string_view> pieces;
  while(!text.empty()) {
    const std::size_t end = text.find('\n', least);
    pieces.push_back(text.substr(0, end == std::string_view::npos ? end : end + 1));
    text.remove_prefix(pieces.back().size());
  }
  return pieces;
}

std::vector<std::size_t> numbers_of_lines(const std::vector<std::string_view>& pieces)
{
  std::vector<std::size_t> numbers(pieces.size());
  SP::for_each_index(CGAL::Parallel_tag(), static_cast<int>(pieces.size()), [&](int i) {
    const std::string_view piece = pieces[i];
    numbers[i] =
      static_cast<std::size_t>(std::count(piece.begin(), piece.end(), '\n')) + (piece.back() != '\n' ? 1 : 0);
  });
  return numbers;
}

std::optional<Soup> read_pieces(std::size_t number, const std::function<std::optional<Soup>(std::size_t)>& read)
{
  std::vector<std::optional<Soup>> pieces(number);
  SP::for_each_index(CGAL::Parallel_tag(), static_cast<int>(number), [&](int i) {
    try {
      pieces[i] = read(i);
    } catch(const Refusal&) { // whoever reads the whole text will throw it
    }
  });
  if(!std::all_of(pieces.begin(), pieces.end(), [](const auto& piece) { return piece && !piece->non_finite; }))
    return std::nullopt;

  Soup soup;
  std::vector<std::size_t> first_point, first_triangle;
  std::size_t points = 0, triangles = 0;
  for(const auto& piece : pieces) {
    first_point.push_back(points);
    first_triangle.push_back(triangles);
    points += piece->points.size();
    triangles += piece->triangles.size();
    for(const Soup::Polygon& polygon : piece->polygons)
      soup.polygons.push_back({soup.faces + polygon.face, polygon.corners});
    soup.faces += piece->faces;
  }
  soup.points.resize(points);
  soup.triangles.resize(triangles);
  SP::for_each_index(CGAL::Parallel_tag(), static_cast<int>(number), [&](int i) {
    std::copy(pieces[i]->points.begin(), pieces[i]->points.end(), soup.points.data() + first_point[i]);
    std::copy(pieces[i]->triangles.begin(), pieces[i]->triangles.end(), soup.triangles.data() + first_triangle[i]);
    pieces[i].reset();
  });
  return soup;
}

} // namespace tool
