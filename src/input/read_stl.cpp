// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/checked_lines.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#include <CGAL/IO/STL.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <istream>

namespace tool {
namespace {

constexpr std::uintmax_t binary_header_size = 84; // 80 bytes of anything, then the number of triangles
constexpr std::uintmax_t triangle_size = 50;      // normal, three corners, two bytes of anything

/// The triangles of a text STL file as one solid, in lower case and without names, which might contain keywords.
class Stl_lines {
public:
  explicit Stl_lines(const std::string& file) : file_(file), lines_(file) {}

  bool operator()(std::string& out)
  {
    if(state_ == State::BEFORE) {
      state_ = State::INSIDE;
      out = "solid\n";
      return true;
    }
    while(out.empty() && state_ == State::INSIDE) {
      if(!lines_.next()) {
        end_of_file();
        out = "endsolid\n";
      } else
        read_line(out);
    }
    return !out.empty();
  }

private:
  enum class State { BEFORE, INSIDE, AFTER };

  void read_line(std::string& out)
  {
    Tokens tokens(lines_.text());
    std::string keyword(tokens.next());
    std::transform(keyword.begin(), keyword.end(), keyword.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::string name = "triangle " + std::to_string(triangles_);
    if(keyword == "facet") {
      if(in_facet_)
        lines_.refuse(name + " begins before the previous one has ended", remedy_);
      in_facet_ = true;
      out = "facet normal 0 0 0 outer loop\n";
    } else if(keyword == "vertex") {
      if(!in_facet_ || corners_ == 3)
        lines_.refuse("a vertex outside a triangle", remedy_);
      out = "vertex ";
      lines_.append_point(tokens, "corner", 3 * triangles_ + corners_, out);
      ++corners_;
    } else if(keyword == "endfacet") {
      if(!in_facet_ || corners_ != 3)
        lines_.refuse(name + " has " + std::to_string(corners_) + " corners", remedy_);
      in_facet_ = false;
      corners_ = 0;
      ++triangles_;
      out = "endloop endfacet\n";
    } else if(keyword == "solid" || keyword == "endsolid") {
      if(in_facet_)
        lines_.refuse(name + " has no end", remedy_);
      in_solid_ = keyword == "solid";
    } else if(keyword != "outer" && keyword != "endloop")
      lines_.refuse("begins with " + in_quotes(keyword) + ", which is not a keyword of the STL format", remedy_);
  }

  void end_of_file()
  {
    state_ = State::AFTER;
    if(in_solid_ || in_facet_)
      lines_.refuse_cut_short("'endsolid' is missing, there are " + std::to_string(triangles_) + " triangles");
  }

  const std::string remedy_ = "the file is damaged; export it again";
  std::string file_;
  Text_lines lines_;
  State state_ = State::BEFORE;
  bool in_solid_ = false;
  bool in_facet_ = false;
  std::size_t corners_ = 0;
  std::size_t triangles_ = 0;
};

/// Finds out whether a file is binary, and if so checks its size and its coordinates.
bool is_checked_binary(const std::string& file)
{
  std::ifstream in(file, std::ios::binary);
  char header[binary_header_size] = {};
  in.read(header, sizeof(header));
  const char* const end = header + in.gcount();
  const std::uintmax_t size = std::filesystem::file_size(file);

  // the headers of binary files may begin with 'solid', too, but either are padded with zeros or end in a count that
  // has some
  const char* first = std::find_if<const char*>(header, end, [](unsigned char c) { return !std::isspace(c); });
  std::string word(first, std::min(first + 5, end));
  for(char& c : word)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if(word == "solid" && std::find<const char*>(header, end, '\0') == end)
    return false;

  std::uint32_t triangles = 0; // STL is little-endian, as CGAL takes it to be
  std::memcpy(&triangles, header + 80, sizeof(triangles));
  const std::uintmax_t expected = binary_header_size + triangle_size * triangles;
  if(size < binary_header_size)
    throw Refusal(unreadable_file, file, "neither begins with 'solid' nor has the 84 bytes of a binary STL header",
                  "check that this is an STL file");
  if(size < expected)
    throw Refusal(unreadable_file, file,
                  "cut short: the header announces " + std::to_string(triangles) + " triangles in " +
                    std::to_string(expected) + " bytes, the file has " + std::to_string(size),
                  "export it again");
  if(size >= expected + triangle_size)
    throw Refusal(unreadable_file, file,
                  "the header announces " + std::to_string(triangles) + " triangles in " + std::to_string(expected) +
                    " bytes, but the file has " + std::to_string(size),
                  "the file is damaged; export it again");
  if(triangles > largest_count)
    throw Refusal(unreadable_file, file, "has more triangles than this program can index", "simplify the mesh");

  in.seekg(std::streamoff(binary_header_size));
  for(std::uint32_t t = 0; t < triangles; ++t) {
    char record[triangle_size];
    in.read(record, sizeof(record));
    float coordinates[9];
    std::memcpy(coordinates, record + 12, sizeof(coordinates));
    for(float x : coordinates)
      if(!std::isfinite(x))
        throw Refusal("NON_FINITE_COORDINATE", file,
                      "triangle " + std::to_string(t) + " has the coordinate " + std::to_string(x),
                      "every coordinate must be a finite number");
  }
  return true;
}

} // namespace

Polygon_soup read_stl(const std::string& file)
{
  Polygon_soup soup;
  bool complete = false;
  if(is_checked_binary(file)) {
    std::ifstream in(file, std::ios::binary);
    complete = CGAL::IO::read_STL(in, soup.points, soup.polygons, CGAL::parameters::verbose(false));
  } else {
    Stl_lines stl_lines(file);
    Checked_lines lines([&stl_lines](std::string& out) { return stl_lines(out); });
    std::istream in(&lines);
    complete = CGAL::IO::read_STL(in, soup.points, soup.polygons, CGAL::parameters::verbose(false));
    lines.rethrow();
  }
  if(!complete)
    throw Refusal(unreadable_file, file, "cannot be read by CGAL's STL reader", "export it again");
  return soup;
}

} // namespace tool
