// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"

#include <CGAL/Spherical_parameterization/for_each_index.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <map>
#include <sstream>

namespace tool {
namespace {

struct Property {
  std::string name;
  const Number_type* type = nullptr;       ///< of the value, or of each value of a list
  const Number_type* count_type = nullptr; ///< of the length of a list; null if this is no list
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool are_strips() const { return name == "tristrips"; }
  bool is_face() const { return name == "face" || name == "faces"; }

  const Property* find(std::string_view property) const
  {
    const auto found =
      std::find_if(properties.begin(), properties.end(), [=](const Property& p) { return p.name == property; });
    return found == properties.end() ? nullptr : &*found;
  }
};

class Ply_reader {
public:
  Ply_reader(const std::string& file, std::string_view bytes) : file_(file), rest_(bytes) {}

  Soup read()
  {
    read_header();
    check_elements();
    check_faces();
    for(const Element& element : elements_)
      if(element.count > (rest_.size() + 1) / smallest_size(element))
        refuse_file(file_,
                    "cut short: the header announces " + std::to_string(element.count) + " elements " +
                      in_quotes(element.name) + ", more than " + std::to_string(rest_.size()) + " bytes can hold",
                    damaged_);
    soup_.points.reserve(vertices_->count);
    for(Vertex_column& column : soup_.data)
      column.values.reserve(vertices_->count);
    soup_.triangles.reserve(faces_->count);
    for(const Element& element : elements_)
      if(!read_plain_vertices(element) && !read_plain_triangles(element))
        for(std::size_t row = 0; row < element.count; ++row)
          read_row(element, row);
    constexpr std::size_t end_of_line = 2; // which some write behind the data
    if(is_text_ ? !next_token(rest_).empty()
                : rest_.size() >= std::max(end_of_line + 1, smallest_size(elements_.back())))
      refuse_file(file_, "has more data than the header announces",
                  "the counts in the header are wrong; export it again");
    if(soup_.triangles.empty()) // all triangles of strips have a corner twice
      refuse_point_cloud(file_, soup_.points.size());
    return std::move(soup_);
  }

private:
  void read_header()
  {
    next_line();
    if(next_token(line_) != "ply")
      refuse("does not begin with 'ply'", "check that this is a PLY file");
    std::string_view line, keyword;
    do {
      next_line();
      line = line_;
      keyword = next_token(line);
    } while(keyword == "comment" || keyword == "obj_info");
    read_format();
    while(true) {
      next_line();
      const std::string_view keyword = next_token(line_);
      if(keyword == "end_header")
        return;
      if(keyword == "element")
        read_element();
      else if(keyword == "property")
        read_property();
      else if(keyword != "comment" && keyword != "obj_info")
        refuse("begins with " + in_quotes(keyword) + ", which is not a keyword of a PLY header");
    }
  }

  void next_line()
  {
    if(rest_.empty())
      refuse_file(file_, "cut short: the header has no 'end_header'", "export it again");
    ++number_;
    line_ = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(line_.size() + 1, rest_.size()));
  }

  [[noreturn]] void refuse(const std::string& wrong,
                           const std::string& remedy = "the header is damaged; export it again") const
  {
    refuse_file(file_, "line " + std::to_string(number_) + ": " + wrong, remedy);
  }

  void read_format()
  {
    const std::string_view line = line_, keyword = next_token(line_), format = next_token(line_);
    if(keyword != "format" || next_token(line_).empty())
      refuse("expected 'format', found " + in_quotes(line));
    if(format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
      refuse("the format " + in_quotes(format) + " is unknown");
    is_text_ = format == "ascii";
    order_ = format == "binary_big_endian" ? Byte_order::BIG : Byte_order::LITTLE;
  }

  void read_element()
  {
    Element element;
    element.name = next_token(line_);
    const std::string_view token = next_token(line_);
    const std::optional<std::int64_t> count = to_integer(token);
    if(!count || *count < 0)
      refuse("element " + in_quotes(element.name) + " has the count " + in_quotes(token));
    if(*count > std::int64_t(largest_count))
      refuse("the header announces " + std::to_string(*count) + " elements " + in_quotes(element.name) +
             ", more than this program can index");
    element.count = static_cast<std::size_t>(*count);
    elements_.push_back(element);
  }

  void read_property()
  {
    if(elements_.empty())
      refuse("a property before any element");
    Property property;
    std::string_view type_name = next_token(line_);
    if(type_name == "list") {
      property.count_type = type(next_token(line_));
      if(!property.count_type->is_integer)
        refuse("the length of a list is not an integer");
      type_name = next_token(line_);
    }
    property.type = type(type_name);
    property.name = next_token(line_);
    if(property.name.empty())
      refuse("a property without a name");
    elements_.back().properties.push_back(property);
  }

  const Number_type* type(std::string_view name) const
  {
    if(const Number_type* const type = number_type(name))
      return type;
    refuse("the number type " + in_quotes(name) + " is unknown");
  }

  /// Finds vertices and faces, and what is needed of them.
  void check_elements()
  {
    for(const Element& element : elements_) {
      if(element.properties.empty() && element.count > 0)
        refuse("element " + in_quotes(element.name) + " has no properties");
      if(element.is_vertex() && std::exchange(vertices_, &element))
        refuse("the element 'vertex' occurs twice");
      if(element.is_face() && std::exchange(faces_, &element))
        refuse("the element 'face' occurs twice");
    }
    if(!vertices_)
      refuse("there is no element 'vertex'");
    for(std::size_t k = 0; k < 3; ++k) {
      const std::string name(1, "xyz"[k]);
      coordinate_[k] = vertices_->find(name);
      if(!coordinate_[k] || coordinate_[k]->count_type || coordinate_[k]->type->is_integer)
        refuse("the vertices have no 'float' or 'double' property " + in_quotes(name), "export it again");
    }
    for(const Property& property : vertices_->properties)
      if(!property.count_type && !is_point_or_normal(property.name)) {
        columns_.push_back(&property);
        soup_.data.push_back({property.name, {}, property.type == number_type("int")});
      }
  }

  void check_faces()
  {
    if(!faces_ || faces_->count == 0)
      for(const Element& element : elements_)
        if(element.are_strips())
          faces_ = &element;
    if(!faces_ || faces_->count == 0)
      refuse_point_cloud(file_, vertices_->count);
    corners_ = faces_->find("vertex_indices");
    if(!corners_)
      corners_ = faces_->find("vertex_index");
    if(!corners_ || !corners_->count_type)
      refuse("the faces have no list 'vertex_indices'", "export it again");
    if(!corners_->type->is_integer)
      refuse("the vertex indices of the faces are of type " + in_quotes(corners_->type->name) +
               ", which has no integers",
             "export it again");
  }

  /// How many bytes a number of this type takes at least: in text, a digit and a space.
  std::size_t smallest_size(const Number_type& type) const { return is_text_ ? 2 : type.size; }

  std::size_t smallest_size(const Element& element) const
  {
    std::size_t size = 0;
    for(const Property& p : element.properties)
      size += smallest_size(p.count_type ? *p.count_type : *p.type);
    if(&element == faces_)
      size += 3 * smallest_size(*corners_->type);
    return std::max<std::size_t>(size, 1);
  }

  /// Reads the vertices of a binary file on all cores, if all is well with them and they have no lists. Otherwise
  /// nothing has happened.
  bool read_plain_vertices(const Element& element)
  {
    if(&element != vertices_ || is_text_ || order_ == Byte_order::BIG)
      return false;
    std::size_t size = 0;
    std::map<const Property*, std::size_t> place;
    for(const Property& property : element.properties) {
      if(property.count_type)
        return false;
      place[&property] = size;
      size += property.type->size;
    }
    if(rest_.size() / size < element.count)
      return false;
    soup_.points.resize(element.count);
    std::array<std::size_t, 3> place_of_coordinate;
    for(std::size_t k = 0; k < 3; ++k)
      place_of_coordinate[k] = place[coordinate_[k]];
    const char* const bytes = rest_.data();
    const bool are_finite = for_all_rows(element.count, [&](std::size_t row) {
      for(std::size_t k = 0; k < 3; ++k) {
        double& x = soup_.points[row][k];
        x = coordinate_[k]->type->read(bytes + row * size + place_of_coordinate[k], Byte_order::LITTLE);
        if(!std::isfinite(x))
          return false;
      }
      return true;
    });
    if(!are_finite) {
      soup_.points.clear();
      return false;
    }
    for(std::size_t i = 0; i < columns_.size(); ++i)
      for(std::size_t row = 0; row < element.count; ++row)
        soup_.data[i].values.push_back(
          columns_[i]->type->read(bytes + row * size + place[columns_[i]], Byte_order::LITTLE));
    rest_.remove_prefix(element.count * size);
    return true;
  }

  /// The same for faces that are triangles and have no other properties, by far the most common ones.
  bool read_plain_triangles(const Element& element)
  {
    if(&element != faces_ || element.are_strips() || is_text_ || order_ == Byte_order::BIG ||
       element.properties.size() != 1 || corners_->count_type->size != 1 || corners_->type->size != 4)
      return false;
    constexpr std::size_t size = 1 + 3 * sizeof(std::uint32_t);
    if(rest_.size() / size < element.count)
      return false;
    soup_.triangles.resize(element.count);
    const bool are_good = for_all_rows(element.count, [&](std::size_t row) {
      const char* const bytes = rest_.data() + row * size;
      for(std::size_t k = 0; k < 3; ++k) {
        const auto corner = number_at<std::uint32_t>(bytes + 1 + k * sizeof(std::uint32_t));
        if(corner >= vertices_->count) // so is every negative one
          return false;
        soup_.triangles[row][k] = static_cast<int>(corner);
      }
      return *bytes == 3;
    });
    if(are_good) {
      rest_.remove_prefix(element.count * size);
      soup_.faces = element.count;
    } else
      soup_.triangles.clear();
    return are_good;
  }

  /// Calls read(row) for all rows below `count` on all cores. Returns whether all of these calls returned true.
  template <class Read>
  static bool for_all_rows(std::size_t count, Read read)
  {
    std::atomic<bool> are_good{true};
    SP::for_each_index(CGAL::Parallel_tag(), static_cast<int>(count), [&](int row) {
      if(are_good && !read(static_cast<std::size_t>(row)))
        are_good = false;
    });
    return are_good;
  }

  void read_row(const Element& element, std::size_t row)
  {
    if(&element == vertices_)
      soup_.points.push_back({0, 0, 0});
    std::size_t column = 0;
    for(const Property& property : element.properties) {
      if(property.count_type) {
        read_list(element, row, property);
        continue;
      }
      const double value = next(*property.type, element, row);
      for(std::size_t k = 0; k < 3; ++k)
        if(&property == coordinate_[k])
          soup_.set_coordinate(file_, row, k, value);
      if(column < columns_.size() && &property == columns_[column])
        soup_.data[column++].values.push_back(value);
    }
  }

  void read_list(const Element& element, std::size_t row, const Property& property)
  {
    const double length = next(*property.count_type, element, row);
    if(!(length >= 0) || length * double(smallest_size(*property.type)) > double(rest_.size() + 1))
      refuse_cut_short(element, row);
    const bool is_face = &property == corners_, is_strip = is_face && element.are_strips();
    const auto refuse_face = [&](const std::string& wrong) {
      refuse_file(file_, (is_strip ? "strip " : "face ") + std::to_string(row) + " has " + wrong, damaged_);
    };
    if(is_face && !is_strip && length < 3)
      refuse_face("only " + std::to_string(int(length)) + " vertices");
    face_.clear();
    for(double i = 0; i < length; ++i) {
      const double value = next(*property.type, element, row);
      if(!is_face)
        continue;
      if(is_strip && value == -1) { // another one begins
        soup_.add_strip(face_);
        face_.clear();
        continue;
      }
      const std::size_t vertices = vertices_->count;
      if(!(value >= 0 && value < double(vertices))) {
        std::ostringstream vertex; // of 20 digits at most, which no integer has to hold
        vertex.precision(20);
        vertex << value;
        refuse_face("the vertex " + vertex.str() + ", which is not in the range 0.." +
                    std::to_string(std::int64_t(vertices) - 1));
      }
      face_.push_back(static_cast<int>(value));
    }
    if(is_strip)
      soup_.add_strip(face_);
    else if(is_face)
      soup_.add_face(face_);
  }

  /// The next number, which is part of `element` number `row`.
  double next(const Number_type& type, const Element& element, std::size_t row)
  {
    if(is_text_)
      return next_in_text(type, element, row);
    if(rest_.size() < type.size)
      refuse_cut_short(element, row);
    const char* const bytes = rest_.data();
    rest_.remove_prefix(type.size);
    return type.read(bytes, order_);
  }

  double next_in_text(const Number_type& type, const Element& element, std::size_t row)
  {
    const std::string_view token = next_token(rest_);
    if(token.empty())
      refuse_cut_short(element, row);
    const auto refuse = [&](const std::string& wrong, const std::string& remedy) {
      refuse_file(file_, element.name + " " + std::to_string(row) + " has " + wrong + std::string(type.name), remedy);
    };
    double value = 0;
    const Number number = to_number(token, value);
    if(number == Number::NONE || (type.is_integer && !to_integer(token)))
      refuse(in_quotes(token) + " for a value of type ", damaged_);
    if(type.is_integer && (value < type.smallest || value > type.largest))
      refuse("the value " + in_quotes(token) + ", which is too large for type ", damaged);
    if(type.is_integer || type.size == 8)
      return value;
    float rounded = 0; // once, and not by way of a double
    to_number(token, rounded);
    return rounded;
  }

  [[noreturn]] void refuse_cut_short(const Element& element, std::size_t row) const
  {
    refuse_file(file_,
                "cut short: the header announces " + std::to_string(element.count) + " elements " +
                  in_quotes(element.name) + ", the file ends in number " + std::to_string(row),
                damaged_);
  }

  const std::string damaged_ = "the file is damaged, or the counts in its header are wrong; export it again";
  std::string file_;
  std::string_view rest_;  ///< of the bytes
  std::string_view line_;  ///< of the header, as far as it has not been read
  std::size_t number_ = 0; ///< of the line
  bool is_text_ = true;
  Byte_order order_ = Byte_order::LITTLE; ///< of binary files
  std::vector<Element> elements_;
  const Element* vertices_ = nullptr;
  const Element* faces_ = nullptr;
  std::array<const Property*, 3> coordinate_ = {};
  std::vector<const Property*> columns_; ///< of `soup_.data`
  const Property* corners_ = nullptr;    ///< the list of the vertices of a face
  std::vector<int> face_;
  Soup soup_;
};

} // namespace

Soup read_ply(const std::string& file, std::string bytes) { return Ply_reader(file, bytes).read(); }

} // namespace tool
