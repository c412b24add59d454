// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "input/binary.h"
#include "output/volume_geometry.h"
#include "output/write_mesh.h"

#include <zlib.h>

#include <algorithm>
#include <new>

namespace tool {
namespace {

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

} // namespace tool
