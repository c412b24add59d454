// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/checked_lines.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#include <CGAL/IO/OBJ.h>

#include <algorithm>
#include <istream>
#include <iterator>

namespace tool {
namespace {

/// The statements of the format that carry no vertex and no face.
constexpr const char* other_statements[] = {
  "vt",  "vn",   "vp",    "g",        "o",        "s",    "mg",         "usemtl",    "mtllib", "usemap", "maplib",
  "p",   "l",    "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "cstype",
  "deg", "bmat", "step",  "curv",     "curv2",    "surf", "parm",       "trim",      "hole",   "scrv",   "sp",
  "end", "con",  "call",  "csh",      "bsp",      "bzp",  "cdc",        "cdp",       "res"};

/// The `v` and `f` lines of an OBJ file with nothing but coordinates and vertex indices.
/// (CGAL 5.5 stops, or loses corners, at polylines, at tabs between corners and at continued lines.)
class Obj_lines {
public:
  explicit Obj_lines(const std::string& file) : file_(file), lines_(file) {}

  bool operator()(std::string& out)
  {
    while(out.empty()) {
      if(!lines_.next()) {
        check_largest_index();
        return false;
      }
      lines_.join_continued();
      Tokens tokens(lines_.text());
      const std::string_view keyword = tokens.next();
      if(keyword == "v")
        read_vertex(tokens, out);
      else if(keyword == "f")
        read_face(tokens, out);
      else if(std::find(std::begin(other_statements), std::end(other_statements), keyword) ==
              std::end(other_statements))
        lines_.refuse("begins with " + in_quotes(keyword) + ", which is not a statement of the OBJ format",
                      "the file is damaged or is not an OBJ file; export it again");
    }
    return true;
  }

private:
  void read_vertex(Tokens& tokens, std::string& out)
  {
    out = "v ";
    lines_.append_point(tokens, "vertex", vertices_, out);
    ++vertices_;
    if(vertices_ > largest_count)
      lines_.refuse("more vertices than this program can index", "simplify the mesh");
  }

  void read_face(Tokens& tokens, std::string& out)
  {
    out = "f";
    int corners = 0;
    for(std::string_view token = tokens.next(); !token.empty(); token = tokens.next()) {
      const std::optional<std::int64_t> index = to_integer(token.substr(0, token.find('/')));
      if(!index || *index == 0)
        lines_.refuse("face " + std::to_string(faces_) + " has the vertex " + in_quotes(token) +
                        ", which is not an index (the first is 1)",
                      "the file is damaged; export it again");
      const std::int64_t absolute = *index > 0 ? *index : std::int64_t(vertices_) + 1 + *index;
      if(absolute < 1 || absolute > std::int64_t(largest_count))
        lines_.refuse("face " + std::to_string(faces_) + " has the vertex " + in_quotes(token) +
                        ", which does not exist",
                      "the file is damaged or cut short; export it again");
      if(std::size_t(absolute) > largest_index_) {
        largest_index_ = std::size_t(absolute);
        largest_index_face_ = faces_;
      }
      out += ' ' + std::to_string(absolute);
      ++corners;
    }
    if(corners < 3)
      lines_.refuse("face " + std::to_string(faces_) + " has only " + std::to_string(corners) + " vertices",
                    "the file is damaged or cut short; export it again");
    out += '\n';
    ++faces_;
  }

  /// Faces may come before their vertices, so this is known at the end only.
  void check_largest_index() const
  {
    if(vertices_ == 0)
      throw Refusal("EMPTY_MESH", file_, "has no vertices", "check that this is an OBJ file with a mesh");
    if(faces_ == 0)
      throw Refusal("EMPTY_MESH", file_, "has " + std::to_string(vertices_) + " vertices, but no faces",
                    "a point cloud cannot be mapped; reconstruct a surface first");
    if(largest_index_ > vertices_)
      throw Refusal(unreadable_file, file_,
                    "face " + std::to_string(largest_index_face_) + " has the vertex number " +
                      std::to_string(largest_index_) + ", but there are only " + std::to_string(vertices_) +
                      " vertices",
                    "the file is damaged or cut short; export it again");
  }

  std::string file_;
  Text_lines lines_;
  std::size_t vertices_ = 0;
  std::size_t faces_ = 0;
  std::size_t largest_index_ = 0;
  std::size_t largest_index_face_ = 0;
};

} // namespace

Polygon_soup read_obj(const std::string& file)
{
  Obj_lines obj_lines(file);
  Checked_lines lines([&obj_lines](std::string& out) { return obj_lines(out); });
  std::istream in(&lines);
  Polygon_soup soup;
  const bool complete = CGAL::IO::read_OBJ(in, soup.points, soup.polygons, CGAL::parameters::verbose(false));
  lines.rethrow();
  if(!complete)
    throw Refusal(unreadable_file, file, "cannot be read by CGAL's OBJ reader", "export it again");
  return soup;
}

} // namespace tool
