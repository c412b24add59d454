// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "output/texture_places.h"
#include "output/write_mesh.h"

#include <CGAL/boost/graph/iterator.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace tool {
namespace {

using Json = nlohmann::ordered_json;
using Vector = std::array<double, 3>;

/// Unit normals of the vertices: means of those of the faces, weighted by area.
std::vector<Vector> normals_of(const Mesh& mesh, const std::vector<Point>& points)
{
  std::vector<Vector> normals(points.size(), Vector{0, 0, 0});
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto& corners = mesh.triangle(f);
    const auto edge = [&](std::size_t k, std::size_t axis) {
      return points[std::size_t(corners[k])][axis] - points[std::size_t(corners[0])][axis];
    };
    for(std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
      const double outer = edge(1, y) * edge(2, z) - edge(1, z) * edge(2, y);
      for(const int corner : corners)
        normals[std::size_t(corner)][axis] += outer;
    }
  }
  for(Vector& n : normals) {
    const double length = std::hypot(n[0], n[1], n[2]);
    n = std::isnormal(length) ? Vector{n[0] / length, n[1] / length, n[2] / length} : Vector{0, 0, 1};
  }
  return normals;
}

/// Builds a file of one mesh: a description in JSON and one buffer of bytes.
class Gltf_writer {
public:
  explicit Gltf_writer(const Mesh& mesh, const std::vector<Point>& points) : mesh_(mesh), points_(points)
  {
    json_ = Json::parse(R"({"asset": {"version": "2.0", "generator": "spherical-parameterization"},
                            "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                            "meshes": [{"primitives": [{"attributes": {}}]}]})");
  }

  /// `vertices` are those of the mesh by number, each as often as it is to occur; `corners` has three numbers of them
  /// per face.
  void add_surface(const std::vector<int>& vertices, const std::vector<std::uint32_t>& corners)
  {
    const auto add_vectors = [&](const char* attribute, const std::vector<Vector>& of_vertices) {
      constexpr float infinity = std::numeric_limits<float>::infinity();
      std::array<float, 3> low = {infinity, infinity, infinity}, high = {-infinity, -infinity, -infinity};
      for(const int v : vertices)
        for(std::size_t k = 0; k < 3; ++k) {
          const float x = static_cast<float>(of_vertices[std::size_t(v)][k]);
          append_number(bytes_, x);
          low[k] = std::min(low[k], x);
          high[k] = std::max(high[k], x);
        }
      const std::size_t accessor = add_accessor(float_numbers, "VEC3", vertices.size(), array_buffer);
      json_["accessors"][accessor]["min"] = low;
      json_["accessors"][accessor]["max"] = high;
      attributes()[attribute] = accessor;
    };
    add_vectors("POSITION", points_);
    add_vectors("NORMAL", normals_of(mesh_, points_));
    for(const std::uint32_t corner : corners)
      append_number(bytes_, corner);
    primitive()["indices"] = add_accessor(unsigned_numbers, "SCALAR", corners.size(), element_buffer);
  }

  /// Positions of the same vertices in an image, which is a file.
  void add_texture(const std::vector<Uv>& uv, const std::string& image)
  {
    for(const auto& [u, v] : uv) {
      append_number(bytes_, static_cast<float>(u));
      append_number(bytes_, static_cast<float>(1 - v)); // counted from above
    }
    attributes()["TEXCOORD_0"] = add_accessor(float_numbers, "VEC2", uv.size(), array_buffer);
    bytes_ += image;
    json_["images"][0]["bufferView"] = add_view();
    json_["images"][0]["mimeType"] = type_of_image(image);
    json_["samplers"] =
      Json::parse(R"([{"wrapS": 10497, "wrapT": 10497, "magFilter": 9729, "minFilter": 9987}])"); // repeat
    json_["textures"] = Json::parse(R"([{"sampler": 0, "source": 0}])");
    json_["materials"] = Json::parse(R"([{"pbrMetallicRoughness":
      {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": 1}}])");
    primitive()["material"] = 0;
  }

  void write(std::ostream& out, Mesh_format format)
  {
    Json buffer = {{"byteLength", bytes_.size()}};
    if(format == Mesh_format::GLTF)
      buffer["uri"] = "data:application/octet-stream;base64," + to_base64(bytes_);
    json_["buffers"] = Json::array({buffer});
    std::string text = json_.dump();
    if(format == Mesh_format::GLTF) {
      out << text << '\n';
      return;
    }
    text.append((4 - text.size() % 4) % 4, ' '); // the parts begin at multiples of four
    const std::size_t size = 12 + 8 + text.size() + 8 + bytes_.size();
    if(size > std::numeric_limits<std::uint32_t>::max())
      throw std::length_error("a GLB file cannot hold more than 4 GB; write .ply");
    std::string header = "glTF", size_of_bytes;
    for(const std::size_t number : {std::size_t(2), size, text.size()})
      append_number(header, static_cast<std::uint32_t>(number));
    append_number(size_of_bytes, static_cast<std::uint32_t>(bytes_.size()));
    out << header << "JSON" << text << size_of_bytes << std::string_view("BIN\0", 4) << bytes_;
  }

private:
  static constexpr int float_numbers = 5126, unsigned_numbers = 5125, array_buffer = 34962, element_buffer = 34963;

  Json& primitive() { return json_["meshes"][0]["primitives"][0]; }
  Json& attributes() { return primitive()["attributes"]; }

  /// Of the bytes that have been added since the last one.
  std::size_t add_view(int target = 0)
  {
    Json view = {{"buffer", 0}, {"byteOffset", begin_}, {"byteLength", bytes_.size() - begin_}};
    if(target != 0)
      view["target"] = target;
    json_["bufferViews"].push_back(view); // null becomes an array
    bytes_.append((4 - bytes_.size() % 4) % 4, '\0');
    begin_ = bytes_.size();
    return json_["bufferViews"].size() - 1;
  }

  std::size_t add_accessor(int component, const char* type, std::size_t count, int target)
  {
    const Json accessor = {
      {"bufferView", add_view(target)}, {"componentType", component}, {"count", count}, {"type", type}};
    json_["accessors"].push_back(accessor);
    return json_["accessors"].size() - 1;
  }

  const Mesh& mesh_;
  const std::vector<Point>& points_;
  Json json_;
  std::string bytes_;
  std::size_t begin_ = 0; ///< of the bytes that belong to no view yet
};

} // namespace

std::string type_of_image(const std::string& image)
{
  if(image.compare(0, 8, "\x89PNG\r\n\x1a\n") == 0)
    return "image/png";
  return image.compare(0, 3, "\xff\xd8\xff") == 0 ? "image/jpeg" : "";
}

void write_gltf(std::ostream& out, Mesh_format format, const Mesh& mesh, const std::vector<Point>& points)
{
  std::vector<int> vertices(points.size());
  std::iota(vertices.begin(), vertices.end(), 0);
  std::vector<std::uint32_t> corners;
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(const int v : mesh.triangle(f))
      corners.push_back(static_cast<std::uint32_t>(v));
  Gltf_writer writer(mesh, points);
  writer.add_surface(vertices, corners);
  writer.write(out, format);
}

void write_textured_gltf(std::ostream& out, const Output_format& format, const Mesh& mesh, const std::vector<Uv>& uv,
                         const std::string& image)
{
  check_floats(format, mesh.points());
  const Texture_places places(mesh, uv);
  std::vector<std::uint32_t> corners;
  for(const Mesh::Face_index f : faces(mesh))
    for(const Mesh::Halfedge_index h : CGAL::halfedges_around_face(halfedge(f, mesh), mesh))
      corners.push_back(places.number[std::size_t(h.idx())]);
  Gltf_writer writer(mesh, mesh.points());
  writer.add_surface(places.vertex, corners);
  writer.add_texture(places.place, image);
  writer.write(out, format.format);
}

} // namespace tool
