// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/mesh_format.h"

#include "input/binary.h"
#include "input/compression.h"
#include "input/text_lines.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iterator>

namespace tool {
namespace {

struct Format {
  Mesh_format format;
  std::string_view name;
  std::string_view extension; ///< none: FreeSurfer's files are known by how their names begin, MNI's by their content
};

constexpr Format formats[] = {
  {Mesh_format::OFF, "off", ".off"}, {Mesh_format::OBJ, "obj", ".obj"},     {Mesh_format::PLY, "ply", ".ply"},
  {Mesh_format::STL, "stl", ".stl"}, {Mesh_format::GIFTI, "gifti", ".gii"}, {Mesh_format::FREESURFER, "freesurfer", ""},
  {Mesh_format::VTK, "vtk", ".vtk"}, {Mesh_format::VTP, "vtp", ".vtp"},     {Mesh_format::VTU, "vtu", ".vtu"},
  {Mesh_format::GLB, "glb", ".glb"}, {Mesh_format::GLTF, "gltf", ".gltf"},  {Mesh_format::MNI, "mni", ""}};

bool begins_with(std::string_view text, std::string_view start) { return text.substr(0, start.size()) == start; }

bool contains(std::string_view text, std::string_view part) { return text.find(part) != std::string_view::npos; }

/// Formats whose files begin with a word or number of their own.
std::optional<Mesh_format> format_of_magic(std::string_view bytes)
{
  using namespace std::string_view_literals;
  for(const std::string_view magic : {"\xff\xff\xfe"sv, "\xff\xff\xff"sv, "\xff\xff\xfd"sv})
    if(begins_with(bytes, magic)) // the latter two are those of quadrangles
      return Mesh_format::FREESURFER;
  if(begins_with(bytes, "glTF"))
    return Mesh_format::GLB;
  bytes = without_mark(bytes);
  std::string_view rest = bytes.substr(0, 64);
  const std::string_view word = next_token(rest);
  if(word == "ply")
    return Mesh_format::PLY;
  if(without_off_columns(word) == "OFF")
    return Mesh_format::OFF;
  const std::string_view start = bytes.substr(0, 4096);
  if(begins_with(word, "<") && contains(start, "<GIFTI"))
    return Mesh_format::GIFTI;
  if(begins_with(word, "<") && contains(start, "<VTKFile"))
    return contains(start, "\"UnstructuredGrid\"") ? Mesh_format::VTU : Mesh_format::VTP;
  if(begins_with(bytes, "# vtk DataFile"))
    return Mesh_format::VTK;
  if(begins_with(word, "{") && (contains(bytes, "\"asset\"") || contains(bytes, "\"accessors\"")))
    return Mesh_format::GLTF;
  double number = 0;
  if(word == "P" && to_number(next_token(rest), number) != Number::NONE)
    return Mesh_format::MNI;
  return std::nullopt;
}

/// 84 bytes of header, the last four of which are the number of triangles, and 50 bytes each. One triangle at least.
bool is_binary_stl(std::string_view bytes, std::size_t size)
{
  if(bytes.size() < 84)
    return false;
  const auto triangles = number_at<std::uint32_t>(&bytes[80]);
  return triangles > 0 && size == 84 + std::size_t(50) * triangles;
}

/// The first line that says something, as tokens.
std::vector<std::string_view> first_statement(std::string_view text)
{
  std::vector<std::string_view> tokens;
  while(!text.empty() && tokens.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    std::string_view line = text.substr(0, end);
    line = line.substr(0, line.find('#'));
    if(line.substr(0, 1) == "$") // a comment, too, in OBJ files of Viewpoint DataLabs
      line = {};
    for(std::string_view token = next_token(line); !token.empty(); token = next_token(line))
      tokens.push_back(token);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return tokens;
}

bool is_obj(std::string_view text)
{
  const std::vector<std::string_view> tokens = first_statement(text);
  if(tokens.size() < 2)
    return false;
  const auto is_one_of = [&](std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), tokens[0]) != words.end();
  };
  double number = 0;
  return is_one_of({"mtllib", "usemtl", "o", "g"}) ||
         (is_one_of({"v", "vt", "vn"}) && to_number(tokens[1], number) != Number::NONE);
}

bool is_text_stl(std::string_view text)
{
  std::string_view rest = text;
  return lower_case(next_token(rest)) == "solid" && contains(lower_case(text.substr(0, 4096)), "facet");
}

} // namespace

std::string extension_of_format(const std::string& name)
{
  const auto found =
    std::find_if(std::begin(formats), std::end(formats), [&](const Format& f) { return f.name == name; });
  return std::string(found->extension);
}

bool is_written(Mesh_format format)
{
  return format != Mesh_format::STL && format != Mesh_format::VTU && format != Mesh_format::MNI;
}

std::vector<std::pair<std::string, Mesh_format>> output_formats()
{
  std::vector<std::pair<std::string, Mesh_format>> list;
  for(const Format& f : formats)
    if(is_written(f.format))
      list.emplace_back(f.name, f.format);
  return list;
}

std::optional<Mesh_format> format_of_name(const std::string& file)
{
  const std::filesystem::path path = without_compression(file);
  const std::string extension = lower_case(path.extension().string());
  for(const Format& f : formats)
    if(!f.extension.empty() && extension == f.extension)
      return f.format;
  const std::string filename = path.filename().string();
  return begins_with(filename, "lh.") || begins_with(filename, "rh.") ? std::optional(Mesh_format::FREESURFER)
                                                                      : std::nullopt;
}

std::optional<Mesh_format> format_of_content(std::string_view bytes, std::size_t size)
{
  const auto by_magic = format_of_magic(bytes);
  if(by_magic)
    return by_magic;
  if(is_binary_stl(bytes, size) || is_text_stl(bytes))
    return Mesh_format::STL;
  return is_obj(bytes) ? std::optional(Mesh_format::OBJ) : std::nullopt;
}

std::string_view without_off_columns(std::string_view word)
{
  for(int columns = 0; columns < 3; ++columns)
    for(const std::string_view column : {"C", "N", "ST"})
      if(begins_with(word, column))
        word.remove_prefix(column.size());
  return word;
}

std::string without_extension(const std::string& file)
{
  const bool has_none = format_of_name(file) == Mesh_format::FREESURFER && without_compression(file) == file;
  return has_none ? file : std::filesystem::path(file).replace_extension().string();
}

bool stores_floats(Mesh_format format)
{
  return format == Mesh_format::GIFTI || format == Mesh_format::FREESURFER || format == Mesh_format::GLB ||
         format == Mesh_format::GLTF;
}

double radius_of_spheres(Mesh_format format)
{
  return format == Mesh_format::GIFTI || format == Mesh_format::FREESURFER ? 100 : 1;
}

std::string list_of_formats()
{
  std::string read, written, compressions, lacking;
  const auto append = [](std::string& list, std::string_view word, const char* between = ", ") {
    list += (list.empty() ? "" : between) + std::string(word);
  };
  for(const Format& f : formats) {
    append(read, f.name);
    if(is_written(f.format))
      append(written, f.name);
  }
  for(const std::string& extension : compression_extensions())
    append(compressions, extension);
#ifndef SPHERICAL_PARAMETERIZATION_WITH_COMPRESSION
  append(lacking, compressions + " but for reading .gz (they need libboost-iostreams-dev)");
  compressions.clear();
#endif
  return "Meshes are read from " + read + ",\n and written to " + written +
         (compressions.empty() ? "" : ";\n also compressed: " + compressions) +
         (lacking.empty() ? "" : ".\nNot in this build: " + lacking) + ".";
}

} // namespace tool
