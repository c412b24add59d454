// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/checked_lines.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#include <CGAL/IO/OFF.h>

#include <filesystem>
#include <istream>

namespace tool {
namespace {

/// The lines of a plain OFF file without comments, colours and normals, made from those of any OFF, COFF, NOFF, STOFF.
/// (CGAL 5.5 reads beyond its arrays where a COFF or STOFF file lacks some of its columns.)
class Off_lines {
public:
  explicit Off_lines(const std::string& file) : file_(file), lines_(file) {}

  bool operator()(std::string& out)
  {
    if(!has_header_)
      read_header(out);
    else if(vertex_ < vertices_)
      read_vertex(out);
    else if(face_ < faces_)
      read_face(out);
    else {
      check_rest();
      return false;
    }
    return true;
  }

private:
  void read_header(std::string& out)
  {
    const std::string no_off = "does not begin with 'OFF'";
    const std::string remedy = "check that this is an OFF file";
    if(!lines_.next())
      lines_.refuse(no_off, remedy);
    Tokens tokens(lines_.text());
    std::string keyword(tokens.next());
    for(const char* prefix : {"ST", "C", "N"}) // textures, colours, normals: columns behind the coordinates
      if(keyword.rfind(prefix, 0) == 0)
        keyword.erase(0, std::string(prefix).size());
    if(keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
      lines_.refuse("is " + in_quotes(keyword) + ", whose points do not have three coordinates",
                    "save it as plain OFF");
    if(keyword != "OFF")
      lines_.refuse(no_off, remedy);

    std::string_view token = tokens.next();
    if(token == "BINARY")
      throw Refusal(unreadable_file, file_, "is in the 'OFF BINARY' dialect, which is not supported",
                    "save it as plain text OFF or as PLY");
    if(token.empty()) {
      if(!lines_.next())
        lines_.refuse_cut_short("the numbers of vertices and faces are missing");
      tokens = Tokens(lines_.text());
      token = tokens.next();
    }
    vertices_ = count(token);
    faces_ = count(tokens.next());

    // "0 0 0" and "3 0 1 2" with the ends of their lines (but for the last) are the shortest lines there are
    const std::uintmax_t bytes = std::filesystem::file_size(file_);
    if(6 * std::uintmax_t(vertices_) + 8 * std::uintmax_t(faces_) > bytes + 1)
      lines_.refuse("the header announces " + promise() + ", more than " + std::to_string(bytes) + " bytes can hold",
                    "the file is damaged or cut short; export it again");
    has_header_ = true;
    out = "OFF\n" + std::to_string(vertices_) + ' ' + std::to_string(faces_) + " 0\n";
  }

  std::size_t count(std::string_view token) const
  {
    const std::optional<std::int64_t> number = to_integer(token);
    if(!number || *number < 0)
      lines_.refuse("expected the numbers of vertices and faces, found " + in_quotes(lines_.text()),
                    "the header is damaged; export it again");
    if(*number > std::int64_t(largest_count))
      lines_.refuse("the header announces " + std::to_string(*number) + " elements, more than this program can index",
                    "simplify the mesh");
    return static_cast<std::size_t>(*number);
  }

  void read_vertex(std::string& out)
  {
    if(!lines_.next())
      lines_.refuse_cut_short("the header announces " + promise() + ", but there are only " + std::to_string(vertex_) +
                              " vertices");
    Tokens tokens(lines_.text());
    lines_.append_point(tokens, "vertex", vertex_, out);
    ++vertex_;
  }

  void read_face(std::string& out)
  {
    if(!lines_.next())
      lines_.refuse_cut_short("the header announces " + promise() + ", but there are only " + std::to_string(face_) +
                              " faces");
    const std::string remedy = "the file is damaged, or the counts in its header are wrong; export it again";
    Tokens tokens(lines_.text());
    const std::string_view first = tokens.next();
    const std::optional<std::int64_t> size = to_integer(first);
    if(!size || *size < 0)
      lines_.refuse("face " + std::to_string(face_) + " has " + in_quotes(first) + " as its number of vertices",
                    remedy);
    if(*size < 3)
      lines_.refuse("face " + std::to_string(face_) + " has only " + std::to_string(*size) + " vertices", remedy);
    out += first;
    for(std::int64_t i = 0; i < *size; ++i) {
      const std::string_view token = tokens.next();
      const std::optional<std::int64_t> index = to_integer(token);
      if(token.empty())
        lines_.refuse("face " + std::to_string(face_) + " has fewer than the " + std::to_string(*size) +
                        " vertices that it announces",
                      remedy);
      if(!index || *index < 0 || *index >= std::int64_t(vertices_))
        lines_.refuse("face " + std::to_string(face_) + " has the vertex " + in_quotes(token) +
                        ", which is not in the range 0.." + std::to_string(vertices_ - 1),
                      remedy);
      out += ' ';
      out += token;
    }
    out += '\n';
    ++face_;
  }

  /// Other lines may follow, but not more faces: then the header is wrong.
  void check_rest()
  {
    if(!lines_.next())
      return;
    Tokens tokens(lines_.text());
    const std::optional<std::int64_t> size = to_integer(tokens.next());
    std::int64_t indices = 0;
    while(to_integer(tokens.next()))
      ++indices;
    if(size && *size >= 3 && indices >= *size)
      lines_.refuse("another face after the " + std::to_string(faces_) + " that the header announces",
                    "the counts in the header are wrong; export the file again");
  }

  std::string promise() const
  {
    return std::to_string(vertices_) + " vertices and " + std::to_string(faces_) + " faces";
  }

  std::string file_;
  Text_lines lines_;
  bool has_header_ = false;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  std::size_t vertex_ = 0;
  std::size_t face_ = 0;
};

} // namespace

Polygon_soup read_off(const std::string& file)
{
  Off_lines off_lines(file);
  Checked_lines lines([&off_lines](std::string& out) { return off_lines(out); });
  std::istream in(&lines);
  Polygon_soup soup;
  const bool complete = CGAL::IO::read_OFF(in, soup.points, soup.polygons, CGAL::parameters::verbose(false));
  in.peek(); // CGAL stops at the last face: have a look at what follows
  lines.rethrow();
  if(!complete)
    throw Refusal(unreadable_file, file, "cannot be read by CGAL's OFF reader", "export it again");
  return soup;
}

} // namespace tool
