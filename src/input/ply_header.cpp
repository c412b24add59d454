// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/ply_header.h"

#include "input/polygon_soup.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#include <algorithm>
#include <cfloat>
#include <cstdint>
#include <set>
#include <utility>

namespace tool {
namespace {

constexpr Ply_type types[] = {
  {"char", "int8", 1, true, INT8_MIN, INT8_MAX},     {"uchar", "uint8", 1, true, 0, UINT8_MAX},
  {"short", "int16", 2, true, INT16_MIN, INT16_MAX}, {"ushort", "uint16", 2, true, 0, UINT16_MAX},
  {"int", "int32", 4, true, INT32_MIN, INT32_MAX},   {"uint", "uint32", 4, true, 0, UINT32_MAX},
  {"float", "float32", 4, false, -FLT_MAX, FLT_MAX}, {"double", "float64", 8, false, -DBL_MAX, DBL_MAX}};

class Header_parser {
public:
  Header_parser(const std::string& file, std::istream& in) : file_(file), in_(in) {}

  Ply_header parse()
  {
    if(!next_line() || Tokens(line_).next() != "ply")
      refuse("does not begin with 'ply'", "check that this is a PLY file");
    if(!next_line())
      refuse_missing_end();
    read_format();
    while(next_line()) {
      Tokens tokens(line_);
      const std::string_view keyword = tokens.next();
      if(keyword == "end_header") {
        check_elements();
        return std::move(header_);
      }
      if(keyword == "element")
        read_element(tokens);
      else if(keyword == "property")
        read_property(tokens);
      else if(keyword != "comment" && keyword != "obj_info")
        refuse("begins with " + in_quotes(keyword) + ", which is not a keyword of a PLY header", damaged_);
    }
    refuse_missing_end();
  }

private:
  bool next_line()
  {
    ++number_;
    return bool(std::getline(in_, line_));
  }

  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy) const
  {
    throw Refusal(unreadable_file, file_, "line " + std::to_string(number_) + ": " + wrong, remedy);
  }

  [[noreturn]] void refuse_missing_end() const
  {
    throw Refusal(unreadable_file, file_, "cut short: the header has no 'end_header'", "export it again");
  }

  void read_format()
  {
    Tokens tokens(line_);
    const std::string_view keyword = tokens.next();
    const std::string_view format = tokens.next();
    if(keyword != "format" || tokens.next().empty())
      refuse("expected 'format', found " + in_quotes(line_), damaged_);
    if(format == "ascii")
      header_.format = Ply_header::ASCII;
    else if(format == "binary_little_endian")
      header_.format = Ply_header::LITTLE_ENDIAN_BINARY;
    else if(format == "binary_big_endian")
      header_.format = Ply_header::BIG_ENDIAN_BINARY;
    else
      refuse("the format " + in_quotes(format) + " is unknown", damaged_);
  }

  void read_element(Tokens& tokens)
  {
    Ply_element element;
    element.name = tokens.next();
    const std::string_view token = tokens.next();
    const std::optional<std::int64_t> count = to_integer(token);
    if(!count || *count < 0)
      refuse("element " + in_quotes(element.name) + " has the count " + in_quotes(token), damaged_);
    if(*count > std::int64_t(largest_count))
      refuse("the header announces " + std::to_string(*count) + " elements " + in_quotes(element.name) +
               ", more than this program can index",
             damaged_);
    element.count = static_cast<std::uint64_t>(*count);
    header_.elements.push_back(element);
  }

  void read_property(Tokens& tokens)
  {
    if(header_.elements.empty())
      refuse("a property before any element", damaged_);
    Ply_property property;
    std::string_view type_name = tokens.next();
    if(type_name == "list") {
      property.count_type = type(tokens.next());
      if(!property.count_type->is_integer)
        refuse("the length of a list is not an integer", damaged_);
      type_name = tokens.next();
    }
    property.type = type(type_name);
    property.name = tokens.next();
    if(property.name.empty())
      refuse("a property without a name", damaged_);
    header_.elements.back().properties.push_back(property);
  }

  const Ply_type* type(std::string_view name) const
  {
    for(const Ply_type& t : types)
      if(name == t.name || name == t.other_name)
        return &t;
    refuse("the number type " + in_quotes(name) + " is unknown", damaged_);
  }

  /// What CGAL's reader takes for granted.
  void check_elements() const
  {
    const Ply_element* vertices = nullptr;
    const Ply_element* faces = nullptr;
    for(const Ply_element& element : header_.elements) {
      if(element.properties.empty() && element.count > 0)
        refuse("element " + in_quotes(element.name) + " has no properties", damaged_);
      if(element.is_vertex() && std::exchange(vertices, &element))
        refuse("the element 'vertex' occurs twice", damaged_);
      if(element.is_face() && std::exchange(faces, &element))
        refuse("the element 'face' occurs twice", damaged_);
      check_types(element);
    }
    if(!vertices)
      refuse("there is no element 'vertex'", damaged_);
    for(const char* name : {"x", "y", "z"}) {
      const Ply_property* property = vertices->find(name);
      if(!property || property->count_type || property->type->is_integer)
        refuse("the vertices have no 'float' or 'double' property " + in_quotes(name), "export it again");
    }
    check_faces(*vertices, faces);
  }

  void check_faces(const Ply_element& vertices, const Ply_element* faces) const
  {
    const std::string points = std::to_string(vertices.count) + " vertices";
    if(!faces || faces->count == 0) {
      for(const Ply_element& element : header_.elements)
        if(element.name == "tristrips")
          throw Refusal(unreadable_file, file_, "has " + points + " and its faces as triangle strips ('tristrips')",
                        "save it with one element 'face' per triangle");
      throw Refusal("EMPTY_MESH", file_, "has " + points + ", but no faces",
                    "a point cloud cannot be mapped; reconstruct a surface first");
    }
    const Ply_property* indices = faces->find("vertex_indices");
    if(!indices)
      indices = faces->find("vertex_index");
    if(!indices || !indices->count_type)
      refuse("the faces have no list 'vertex_indices'", "export it again");
    if(!indices->type->is_integer || indices->type->size != 4)
      refuse(std::string("the vertex indices of the faces are of type '") + indices->type->name +
               "', only 'int' and 'uint' are supported",
             "export it again");
  }

  /// CGAL 5.5 dereferences null if properties that it knows by name are of other types than it expects.
  void check_types(const Ply_element& element) const
  {
    std::set<const Ply_type*> colour_types;
    for(const Ply_property& p : element.properties) {
      for(const char* colour : {"red", "green", "blue", "r", "g", "b"})
        if(p.name == colour && !p.count_type)
          colour_types.insert(p.type);
      const bool is_index = p.name == "source" || p.name == "target";
      const bool is_texture = p.name == "u" || p.name == "v";
      if(element.name == "halfedge" && (is_index || is_texture) &&
         (p.count_type || p.type->name != std::string(is_index ? "uint" : "float")))
        refuse("property " + in_quotes(p.name) + " of the half-edges has the wrong type",
               "export it without half-edges");
    }
    if((element.is_vertex() || element.is_face()) && colour_types.size() > 1)
      refuse("the colours of element " + in_quotes(element.name) + " are of different types",
             "export it without colours");
  }

  const std::string damaged_ = "the header is damaged; export it again";
  const std::string& file_;
  std::istream& in_;
  std::string line_;
  std::size_t number_ = 0;
  Ply_header header_;
};

} // namespace

const Ply_property* Ply_element::find(const std::string& property) const
{
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&property](const Ply_property& p) { return p.name == property; });
  return found == properties.end() ? nullptr : &*found;
}

Ply_header read_ply_header(const std::string& file, std::istream& in) { return Header_parser(file, in).parse(); }

} // namespace tool
