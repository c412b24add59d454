// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "input/mesh_format.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "input/text_pieces.h"

#include <algorithm>
#include <cstdint>

namespace tool {
namespace {

/// What follows "OFF BINARY", which does not say of which of its dialects it is. Those of Geomview and CGAL are
/// big-endian, and have colours behind the corners of a face, and their number; that of pmp has numbers as the machine
/// has them, and no colours. Nothing if the bytes are not those of the dialect, to the last one.
std::optional<Soup> read_binary(const std::string& file, std::string_view bytes, Byte_order order)
{
  const auto left = [&] { return static_cast<std::int64_t>(bytes.size() / 4); };
  const auto skip = [&](std::int64_t numbers) { bytes.remove_prefix(4 * static_cast<std::size_t>(numbers)); };
  const auto next = [&]() -> std::int64_t { // -1 at the end
    if(left() == 0)
      return -1;
    const auto number = number_at<std::int32_t>(bytes.data(), order);
    skip(1);
    return number;
  };
  const std::int64_t vertices = next(), faces = next();
  next(); // edges, which nobody counts
  if(vertices < 0 || faces < 0 || 3 * vertices + 4 * faces > left())
    return std::nullopt;
  Soup soup;
  soup.points.resize(static_cast<std::size_t>(vertices));
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k, skip(1))
      soup.set_coordinate(file, v, k, number_at<float>(bytes.data(), order));
  std::vector<int> corners;
  for(std::int64_t f = 0; f < faces; ++f) {
    const std::int64_t size = next();
    if(size < 3 || size > left())
      return std::nullopt;
    corners.clear();
    for(std::int64_t i = 0; i < size; ++i) {
      corners.push_back(static_cast<int>(next()));
      if(corners.back() < 0 || corners.back() >= vertices)
        return std::nullopt;
    }
    soup.add_face(corners);
    const std::int64_t colours = order == Byte_order::BIG ? next() : 0;
    if(colours < 0 || colours > left())
      return std::nullopt;
    skip(colours);
  }
  return bytes.empty() || bytes == "\n" ? std::optional(std::move(soup)) : std::nullopt;
}

/// OFF, COFF, NOFF and STOFF: colours, normals and textures are columns that are skipped.
class Off_reader {
public:
  Off_reader(const std::string& file, std::string text) : file_(file), lines_(file, std::move(text)) {}

  Soup read()
  {
    read_header();
    if(is_binary_)
      return read_binary();
    if(std::optional<Soup> soup = read_plain_lines())
      return std::move(*soup);
    read_lines(0, vertices_ + faces_);
    check_rest();
    return std::move(soup_);
  }

private:
  Soup read_binary() const
  {
    for(const Byte_order order : {Byte_order::BIG, Byte_order::LITTLE})
      if(std::optional<Soup> soup = tool::read_binary(file_, lines_.rest(), order)) {
        if(soup->faces == 0)
          refuse_point_cloud(file_, soup->points.size());
        return std::move(*soup);
      }
    refuse_file(file_, "cut short, or in a dialect of OFF BINARY that is not known",
                "save it as plain text OFF or as PLY");
  }

  /// Behind the header, if nothing else is there than a line for each vertex and face; else nothing.
  std::optional<Soup> read_plain_lines() const
  {
    std::string_view text = lines_.rest();
    text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
    const std::vector<std::string_view> pieces = pieces_of(text);
    std::vector<std::size_t> first_line = {0};
    for(const std::size_t lines : numbers_of_lines(pieces))
      first_line.push_back(first_line.back() + lines);
    if(pieces.size() < 2 || first_line.back() != vertices_ + faces_)
      return std::nullopt;
    return read_pieces(pieces.size(), [&](std::size_t i) {
      Off_reader piece(file_, std::string(pieces[i]));
      piece.vertices_ = vertices_;
      piece.read_lines(first_line[i], first_line[i + 1]);
      const bool is_at_end = !piece.lines_.next(); // or some lines ended with CR
      return is_at_end ? std::optional(std::move(piece.soup_)) : std::nullopt;
    });
  }

  /// Lines behind the header, but for blank ones and comments, which are not counted.
  void read_lines(std::size_t first, std::size_t end)
  {
    const std::size_t first_face = std::clamp(vertices_, first, end);
    soup_.points.reserve(first_face - first);
    soup_.triangles.reserve(end - first_face);
    for(std::size_t line = first; line < end; ++line) {
      if(!lines_.next())
        lines_.refuse_cut_short(
          "the header announces " + promise() + ", but there are only " +
          (line < vertices_ ? std::to_string(line) + " vertices" : std::to_string(line - vertices_) + " faces"));
      if(line < vertices_)
        soup_.points.push_back(lines_.point("vertex", line, soup_.non_finite));
      else
        read_face();
    }
  }

  void read_header()
  {
    const std::string no_off = "does not begin with 'OFF'";
    const std::string remedy = "check that this is an OFF file";
    if(!lines_.next())
      lines_.refuse(no_off, remedy);
    const std::string_view word = lines_.token(), keyword = without_off_columns(word);
    const bool has_columns = keyword.size() < word.size();
    if(keyword == "4OFF" || keyword == "nOFF" || keyword == "4nOFF")
      lines_.refuse("is " + in_quotes(keyword) + ", whose points do not have three coordinates",
                    "save it as plain OFF");
    if(keyword != "OFF")
      lines_.refuse(no_off, remedy);

    std::string_view token = lines_.token();
    is_binary_ = token == "BINARY";
    if(is_binary_ && has_columns)
      refuse_file(file_, "is in the dialect " + in_quotes(lines_.line()) + ", which is not supported",
                  "save it as plain text OFF or as PLY");
    if(is_binary_)
      return;
    if(token.empty()) {
      if(!lines_.next())
        lines_.refuse_cut_short("the numbers of vertices and faces are missing");
      token = lines_.token();
    }
    vertices_ = count(token);
    faces_ = count(lines_.token());

    // "0 0 0" and "3 0 1 2" with the ends of their lines (but for the last) are the shortest lines there are
    const std::size_t bytes = lines_.number_of_bytes();
    if(6 * vertices_ + 8 * faces_ > bytes + 1)
      lines_.refuse("the header announces " + promise() + ", more than " + std::to_string(bytes) + " bytes can hold",
                    damaged_or_cut_short);
  }

  std::size_t count(std::string_view token) const
  {
    const std::optional<std::int64_t> number = to_integer(token);
    if(!number || *number < 0)
      lines_.refuse("expected the numbers of vertices and faces, found " + in_quotes(lines_.line()),
                    "the header is damaged; export it again");
    if(*number > std::int64_t(largest_count))
      lines_.refuse("the header announces " + std::to_string(*number) + " elements, more than this program can index",
                    "simplify the mesh");
    return static_cast<std::size_t>(*number);
  }

  void read_face()
  {
    const auto refuse = [this](const std::string& wrong) {
      lines_.refuse("face " + std::to_string(soup_.faces) + " has " + wrong,
                    "the file is damaged, or the counts in its header are wrong; export it again");
    };
    const std::string_view first = lines_.token();
    const std::optional<std::int64_t> size = to_integer(first);
    if(!size || *size < 0)
      refuse(in_quotes(first) + " as its number of vertices");
    if(*size < 3)
      refuse("only " + std::to_string(*size) + " vertices");
    corners_.clear();
    for(std::int64_t i = 0; i < *size; ++i) {
      const std::string_view token = lines_.token();
      const std::optional<std::int64_t> index = to_integer(token);
      if(token.empty())
        refuse("fewer than the " + std::to_string(*size) + " vertices that it announces");
      if(!index || *index < 0 || *index >= std::int64_t(vertices_))
        refuse("the vertex " + in_quotes(token) + ", which is not in the range 0.." +
               std::to_string(std::int64_t(vertices_) - 1));
      corners_.push_back(static_cast<int>(*index));
    }
    soup_.add_face(corners_);
  }

  /// Other lines may follow, but not more faces: then the header is wrong.
  void check_rest()
  {
    if(!lines_.next())
      return;
    const std::optional<std::int64_t> size = to_integer(lines_.token());
    std::int64_t indices = 0;
    while(to_integer(lines_.token()))
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
  bool is_binary_ = false;
  std::size_t vertices_ = 0; ///< that the header announces
  std::size_t faces_ = 0;
  std::vector<int> corners_; ///< of a face
  Soup soup_;
};

} // namespace

Soup read_off(const std::string& file, std::string text) { return Off_reader(file, std::move(text)).read(); }

} // namespace tool
