// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/binary.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "system/refusal.h"

#ifdef SPHERICAL_PARAMETERIZATION_WITH_GIFTI

#include <expat.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>

namespace tool {
namespace {

/// A `DataArray`: what its attributes say, and its text.
struct Data_array {
  std::map<std::string, std::string> attributes;
  std::string text;
  Annotations::Metadata metadata;
  std::vector<std::array<std::string, 3>> transforms;
};

/// GIFTI surfaces as of "GIFTI Surface Data Format, version 1.0" (2011). Expat takes the XML apart.
///
/// Not by the library giftiio: version 1.0.9 reads named files only, not bytes that were decompressed or came from a
/// pipe, and takes arrays that are cut short, or have words for numbers, for good ones.
class Gifti_reader {
public:
  explicit Gifti_reader(const std::string& file) : file_(file) {}

  Soup read(const std::string& text)
  {
    parse(text);
    if(!points_)
      refuse("has no points (NIFTI_INTENT_POINTSET)",
             "give the surface, not data on it: its name often ends in .surf.gii");
    if(!triangles_)
      throw Refusal(Error_code::EMPTY_MESH, file_, "has points, but no triangles (NIFTI_INTENT_TRIANGLE)",
                    "give the surface that belongs to them");
    read_points();
    read_triangles();
    soup_.annotations.gifti_points = std::move(points_->metadata);
    soup_.annotations.gifti_transforms = std::move(points_->transforms);
    return std::move(soup_);
  }

private:
  using Parser = std::unique_ptr<std::remove_pointer_t<XML_Parser>, decltype(&XML_ParserFree)>;

  void parse(const std::string& text)
  {
    const Parser parser(XML_ParserCreate(nullptr), XML_ParserFree);
    if(!parser)
      throw std::bad_alloc();
    XML_SetUserData(parser.get(), this);
    XML_SetElementHandler(parser.get(), on_start, on_end);
    XML_SetCharacterDataHandler(parser.get(), on_text);
    parser_ = parser.get();
    constexpr std::size_t step = std::size_t(1) << 24;
    for(std::size_t at = 0; at < text.size(); at += step) {
      const std::size_t size = std::min(step, text.size() - at);
      const auto status =
        XML_Parse(parser.get(), &text[at], static_cast<int>(size), at + size == text.size() ? XML_TRUE : XML_FALSE);
      if(!wrong_.empty())
        refuse(wrong_, "give a surface with one set of points and triangles");
      if(status != XML_STATUS_OK)
        refuse("line " + std::to_string(XML_GetCurrentLineNumber(parser.get())) + ": " +
                 XML_ErrorString(XML_GetErrorCode(parser.get())),
               damaged_);
    }
  }

  // Exceptions must not pass through Expat, which is C.
  template <class Action>
  static void call(void* self, Action action)
  {
    auto& reader = *static_cast<Gifti_reader*>(self);
    try {
      action(reader);
    } catch(const std::exception& error) {
      reader.stop(error.what());
    }
  }
  static void on_start(void* self, const char* element, const char** attributes)
  {
    call(self, [&](Gifti_reader& reader) { reader.start(element, attributes); });
  }
  static void on_end(void* self, const char* element)
  {
    call(self, [&](Gifti_reader& reader) { reader.end(element); });
  }
  static void on_text(void* self, const char* text, int size)
  {
    call(self, [&](Gifti_reader& reader) {
      if(reader.target_)
        reader.target_->append(text, static_cast<std::size_t>(size));
    });
  }

  void stop(const std::string& wrong)
  {
    if(wrong_.empty())
      wrong_ = wrong;
    XML_StopParser(parser_, XML_FALSE);
  }

  void start(const std::string& element, const char** attributes)
  {
    target_ = nullptr;
    if(element == "DataArray") {
      array_ = std::make_unique<Data_array>();
      for(; *attributes; attributes += 2)
        array_->attributes[attributes[0]] = attributes[1];
    } else if(element == "MD")
      metadata().emplace_back();
    else if(element == "Name" && !metadata().empty())
      target_ = &metadata().back().first;
    else if(element == "Value" && !metadata().empty())
      target_ = &metadata().back().second;
    else if(element == "CoordinateSystemTransformMatrix" && array_)
      array_->transforms.emplace_back();
    else if(array_ && !array_->transforms.empty() && element == "DataSpace")
      target_ = &array_->transforms.back()[0];
    else if(array_ && !array_->transforms.empty() && element == "TransformedSpace")
      target_ = &array_->transforms.back()[1];
    else if(array_ && !array_->transforms.empty() && element == "MatrixData")
      target_ = &array_->transforms.back()[2];
    else if(element == "Data" && array_ && (is("NIFTI_INTENT_POINTSET") || is("NIFTI_INTENT_TRIANGLE")))
      target_ = &array_->text;
  }

  void end(const std::string& element)
  {
    target_ = nullptr;
    if(element != "DataArray" || !array_)
      return;
    auto* const place = is("NIFTI_INTENT_POINTSET") ? &points_ : is("NIFTI_INTENT_TRIANGLE") ? &triangles_ : nullptr;
    if(place && *place)
      stop("has several sets of points or of triangles");
    else if(place)
      *place = std::move(array_);
    array_ = nullptr;
  }

  Annotations::Metadata& metadata() { return array_ ? array_->metadata : soup_.annotations.gifti; }

  bool is(const char* intent) const
  {
    const auto found = array_->attributes.find("Intent");
    return found != array_->attributes.end() && found->second == intent;
  }

  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy) const
  {
    throw Refusal(unreadable_file, file_, wrong, remedy);
  }

  const std::string& attribute(const Data_array& array, const char* name) const
  {
    const auto found = array.attributes.find(name);
    if(found == array.attributes.end())
      refuse(std::string("a DataArray has no attribute '") + name + "'", damaged_);
    return found->second;
  }

  /// How many rows of three a set has. `least` is what a number takes in the text at the least.
  std::size_t number_of_rows(const Data_array& array) const
  {
    const auto dimension = [&](const char* name) -> std::size_t {
      const std::string& text = attribute(array, name);
      const auto value = to_integer(text);
      if(!value || *value < 0 || std::size_t(*value) > largest_count)
        refuse(std::string("a DataArray has the ") + name + ' ' + in_quotes(text), damaged_);
      return static_cast<std::size_t>(*value);
    };
    if(attribute(array, "Dimensionality") != "2" || dimension("Dim1") != 3)
      refuse("points or triangles are not an array of rows of three", damaged_);
    return dimension("Dim0");
  }

  /// The numbers of a set by row and column, whatever type and encoding they have.
  /// `use(row, column, value)` is called for each.
  template <class Use>
  void read_numbers(const Data_array& array, std::size_t rows, Use use) const
  {
    const std::string& type = attribute(array, "DataType");
    const std::string& encoding = attribute(array, "Encoding");
    const std::size_t size = type == "NIFTI_TYPE_FLOAT64" || type == "NIFTI_TYPE_INT64" ? 8 : 4;
    if(encoding == "ExternalFileBinary")
      refuse("has its numbers in another file", "convert it to one file, as with gifti_tool -encoding B64GZ");
    if(encoding != "ASCII" && encoding != "Base64Binary" && encoding != "GZipBase64Binary")
      refuse("a DataArray has the encoding " + in_quotes(encoding), damaged_);
    const std::size_t count = 3 * rows;
    const std::size_t letters = array.text.size();
    // in text a digit and a space; Base64 has three bytes in four letters, and zlib unfolds to 1032 times at most
    const bool fits = encoding == "ASCII"          ? 2 * count <= letters + 1
                      : encoding == "Base64Binary" ? count * size <= letters
                                                   : count * size <= 1032 * letters;
    if(!fits)
      refuse("cut short: a DataArray announces " + std::to_string(rows) + " rows, more than its " +
               std::to_string(letters) + " letters can hold",
             damaged_);

    const bool is_column_major = attribute(array, "ArrayIndexingOrder") == "ColumnMajorOrder";
    const auto put = [&](std::size_t i, double value) {
      is_column_major ? use(i % rows, i / rows, value) : use(i / 3, i % 3, value);
    };
    if(encoding == "ASCII") {
      std::string_view rest = array.text;
      for(std::size_t i = 0; i < count; ++i) {
        const std::string_view token = next_token(rest);
        double value = 0;
        const Number kind = to_number(token, value);
        if(kind == Number::NONE)
          refuse("number " + std::to_string(i) + " of a DataArray is " + in_quotes(token), damaged_);
        put(i, value);
      }
      return;
    }
    const std::string bytes = binary(array, encoding == "GZipBase64Binary", count * size);
    const Byte_order order = attribute(array, "Endian") == "BigEndian" ? Byte_order::BIG : Byte_order::LITTLE;
    const auto convert = [&](auto number) {
      for(std::size_t i = 0; i < count; ++i)
        put(i, static_cast<double>(number_at<decltype(number)>(&bytes[i * size], order)));
    };
    if(type == "NIFTI_TYPE_FLOAT32")
      return convert(float());
    if(type == "NIFTI_TYPE_FLOAT64")
      return convert(double());
    if(type == "NIFTI_TYPE_INT32")
      return convert(std::int32_t());
    if(type == "NIFTI_TYPE_UINT32")
      return convert(std::uint32_t());
    if(type == "NIFTI_TYPE_INT64")
      return convert(std::int64_t());
    refuse("a DataArray has numbers of type " + in_quotes(type), "save it with 32-bit floats and integers");
  }

  std::string binary(const Data_array& array, bool is_compressed, std::size_t size) const
  {
    std::optional<std::string> bytes = from_base64(array.text);
    if(!bytes)
      refuse("a DataArray is no Base64 text", damaged_);
    if(is_compressed) {
      std::string unfolded(size, '\0');
      auto unfolded_size = static_cast<uLongf>(size);
      const int status = uncompress(reinterpret_cast<Bytef*>(unfolded.data()), &unfolded_size,
                                    reinterpret_cast<const Bytef*>(bytes->data()), static_cast<uLong>(bytes->size()));
      if(status != Z_OK)
        refuse("a DataArray cannot be decompressed to the size that it announces", damaged_);
      unfolded.resize(unfolded_size);
      bytes = std::move(unfolded);
    }
    if(bytes->size() != size)
      refuse("a DataArray announces " + std::to_string(size) + " bytes and has " + std::to_string(bytes->size()),
             damaged_);
    return std::move(*bytes);
  }

  void read_points()
  {
    soup_.points.resize(number_of_rows(*points_));
    read_numbers(*points_, soup_.points.size(), [&](std::size_t row, std::size_t column, double x) {
      if(!std::isfinite(x) && !soup_.non_finite)
        soup_.non_finite.emplace(Error_code::NON_FINITE_COORDINATE, file_,
                                 "vertex " + std::to_string(row) + " has the coordinate " + std::to_string(x),
                                 non_finite_remedy);
      soup_.points[row][column] = x;
    });
    points_->text = std::string();
  }

  void read_triangles()
  {
    soup_.triangles.resize(number_of_rows(*triangles_));
    soup_.faces = soup_.triangles.size();
    if(soup_.faces == 0)
      throw Refusal(Error_code::EMPTY_MESH, file_, "has no faces",
                    "a point cloud cannot be mapped; reconstruct a surface first");
    read_numbers(*triangles_, soup_.faces, [&](std::size_t row, std::size_t column, double corner) {
      // NaN, too, becomes an index that is refused
      const bool is_index = corner >= 0 && corner < static_cast<double>(largest_count) && corner == std::floor(corner);
      soup_.triangles[row][column] = is_index ? static_cast<int>(corner) : -1;
      check_corner(file_, row, soup_.triangles[row][column], soup_.points.size());
    });
  }

  const std::string damaged_ = "the file is damaged; export it again";
  std::string file_;
  XML_Parser parser_ = nullptr;
  std::string wrong_;                 ///< why parsing was stopped
  std::unique_ptr<Data_array> array_; ///< that is being read
  std::string* target_ = nullptr;     ///< of the text that is being read
  std::unique_ptr<Data_array> points_, triangles_;
  Soup soup_;
};

} // namespace

Soup read_gifti(const std::string& file, const std::string& text) { return Gifti_reader(file).read(text); }

} // namespace tool

#else

namespace tool {

Soup read_gifti(const std::string& file, const std::string&)
{
  throw Refusal(unreadable_file, file, "is a GIFTI file, which this build does not read",
                "convert it, as with mris_convert, or build with Expat (libexpat1-dev)");
}

} // namespace tool

#endif
