// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "input/compression.h"
#include "input/files.h"
#include "input/mesh_format.h"
#include "input/mesh_readers.h"
#include "input/text_lines.h"
#include "input/welded_points.h"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <system_error>

namespace tool {
namespace {

using Json = nlohmann::json;
using Matrix = Eigen::Matrix4d;

/// Column by column: then the order of the sums does not depend on what Eigen does on a processor.
Eigen::Vector4d product(const Matrix& m, const Eigen::Vector4d& v)
{
  return m.col(0) * v[0] + m.col(1) * v[1] + m.col(2) * v[2] + m.col(3) * v[3];
}

/// The file that a URI in another one stands for; none if it is not next to that one.
std::optional<std::string> file_next_to(const std::string& file, const std::string& uri)
{
  const std::filesystem::path name = std::filesystem::path(percent_decoded(uri)).lexically_normal();
  const bool is_here = name.is_relative() && name.begin() != name.end() && *name.begin() != "..";
  if(!is_here || uri.find(':') != std::string::npos || file == standard_stream)
    return std::nullopt;
  return (std::filesystem::path(file).parent_path() / name).string();
}

/// The triangles of the scene of a glTF 2.0 file ("glTF 2.0 Specification", Khronos Group, 2021), in the space of the
/// scene. The format splits vertices where texture coordinates or normals differ; those at the same place become one.
///
/// By hand: tinygltf 2.7, as Debian has it, crashes on deeply nested `extras`, and checks neither that accessors are
/// within their views nor that buffers are files next to this one, which would be most of the work here.
class Gltf_reader {
public:
  explicit Gltf_reader(const std::string& file) : file_(file) {}

  Soup read_binary(const std::string& bytes) { return read_json(json_of(bytes)); }

  Soup read_text(const std::string& text)
  {
    size_of_file_ = text.size();
    return read_json(text);
  }

  /// The files next to this one that it names and that can be read, whether it has use for them or not.
  std::vector<std::string> named_files(const std::string& bytes)
  {
    const std::string_view text = bytes.compare(0, 4, "glTF") == 0 ? json_of(bytes) : std::string_view(bytes);
    json_ = Json::parse(text.begin(), text.end(), nullptr, false);
    std::vector<std::string> files;
    std::error_code none;
    for(const Json& buffer : list(json_, "buffers"))
      if(const Json* const uri = find(buffer, "uri"); uri && uri->is_string())
        if(const auto& name = uri->get_ref<const std::string&>(); name.compare(0, 5, "data:") != 0)
          if(const std::optional<std::string> other = file_next_to(file_, name);
             other && std::filesystem::is_regular_file(*other, none) && std::ifstream(*other))
            files.push_back(*other);
    return files;
  }

private:
  /// The description in a binary file; the bytes behind it are noted.
  std::string_view json_of(const std::string& bytes)
  {
    constexpr std::uint64_t header = 12, chunk_header = 8;
    size_of_file_ = bytes.size();
    if(bytes.size() < header + chunk_header)
      refuse("cut short: the header is not complete", "export it again");
    if(number_at<std::uint32_t>(&bytes[4]) != 2)
      refuse("is of version " + std::to_string(number_at<std::uint32_t>(&bytes[4])) + " of the format",
             "save it as glTF 2.0");
    if(number_at<std::uint32_t>(&bytes[8]) > bytes.size())
      refuse("cut short: the header announces " + std::to_string(number_at<std::uint32_t>(&bytes[8])) +
               " bytes, the file has " + std::to_string(bytes.size()),
             "export it again");
    std::string_view json;
    for(std::uint64_t at = header; at + chunk_header <= bytes.size();) {
      const std::uint64_t size = number_at<std::uint32_t>(&bytes[at]);
      const std::string_view kind = std::string_view(bytes).substr(at + 4, 4);
      at += chunk_header;
      if(size > bytes.size() - at)
        refuse("cut short: a part of " + std::to_string(size) + " bytes ends after " +
                 std::to_string(bytes.size() - at),
               "export it again");
      const std::string_view chunk = std::string_view(bytes).substr(at, size);
      if(kind == "JSON" && json.empty())
        json = chunk;
      else if(kind == std::string_view("BIN\0", 4) && !binary_)
        binary_ = chunk;
      at += size;
    }
    return json;
  }

  Soup read_json(std::string_view text)
  {
    json_ = Json::parse(text.begin(), text.end(), nullptr, false);
    if(!json_.is_object())
      refuse("its description is no JSON");
    if(json_.contains("meshes") && json_["meshes"].is_object()) // named, not numbered
      refuse("is of version 1 of the format", "save it as glTF 2.0");
    for(const Json& extension : list(json_, "extensionsRequired")) {
      const std::string name = extension.is_string() ? extension.get<std::string>() : "";
      if(name == "KHR_draco_mesh_compression" || name == "EXT_meshopt_compression")
        refuse("is compressed with " + name, "export it without compression");
      const auto is_about = [&name](const char* what) { return name.find(what) != std::string::npos; };
      if(name != "KHR_mesh_quantization" && !is_about("_materials_") && !is_about("_texture_") && !is_about("_lights_"))
        refuse("requires the extension " + in_quotes(name) + ", which is not known", "export it without");
    }
    if(const Json* asset = find(json_, "asset"); asset && find(*asset, "minVersion"))
      if(const Json version = *find(*asset, "minVersion"); version != "2.0")
        refuse("requires version " + version.dump() + " of the format", "save it as glTF 2.0");
    read_scene();
    if(soup_.triangles.empty())
      throw Refusal(Error_code::EMPTY_MESH, file_, "has no triangles", "check that there is a mesh in it");
    soup_.faces = soup_.triangles.size();
    return std::move(soup_);
  }

  void read_scene()
  {
    if(list(json_, "scenes").empty())
      for(std::uint64_t mesh = 0; mesh < list(json_, "meshes").size(); ++mesh)
        read_mesh(mesh, Matrix::Identity());
    else
      for(const Json& node : list(element("scenes", number(json_, "scene", 0)), "nodes"))
        read_nodes(index(node));
  }

  /// The tree below a node. Not by recursion, since it may be as deep as the file is long.
  void read_nodes(std::uint64_t root)
  {
    std::vector<std::pair<std::uint64_t, Matrix>> open = {{root, Matrix::Identity()}};
    while(!open.empty()) {
      const auto [number_of_node, outer] = open.back();
      open.pop_back();
      const Json& node = element("nodes", number_of_node);
      if(!visited_.insert(number_of_node).second)
        refuse("node " + std::to_string(number_of_node) + " has two parents");
      Matrix matrix = transformation(node);
      for(int column = 0; column < 4; ++column)
        matrix.col(column) = product(outer, matrix.col(column));
      if(find(node, "mesh")) // whose place is that of its bones, and at rest its own, if it has any
        read_mesh(number(node, "mesh", 0), find(node, "skin") ? Matrix::Identity() : matrix);
      const Json& children = list(node, "children");
      for(auto child = children.rbegin(); child != children.rend(); ++child)
        open.emplace_back(index(*child), matrix);
    }
  }

  Matrix transformation(const Json& node) const
  {
    if(find(node, "matrix"))
      return Matrix(numbers<16>(node, "matrix", {}).data());
    const auto t = numbers<3>(node, "translation", {0, 0, 0});
    const auto r = numbers<4>(node, "rotation", {0, 0, 0, 1});
    const auto s = numbers<3>(node, "scale", {1, 1, 1});
    return (Eigen::Translation3d(t[0], t[1], t[2]) * Eigen::Quaterniond(r.data()) * Eigen::Scaling(s[0], s[1], s[2]))
      .matrix();
  }

  void read_mesh(std::uint64_t number_of_mesh, const Matrix& matrix)
  {
    const Json& mesh = element("meshes", number_of_mesh);
    const Json* primitives = find(mesh, "primitives");
    if(!primitives || !primitives->is_array())
      refuse("mesh " + std::to_string(number_of_mesh) + " has no primitives");
    std::map<std::uint64_t, std::vector<int>> vertices; // by accessor: primitives often share one
    for(const Json& primitive : *primitives) {
      constexpr std::uint64_t triangles = 4, fan = 6;
      const std::uint64_t mode = number(primitive, "mode", triangles);
      if(mode < triangles || mode > fan) // points and lines
        continue;
      const Json* attributes = find(primitive, "attributes");
      if(!attributes || !find(*attributes, "POSITION"))
        refuse("mesh " + std::to_string(number_of_mesh) + " has triangles without positions");
      const std::uint64_t accessor = number(*attributes, "POSITION", 0);
      const auto place = vertices.try_emplace(accessor);
      if(place.second)
        place.first->second = read_positions(accessor, matrix);
      add_triangles(primitive, mode, place.first->second, matrix.topLeftCorner<3, 3>().determinant() < 0);
    }
  }

  std::vector<int> read_positions(std::uint64_t number_of_accessor, const Matrix& matrix)
  {
    const View view = view_of(number_of_accessor, "VEC3", 12);
    if(view.component != 5126)
      refuse("its positions are no floats", "export it without quantization");
    count(view.count * 12);
    std::vector<int> result;
    result.reserve(view.count);
    for(std::uint64_t i = 0; i < view.count; ++i) {
      const auto at = [&](std::uint64_t k) -> double { return number_at<float>(&view.bytes[view.stride * i + 4 * k]); };
      const Eigen::Vector4d place = product(matrix, {at(0), at(1), at(2), 1});
      const std::array<double, 3> p = {place[0], place[1], place[2]};
      for(const double x : p)
        if(!std::isfinite(x))
          soup_.note_non_finite(file_, "vertex " + std::to_string(i) + " of accessor " +
                                         std::to_string(number_of_accessor) + " has the coordinate " +
                                         std::to_string(x));
      result.push_back(welded_.index_of(p));
    }
    return result;
  }

  void add_triangles(const Json& primitive, std::uint64_t mode, const std::vector<int>& vertices, bool is_mirrored)
  {
    std::vector<int> corners = vertices;
    if(find(primitive, "indices")) {
      const View view = view_of(number(primitive, "indices", 0), "SCALAR", 0);
      count(view.count * view.size);
      corners.clear();
      for(std::uint64_t i = 0; i < view.count; ++i) {
        const char* const at = &view.bytes[view.stride * i];
        const std::uint64_t corner = view.size == 1   ? number_at<std::uint8_t>(at)
                                     : view.size == 2 ? number_at<std::uint16_t>(at)
                                                      : number_at<std::uint32_t>(at);
        if(corner >= vertices.size())
          refuse("a triangle has the vertex " + std::to_string(corner) + " of " + std::to_string(vertices.size()));
        corners.push_back(vertices[corner]);
      }
    }
    std::uint64_t first = soup_.triangles.size();
    if(mode == 5)
      soup_.add_strip(corners);
    else
      for(std::uint64_t i = 0; i + 2 < corners.size(); i += mode == 4 ? 3 : 1)
        soup_.triangles.push_back({corners[mode == 6 ? 0 : i], corners[i + 1], corners[i + 2]});
    for(; is_mirrored && first < soup_.triangles.size(); ++first)
      std::swap(soup_.triangles[first][1], soup_.triangles[first][2]);
  }

  /// The bytes of an accessor, all of which are there.
  struct View {
    std::string_view bytes;
    std::uint64_t count = 0;     ///< of the elements; 64 bits, also where memory has 32: files may say anything
    std::uint64_t stride = 0;    ///< from one to the next, in bytes
    std::uint64_t size = 0;      ///< of one
    std::uint64_t component = 0; ///< type of the numbers
  };

  View view_of(std::uint64_t number_of_accessor, const char* type, std::uint64_t size)
  {
    const Json& accessor = element("accessors", number_of_accessor);
    const Json* kind = find(accessor, "type");
    if(!kind || *kind != type)
      refuse("accessor " + std::to_string(number_of_accessor) + " is no " + type);
    if(find(accessor, "sparse"))
      refuse("accessor " + std::to_string(number_of_accessor) + " is sparse", "export it without sparse accessors");
    if(!find(accessor, "bufferView"))
      refuse("accessor " + std::to_string(number_of_accessor) + " has no bufferView", "export it again");
    View result;
    result.component = number(accessor, "componentType", 0);
    result.count = number(accessor, "count", 0);
    result.size = size != 0                  ? size
                  : result.component == 5121 ? 1
                  : result.component == 5123 ? 2
                  : result.component == 5125 ? 4
                                             : 0;
    if(result.size == 0)
      refuse("accessor " + std::to_string(number_of_accessor) + " has indices of a wrong type");
    const Json& view = element("bufferViews", number(accessor, "bufferView", 0));
    const std::string_view buffer = buffer_of(number(view, "buffer", 0));
    const std::uint64_t offset = number(view, "byteOffset", 0), length = number(view, "byteLength", 0);
    const std::uint64_t begin = number(accessor, "byteOffset", 0);
    result.stride = number(view, "byteStride", result.size);
    // all numbers are below 2^40, so that products of two and of a stride below 2^8 do not overflow
    const bool fits = result.stride >= result.size && result.stride < 256 && offset + length <= buffer.size() &&
                      begin <= length &&
                      (result.count == 0 || begin + result.stride * (result.count - 1) + result.size <= length);
    if(!fits)
      refuse("cut short: accessor " + std::to_string(number_of_accessor) + " announces " +
             std::to_string(result.count) + " elements, more than its bytes can hold");
    result.bytes = buffer.substr(static_cast<std::size_t>(offset + begin));
    return result;
  }

  std::string_view buffer_of(std::uint64_t number_of_buffer)
  {
    const Json& buffer = element("buffers", number_of_buffer);
    const Json* uri = find(buffer, "uri");
    if(!uri) {
      if(number_of_buffer == 0 && binary_)
        return *binary_;
      refuse("the bytes of its mesh are missing");
    }
    if(!uri->is_string())
      refuse("buffer " + std::to_string(number_of_buffer) + " has no name");
    const auto [place, is_new] = buffers_.try_emplace(number_of_buffer);
    if(is_new)
      place->second = content_of(uri->get<std::string>());
    return place->second;
  }

  /// The bytes in the URI itself, or in a file next to this one.
  std::string content_of(const std::string& uri)
  {
    if(uri.compare(0, 5, "data:") == 0) {
      const std::size_t comma = uri.find(";base64,");
      std::optional<std::string> bytes;
      if(comma != std::string::npos)
        bytes = from_base64(std::string_view(uri).substr(comma + 8));
      if(!bytes)
        refuse("a buffer is no Base64 text");
      return std::move(*bytes);
    }
    const std::optional<std::string> name = file_next_to(file_, uri);
    if(!name)
      refuse("has its mesh in " + in_quotes(uri) + ", which is no file next to it", "save it as .glb");
    std::string bytes = read_file(*name);
    size_of_file_ += bytes.size();
    return bytes;
  }

  /// Refuses what uses the same bytes so often that a small file would fill the memory.
  void count(std::uint64_t bytes)
  {
    used_ += bytes;
    if(used_ > 2 * size_of_file_ + 1000)
      refuse("uses the same vertices or triangles several times, as no sphere does", "save the mesh alone");
    if(used_ > 4 * largest_count)
      refuse("is larger than this program can index", "simplify the mesh");
  }

  /// \name Access to JSON, of which nothing is certain
  /// @{
  static const Json* find(const Json& object, const char* key)
  {
    if(!object.is_object())
      return nullptr;
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
  }

  /// Empty if there is none.
  static const Json& list(const Json& object, const char* key)
  {
    static const Json none = Json::array();
    const Json* const found = find(object, key);
    return found && found->is_array() ? *found : none;
  }

  std::uint64_t index(const Json& value) const
  {
    if(!value.is_number_unsigned() || value.get<std::uint64_t>() >= std::uint64_t(1) << 40)
      refuse(std::string("its description has a ") + (value.is_number() ? "wrong number" : value.type_name()) +
             " where a number from 0 on is expected");
    return value.get<std::uint64_t>();
  }

  std::uint64_t number(const Json& object, const char* key, std::uint64_t default_value) const
  {
    const Json* const value = find(object, key);
    return value ? index(*value) : default_value;
  }

  template <std::size_t n>
  std::array<double, n> numbers(const Json& object, const char* key, const std::array<double, n>& default_value) const
  {
    const Json* const values = find(object, key);
    if(!values)
      return default_value;
    std::array<double, n> result;
    bool is_good = values->is_array() && values->size() == n;
    for(std::size_t i = 0; is_good && i < n; ++i) {
      is_good = (*values)[i].is_number();
      if(is_good)
        result[i] = (*values)[i].template get<double>();
    }
    if(!is_good)
      refuse(std::string("the ") + key + " of a node is wrong");
    return result;
  }

  const Json& element(const char* key, std::uint64_t i) const
  {
    const Json& all = list(json_, key);
    if(i >= all.size())
      refuse("number " + std::to_string(i) + " of its " + key + " is missing");
    return all[i];
  }
  /// @}

  [[noreturn]] void refuse(const std::string& wrong, const std::string& remedy = damaged) const
  {
    refuse_file(file_, wrong, remedy);
  }

  std::string file_;
  std::uint64_t size_of_file_ = 0;
  std::uint64_t used_ = 0; ///< bytes that have become vertices and triangles
  Json json_;
  std::optional<std::string_view> binary_;
  std::map<std::uint64_t, std::string> buffers_;
  std::set<std::uint64_t> visited_;
  Soup soup_;
  Welded_points welded_{soup_.points};
};

} // namespace

Soup read_glb(const std::string& file, std::string bytes) { return Gltf_reader(file).read_binary(bytes); }
Soup read_gltf(const std::string& file, std::string text) { return Gltf_reader(file).read_text(text); }

std::vector<std::string> files_of_mesh(const std::string& file)
{
  std::vector<std::string> files = {file};
  const std::optional<Mesh_format> format = format_of_name(file);
  if(format == Mesh_format::GLTF || format == Mesh_format::GLB)
    try {
      const std::vector<std::string> named = Gltf_reader(file).named_files(decompressed(file, read_file(file)));
      files.insert(files.end(), named.begin(), named.end());
    } catch(const Refusal&) { // damaged: who reads it will be told
    }
  return files;
}

} // namespace tool
