// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/mesh_readers.h"
#include "input/text_lines.h"

#include <cstdint>

namespace tool {
namespace {

/// The polygons that programs of the Montreal Neurological Institute (CIVET) write as text, with the extension .obj:
/// "P", five numbers of the material, the number of points, the points, their normals, the number of polygons, colours,
/// where each polygon ends among all corners, and the corners.
class Mni_reader {
public:
  Mni_reader(const std::string& file, std::string_view text) : file_(file), rest_(text) {}

  Soup read()
  {
    rest_ = without_mark(rest_);
    if(next_token(rest_) != "P")
      refuse_file(file_, "does not begin with 'P'", "check that this is a file of polygons");
    skip(5);
    Soup soup;
    soup.points.resize(next_count("points", 6));
    for(std::size_t v = 0; v < soup.points.size(); ++v)
      for(std::size_t k = 0; k < 3; ++k)
        soup.set_coordinate(file_, v, k, next_number(file_, rest_));
    skip(3 * soup.points.size());
    const std::size_t polygons = next_count("polygons", 1);
    if(polygons == 0)
      refuse_point_cloud(file_, soup.points.size());
    const int colours = next_integer(); // one for all, one for each polygon, one for each point
    if(colours < 0 || colours > 2)
      refuse_file(file_, "has the number " + std::to_string(colours) + " where colours are announced by 0, 1 or 2");
    skip(4 * (colours == 0 ? 1 : colours == 1 ? polygons : soup.points.size()));

    std::vector<int> ends(polygons), corners;
    for(int& end : ends)
      end = next_integer();
    int begin = 0;
    for(const int end : ends) {
      if(end - std::int64_t(begin) < 3)
        refuse_file(file_, "polygon " + std::to_string(soup.faces) + " has fewer than three corners");
      for(corners.clear(); begin < end; ++begin)
        corners.push_back(checked_corner(file_, soup.faces, next_integer(), soup.points.size()));
      soup.add_face(corners);
    }
    if(!next_token(rest_).empty())
      refuse_file(file_, "has more behind its polygons", "save the surface alone");
    return soup;
  }

private:
  int next_integer()
  {
    const std::string_view token = next_token(rest_);
    const auto value = to_integer(token);
    if(!value || *value != static_cast<int>(*value))
      refuse_file(file_, token.empty() ? "cut short" : in_quotes(token) + " stands where a number should be");
    return static_cast<int>(*value);
  }

  void skip(std::size_t numbers)
  {
    for(; numbers > 0; --numbers)
      next_number(file_, rest_);
  }

  /// How many there are, each of which has so many numbers at least: a digit and a space each.
  std::size_t next_count(const std::string& what, std::size_t numbers)
  {
    const std::string_view token = next_token(rest_);
    const auto count = to_integer(token);
    if(!count || *count < 0 || std::size_t(*count) > rest_.size() / (2 * numbers))
      refuse_file(file_, "announces " + in_quotes(token) + ' ' + what + " where " + std::to_string(rest_.size()) +
                           " bytes are left");
    return static_cast<std::size_t>(*count);
  }

  std::string file_;
  std::string_view rest_;
};

} // namespace

Soup read_mni(const std::string& file, std::string text) { return Mni_reader(file, text).read(); }

} // namespace tool
