// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/binary.h"
#include "input/text_lines.h"
#include "output/write_mesh.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <new>

namespace tool {
namespace {

/// How the volume lies that a surface was made from: FreeSurfer says it in lines "key = a b c" behind the triangles of
/// its own files, and in GIFTI by entries of these names of the points.
struct Line {
  std::string_view key;
  std::array<const char*, 3> names;
};

constexpr Line lines[] = {{"volume", {"VolGeomWidth", "VolGeomHeight", "VolGeomDepth"}},
                          {"voxelsize", {"VolGeomXsize", "VolGeomYsize", "VolGeomZsize"}},
                          {"xras", {"VolGeomX_R", "VolGeomX_A", "VolGeomX_S"}},
                          {"yras", {"VolGeomY_R", "VolGeomY_A", "VolGeomY_S"}},
                          {"zras", {"VolGeomZ_R", "VolGeomZ_A", "VolGeomZ_S"}},
                          {"cras", {"VolGeomC_R", "VolGeomC_A", "VolGeomC_S"}}};

/// The three words behind "key =" in the first line that begins so; empty ones if there are not three.
std::array<std::string, 3> values_of(std::string_view text, std::string_view key)
{
  while(!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if(next_token(line) != key || next_token(line) != "=")
      continue;
    std::array<std::string, 3> values;
    for(std::string& value : values)
      value = next_token(line);
    return values;
  }
  return {};
}

const std::string* value_of(const Annotations::Metadata& metadata, std::string_view name)
{
  const auto found =
    std::find_if(metadata.begin(), metadata.end(), [=](const auto& entry) { return entry.first == name; });
  return found == metadata.end() ? nullptr : &found->second;
}

/// The metadata of the points for a GIFTI file, with the geometry that a file of FreeSurfer has.
Annotations::Metadata gifti_points_with_geometry(const Annotations& annotations)
{
  Annotations::Metadata metadata = annotations.gifti_points;
  const std::string_view tags = annotations.freesurfer;
  const std::size_t begin = tags.find("valid = 1");
  if(begin == std::string_view::npos || value_of(metadata, lines[0].names[0]))
    return metadata;
  for(const Line& line : lines) {
    const auto values = values_of(tags.substr(begin), line.key);
    if(values.back().empty())
      return annotations.gifti_points; // not complete
    for(std::size_t k = 0; k < 3; ++k)
      metadata.emplace_back(line.names[k], values[k]);
  }
  return metadata;
}

/// The bytes behind the triangles for a file of FreeSurfer, with the geometry that a GIFTI file has.
std::string freesurfer_tags(const Annotations& annotations)
{
  if(!annotations.freesurfer.empty())
    return annotations.freesurfer;
  std::string tags;
  constexpr std::int32_t use_real_ras = 2, no = 0, surface_geometry = 20;
  for(const std::int32_t number : {use_real_ras, no, surface_geometry})
    append_number(tags, number, Byte_order::BIG);
  tags += "valid = 1  # volume info valid\nfilename = unknown\n";
  for(const Line& line : lines) {
    tags += std::string(line.key) + " =";
    for(const char* name : line.names) {
      const std::string* const value = value_of(annotations.gifti_points, name);
      if(!value)
        return "";
      tags += ' ' + *value;
    }
    tags += '\n';
  }
  return tags;
}

std::string escaped(const std::string& text)
{
  std::string result;
  for(const char c : text)
    switch(c) {
    case '&': result += "&amp;"; break;
    case '<': result += "&lt;"; break;
    case '>': result += "&gt;"; break;
    default: result += c;
    }
  return result;
}

void write_metadata(std::ostream& out, const Annotations::Metadata& metadata)
{
  out << "<MetaData>\n";
  for(const auto& [name, value] : metadata)
    out << "<MD><Name>" << escaped(name) << "</Name><Value>" << escaped(value) << "</Value></MD>\n";
  out << "</MetaData>\n";
}

/// The bytes as text: zlib's format in Base64. Numbers of a mesh hardly shrink more where it takes longer.
std::string as_text(const std::string& bytes)
{
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string compressed(size, '\0');
  if(compress2(reinterpret_cast<Bytef*>(compressed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
               static_cast<uLong>(bytes.size()), Z_BEST_SPEED) != Z_OK)
    throw std::bad_alloc(); // there is no other reason
  compressed.resize(size);
  return to_base64(compressed);
}

void begin_array(std::ostream& out, const char* intent, const char* type, std::size_t rows)
{
  out << "<DataArray Intent=\"" << intent << "\" DataType=\"" << type
      << "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"2\" Dim0=\"" << rows
      << "\" Dim1=\"3\" Encoding=\"GZipBase64Binary\" Endian=\"LittleEndian\" ExternalFileName=\"\" "
         "ExternalFileOffset=\"\">\n";
}

void end_array(std::ostream& out, const std::string& bytes)
{
  out << "<Data>" << as_text(bytes) << "</Data>\n</DataArray>\n";
}

/// What the programs of the field call a surface that is a sphere.
Annotations::Metadata metadata_of_points(Annotations::Metadata metadata, Surface surface)
{
  if(surface == Surface::SHAPE)
    return metadata;
  const auto is_about_form = [](const auto& entry) {
    return entry.first == "GeometricType" || entry.first == "AnatomicalStructureSecondary";
  };
  metadata.erase(std::remove_if(metadata.begin(), metadata.end(), is_about_form), metadata.end());
  metadata.emplace_back("GeometricType", "Spherical");
  return metadata;
}

} // namespace

void write_gifti(std::ostream& out, const Mesh& mesh, const std::vector<Point>& points, Surface surface,
                 const Annotations& annotations)
{
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
         "<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">\n";
  write_metadata(out, annotations.gifti);
  out << "<LabelTable/>\n";

  std::string bytes;
  for(const Point& p : points)
    for(const double x : as_stored(Mesh_format::GIFTI, surface, p))
      append_number(bytes, static_cast<float>(x));
  begin_array(out, "NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT32", points.size());
  write_metadata(out, metadata_of_points(gifti_points_with_geometry(annotations), surface));
  auto transforms = annotations.gifti_transforms;
  if(transforms.empty())
    transforms.push_back({"NIFTI_XFORM_UNKNOWN", "NIFTI_XFORM_UNKNOWN", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"});
  for(const auto& [from, to, matrix] : transforms)
    out << "<CoordinateSystemTransformMatrix>\n<DataSpace>" << escaped(from) << "</DataSpace>\n<TransformedSpace>"
        << escaped(to) << "</TransformedSpace>\n<MatrixData>" << escaped(matrix)
        << "</MatrixData>\n</CoordinateSystemTransformMatrix>\n";
  end_array(out, bytes);

  bytes.clear();
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(const int corner : mesh.triangle(f))
      append_number(bytes, corner);
  begin_array(out, "NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", mesh.number_of_faces());
  write_metadata(out, {{"TopologicalType", "Closed"}});
  end_array(out, bytes);
  out << "</GIFTI>\n";
}

void write_freesurfer(std::ostream& out, const Mesh& mesh, const std::vector<Point>& points, Surface surface,
                      const Annotations& annotations)
{
  out << "\xff\xff\xfe"
         "created by spherical-parameterization\n\n";
  {
    Byte_writer write(out, Byte_order::BIG);
    write(static_cast<std::int32_t>(points.size()));
    write(static_cast<std::int32_t>(mesh.number_of_faces()));
    for(const Point& p : points)
      for(const double x : as_stored(Mesh_format::FREESURFER, surface, p))
        write(static_cast<float>(x));
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
      write(mesh.triangle(f));
  }
  out << freesurfer_tags(annotations);
}

} // namespace tool
