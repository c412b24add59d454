// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "input/compression.h"
#include "input/text_lines.h"
#include "output/text_writer.h"
#include "output/write_mesh.h"
#include "output/write_vertex_data.h"
#include "system/refusal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <sstream>

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

void write_metadata(std::ostream& out, const Annotations::Metadata& metadata)
{
  out << "<MetaData>\n";
  for(const auto& [name, value] : metadata)
    out << "<MD><Name>" << xml_escaped(name) << "</Name><Value>" << xml_escaped(value) << "</Value></MD>\n";
  out << "</MetaData>\n";
}

void begin_file(std::ostream& out, std::size_t arrays, const Annotations::Metadata& metadata)
{
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<!DOCTYPE GIFTI SYSTEM \"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n"
         "<GIFTI Version=\"1.0\" NumberOfDataArrays=\""
      << arrays << "\">\n";
  write_metadata(out, metadata);
}

/// Rows of three, or of one.
void begin_array(std::ostream& out, const char* intent, const char* type, std::size_t rows, bool has_columns = true)
{
  out << "<DataArray Intent=\"" << intent << "\" DataType=\"" << type
      << "\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"" << (has_columns ? 2 : 1) << "\" Dim0=\"" << rows
      << (has_columns ? "\" Dim1=\"3" : "")
      << "\" Encoding=\"GZipBase64Binary\" Endian=\"LittleEndian\" ExternalFileName=\"\" ExternalFileOffset=\"\">\n";
}

void end_array(std::ostream& out, const std::string& bytes)
{
  out << "<Data>" << to_base64(to_zlib(bytes)) << "</Data>\n</DataArray>\n";
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
  begin_file(out, 2, annotations.gifti);
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
    out << "<CoordinateSystemTransformMatrix>\n<DataSpace>" << xml_escaped(from) << "</DataSpace>\n<TransformedSpace>"
        << xml_escaped(to) << "</TransformedSpace>\n<MatrixData>" << xml_escaped(matrix)
        << "</MatrixData>\n</CoordinateSystemTransformMatrix>\n";
  end_array(out, bytes);

  bytes.clear();
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    for(const int corner : mesh.triangle(f))
      append_number(bytes, corner);
  begin_array(out, "NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", mesh.number_of_faces());
  write_metadata(out, surface == Surface::SPHERE ? Annotations::Metadata{{"TopologicalType", "Closed"}}
                                                 : Annotations::Metadata()); // shapes may have holes
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

void write_gifti_data(std::ostream& out, const std::string& file, const Vertex_data& data, Data_format format,
                      const Annotations& annotations)
{
  const bool are_labels = format == Data_format::LABEL_GII;
  Annotations::Metadata metadata; // of which hemisphere they are
  for(const auto& entry : annotations.gifti_points)
    if(entry.first == "AnatomicalStructurePrimary")
      metadata.push_back(entry);
  begin_file(out, data.size(), metadata);
  std::map<int, Label> table;
  for(const Vertex_column& column : data)
    for(const Label& label : column.table)
      if(const auto [known, is_new] = table.emplace(label.key, label); !is_new && known->second.name != label.name)
        throw Refusal(unwritable_data, file,
                      "the format has one table, and the key " + std::to_string(label.key) + " stands for " +
                        in_quotes(known->second.name) + " and for " + in_quotes(label.name),
                      "write these columns one by one, or as .csv");
  if(are_labels && table.empty()) // a key that is not in a table is no label; without one nobody can tell
    table[0] = {0, "???", {0, 0, 0, 0}};
  int none = -1;
  while(table.count(none) > 0)
    --none;
  {
    Text_writer write(out);
    write("<LabelTable>\n");
    for(const auto& [key, label] : table) {
      const auto& [red, green, blue, alpha] = label.rgba;
      write("<Label Key=\"", key, "\" Red=\"", red, "\" Green=\"", green, "\" Blue=\"", blue, "\" Alpha=\"", alpha,
            "\">", xml_escaped(label.name), "</Label>\n");
    }
    write("</LabelTable>\n");
  }
  for(const Vertex_column& column : data) {
    begin_array(out,
                are_labels                         ? "NIFTI_INTENT_LABEL"
                : format == Data_format::SHAPE_GII ? "NIFTI_INTENT_SHAPE"
                                                   : "NIFTI_INTENT_NONE",
                are_labels ? "NIFTI_TYPE_INT32" : "NIFTI_TYPE_FLOAT32", column.values.size(), false);
    write_metadata(out, {{"Name", column.name}});
    std::string bytes;
    for(const double value : column.values)
      if(are_labels)
        append_number(bytes, std::int32_t(key_of(value, none)));
      else
        append_number(bytes, static_cast<float>(value));
    end_array(out, bytes);
  }
  out << "</GIFTI>\n";
}

void write_curv(std::ostream& out, const Vertex_column& column)
{
  out << "\xff\xff\xff";
  Byte_writer write(out, Byte_order::BIG);
  write(static_cast<std::int32_t>(column.values.size()));
  write(std::array<std::int32_t, 2>{0, 1}); // faces, which readers do not need, and values per vertex
  for(const double value : column.values)
    write(static_cast<float>(value));
}

void write_annot(std::ostream& out, const std::string& file, const Vertex_column& column)
{
  std::map<int, std::int32_t> colours; // by keys
  std::map<std::int32_t, std::string> names;
  std::map<int, Label> by_key;
  for(const Label& label : column.table)
    by_key.emplace(label.key, label);
  std::ostringstream table;
  {
    Byte_writer write(table, Byte_order::BIG);
    for(const auto& [key, label] : by_key) {
      std::array<std::int32_t, 4> rgb;
      for(std::size_t k = 0; k < 4; ++k) {
        const float share = std::fmin(1.F, std::fmax(0.F, label.rgba[k]));
        rgb[k] = static_cast<std::int32_t>(std::lround(255 * (k < 3 ? share : 1 - share)));
      }
      const std::int32_t colour = rgb[0] | rgb[1] << 8 | rgb[2] << 16;
      const auto [known, is_new] = names.emplace(colour, label.name);
      if(!is_new)
        throw Refusal(unwritable_data, file,
                      "the labels " + in_quotes(known->second) + " and " + in_quotes(label.name) +
                        " have the same colour, by which the format tells them apart",
                      "write .label.gii or .csv");
      write(static_cast<std::int32_t>(colours.size())); // some readers count the entries, whatever stands here
      colours[key] = colour;
      write(static_cast<std::int32_t>(label.name.size() + 1));
      for(const char c : label.name + '\0')
        write(c);
      write(rgb);
    }
  }
  Byte_writer write(out, Byte_order::BIG);
  write(static_cast<std::int32_t>(column.values.size()));
  for(std::size_t v = 0; v < column.values.size(); ++v) {
    const auto colour = std::isnan(column.values[v]) ? colours.end() : colours.find(key_of(column.values[v]));
    write(static_cast<std::int32_t>(v));
    write(colour == colours.end() ? 0 : colour->second); // as FreeSurfer marks what has none
  }
  write(std::array<std::int32_t, 2>{1, -2}); // there is a table, of version 2
  write(static_cast<std::int32_t>(colours.size()));
  write(std::int32_t(1)); // the name of a file, which is empty
  write('\0');
  write(static_cast<std::int32_t>(colours.size()));
  for(const char c : table.str())
    write(c);
}

} // namespace tool
