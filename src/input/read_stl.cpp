// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "input/welded_points.h"

#include <cstring>

namespace tool {
namespace {

constexpr std::size_t binary_header_size = 84; // 80 bytes of anything, then the number of triangles
constexpr std::size_t triangle_size = 50;      // normal, three corners, two bytes of anything

/// The format has no vertices, but the corners of single triangles. Solids follow on each other; they may have names,
/// and keywords may be in upper case.
class Text_stl_reader {
public:
  Text_stl_reader(const std::string& file, std::string text) : lines_(file, std::move(text)) {}

  Soup read()
  {
    while(lines_.next())
      read_line();
    if(in_solid_ || in_facet_)
      lines_.refuse_cut_short("'endsolid' is missing, there are " + std::to_string(soup_.faces) + " triangles");
    return std::move(soup_);
  }

private:
  void read_line()
  {
    const std::string keyword = lower_case(lines_.token());
    if(keyword == "facet") {
      if(in_facet_)
        refuse(triangle() + " begins before the previous one has ended");
      in_facet_ = true;
    } else if(keyword == "vertex") {
      if(!in_facet_ || corners_.size() == 3)
        refuse("a vertex outside a triangle");
      corners_.push_back(welded_.index_of(lines_.point("corner", 3 * soup_.faces + corners_.size(), soup_.non_finite)));
    } else if(keyword == "endfacet") {
      if(!in_facet_ || corners_.size() != 3)
        refuse(triangle() + " has " + std::to_string(corners_.size()) + " corners");
      soup_.add_face(corners_);
      in_facet_ = false;
      corners_.clear();
    } else if(keyword == "solid" || keyword == "endsolid") {
      if(in_facet_)
        refuse(triangle() + " has no end");
      in_solid_ = keyword == "solid";
    } else if(keyword != "outer" && keyword != "endloop")
      refuse("begins with " + in_quotes(keyword) + ", which is not a keyword of the STL format");
  }

  std::string triangle() const { return "triangle " + std::to_string(soup_.faces); }

  [[noreturn]] void refuse(const std::string& wrong) const { lines_.refuse(wrong, damaged); }

  Text_lines lines_;
  bool in_solid_ = false;
  bool in_facet_ = false;
  std::vector<int> corners_; ///< of the triangle
  Soup soup_;
  Welded_points welded_{soup_.points};
};

/// The headers of binary files may begin with 'solid', too, but either are padded with zeros or end in a count that has
/// some.
bool is_text(std::string_view bytes)
{
  const std::string_view header = bytes.substr(0, binary_header_size);
  std::string_view words = without_mark(header);
  return lower_case(next_token(words).substr(0, 5)) == "solid" && header.find('\0') == std::string_view::npos;
}

Soup read_binary_stl(const std::string& file, const std::string& bytes)
{
  if(bytes.size() < binary_header_size)
    refuse_file(file, "neither begins with 'solid' nor has the 84 bytes of a binary STL header",
                "check that this is an STL file");
  const auto triangles = number_at<std::uint32_t>(&bytes[80]);
  const std::uint64_t expected = binary_header_size + std::uint64_t(triangle_size) * triangles;
  const std::string announced =
    "the header announces " + std::to_string(triangles) + " triangles in " + std::to_string(expected) + " bytes, ";
  if(bytes.size() < expected)
    refuse_file(file, "cut short: " + announced + "the file has " + std::to_string(bytes.size()), "export it again");
  if(bytes.size() >= expected + triangle_size)
    refuse_file(file, announced + "but the file has " + std::to_string(bytes.size()));
  if(triangles > largest_count)
    refuse_file(file, "has more triangles than this program can index", "simplify the mesh");

  Soup soup;
  Welded_points welded(soup.points);
  std::vector<int> triangle;
  for(std::uint32_t t = 0; t < triangles; ++t) {
    std::array<std::array<float, 3>, 3> corners;
    std::memcpy(&corners, &bytes[binary_header_size + triangle_size * t + 12], sizeof(corners));
    for(const auto& corner : corners) {
      for(const float x : corner)
        if(!std::isfinite(x))
          soup.note_non_finite(file, "triangle " + std::to_string(t) + " has the coordinate " + std::to_string(x));
      triangle.push_back(welded.index_of({corner[0], corner[1], corner[2]}));
    }
    soup.add_face(triangle);
    triangle.clear();
  }
  return soup;
}

} // namespace

Soup read_stl(const std::string& file, std::string bytes)
{
  return is_text(bytes) ? Text_stl_reader(file, std::move(bytes)).read() : read_binary_stl(file, bytes);
}

} // namespace tool
