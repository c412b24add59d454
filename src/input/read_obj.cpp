// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "input/text_pieces.h"

#include <algorithm>
#include <iterator>

namespace tool {
namespace {

/// The statements of the format that carry no vertex and no face.
constexpr std::string_view other_statements[] = {
  "vt",  "vn",   "vp",    "g",        "o",        "s",    "mg",         "usemtl",    "mtllib", "usemap", "maplib",
  "p",   "l",    "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "ctech",  "stech",  "cstype",
  "deg", "bmat", "step",  "curv",     "curv2",    "surf", "parm",       "trim",      "hole",   "scrv",   "sp",
  "end", "con",  "call",  "csh",      "bsp",      "bzp",  "cdc",        "cdp",       "res"};

class Obj_reader {
public:
  Obj_reader(const std::string& file, std::string text) : file_(file), lines_(file, std::move(text)) {}

  Soup read()
  {
    if(std::optional<Soup> soup = read_lines_by_themselves())
      return std::move(*soup);
    read_lines();
    check_counts();
    return std::move(soup_);
  }

private:
  /// The whole, if no line is continued and no index counts back from its line; else nothing.
  std::optional<Soup> read_lines_by_themselves() const
  {
    const std::string_view text = lines_.rest();
    const std::vector<std::string_view> pieces = pieces_of(text);
    if(pieces.size() < 2 || text.find('\\') != std::string_view::npos)
      return std::nullopt;
    std::vector<std::size_t> largest_number(pieces.size());
    std::optional<Soup> soup = read_pieces(pieces.size(), [&](std::size_t i) -> std::optional<Soup> {
      Obj_reader piece(file_, std::string(pieces[i]));
      piece.read_lines();
      if(piece.has_relative_index_)
        return std::nullopt;
      largest_number[i] = piece.largest_number_;
      return std::move(piece.soup_);
    });
    const std::size_t largest = *std::max_element(largest_number.begin(), largest_number.end());
    const bool is_right =
      soup && soup->faces > 0 && largest <= soup->points.size() && soup->points.size() <= largest_count;
    return is_right ? std::move(soup) : std::nullopt;
  }

  void read_lines()
  {
    while(lines_.next()) {
      lines_.join_continued();
      const std::string_view keyword = lines_.token();
      if(keyword == "v")
        read_vertex();
      else if(keyword == "f")
        read_face();
      else if(keyword.substr(0, 1) != "$" && // which begins comments in files of Viewpoint DataLabs
              std::find(std::begin(other_statements), std::end(other_statements), keyword) ==
                std::end(other_statements))
        lines_.refuse("begins with " + in_quotes(keyword) + ", which is not a statement of the OBJ format",
                      "the file is damaged or is not an OBJ file; export it again");
    }
  }

  void read_vertex()
  {
    soup_.points.push_back(lines_.point("vertex", soup_.points.size(), soup_.non_finite));
    if(soup_.points.size() > largest_count)
      lines_.refuse("more vertices than this program can index", "simplify the mesh");
  }

  void read_face()
  {
    const auto refuse = [this](const std::string& wrong, const std::string& remedy) {
      lines_.refuse("face " + std::to_string(soup_.faces) + " has " + wrong, remedy);
    };
    corners_.clear();
    for(std::string_view token = lines_.token(); !token.empty() && token[0] != '#'; token = lines_.token()) {
      const std::optional<std::int64_t> index = to_integer(token.substr(0, token.find('/')));
      if(!index || *index == 0)
        refuse("the vertex " + in_quotes(token) + ", which is not an index (the first is 1)", damaged);
      has_relative_index_ = has_relative_index_ || *index < 0;
      const std::int64_t number = *index > 0 ? *index : std::int64_t(soup_.points.size()) + 1 + *index;
      if(number < 1 || number > std::int64_t(largest_count))
        refuse("the vertex " + in_quotes(token) + ", which does not exist", damaged_or_cut_short);
      if(std::size_t(number) > largest_number_) {
        largest_number_ = std::size_t(number);
        face_of_largest_number_ = soup_.faces;
      }
      corners_.push_back(static_cast<int>(number - 1));
    }
    if(corners_.size() < 3)
      refuse("only " + std::to_string(corners_.size()) + " vertices", damaged_or_cut_short);
    soup_.add_face(corners_);
  }

  /// Faces may come before their vertices, so this is known at the end only.
  void check_counts() const
  {
    const std::string vertices = std::to_string(soup_.points.size()) + " vertices";
    if(soup_.points.empty())
      throw Refusal(Error_code::EMPTY_MESH, file_, "has no vertices", "check that this is an OBJ file with a mesh");
    if(soup_.faces == 0)
      refuse_point_cloud(file_, soup_.points.size());
    if(largest_number_ > soup_.points.size())
      refuse_file(file_,
                  "face " + std::to_string(face_of_largest_number_) + " has the vertex number " +
                    std::to_string(largest_number_) + ", but there are only " + vertices,
                  damaged_or_cut_short);
  }

  std::string file_;
  Text_lines lines_;
  std::size_t largest_number_ = 0; ///< of a vertex in a face, counted from 1
  std::size_t face_of_largest_number_ = 0;
  bool has_relative_index_ = false; ///< one that counts back from its line
  std::vector<int> corners_;        ///< of a face
  Soup soup_;
};

} // namespace

Soup read_obj(const std::string& file, std::string text) { return Obj_reader(file, std::move(text)).read(); }

} // namespace tool
