// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/mesh.h"

#include "input/compression.h"
#include "input/files.h"
#include "input/mesh_format.h"
#include "system/refusal.h"

#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <utility>

namespace tool {

namespace {

namespace fs = std::filesystem;

void refuse_unknown(const std::string& file)
{
  const std::string extension = lower_case_extension(file);
  refuse_file(file,
              extension.empty() ? "has no extension, and an unknown content"
                                : "has the unknown extension '" + extension + "', and an unknown content",
              std::string("meshes are read from ") + mesh_extensions + " files");
}

/// In the order of `Mesh_format`.
constexpr Soup (*readers[])(const std::string& file, std::string content) = {
  read_off, read_obj,     read_ply,     read_stl, read_gifti, read_freesurfer,
  read_vtk, read_vtk_xml, read_vtk_xml, read_glb, read_gltf,  read_mni};
static_assert(std::size(readers) == static_cast<std::size_t>(Mesh_format::MNI) + 1);

} // namespace

Annotations in_space_of(const Annotations& other, Annotations own)
{
  own.freesurfer = other.freesurfer;
  own.gifti_transforms = other.gifti_transforms;
  const auto is_of_space = [](const auto& entry) { return entry.first.compare(0, 7, "VolGeom") == 0; };
  auto& points = own.gifti_points;
  points.erase(std::remove_if(points.begin(), points.end(), is_of_space), points.end());
  std::copy_if(other.gifti_points.begin(), other.gifti_points.end(), std::back_inserter(points), is_of_space);
  return own;
}

bool is_format_known(const std::string& file)
{
  constexpr std::size_t beginning = 4096;
  if(file == standard_stream || format_of_name(file))
    return true;
  const std::string bytes = read_beginning(file, beginning);
  return compression_of_content(bytes) != Compression::NONE || format_of_content(bytes, fs::file_size(file));
}

void check_triangles(const std::string& file, const Soup& soup, const std::string& remedy)
{
  if(!soup.polygons.empty())
    throw Refusal(Error_code::NOT_TRIANGULAR, file,
                  "has " + std::to_string(soup.polygons.size()) +
                    (soup.polygons.size() == 1 ? " face that is no triangle" : " faces that are no triangles") +
                    " (first: face " + std::to_string(soup.polygons[0].face) + " with " +
                    std::to_string(soup.polygons[0].corners) + " vertices)",
                  remedy);
}

void refuse_point_cloud(const std::string& file, std::size_t vertices)
{
  throw Refusal(Error_code::EMPTY_MESH, file, "has " + std::to_string(vertices) + " vertices, but no faces",
                "a point cloud cannot be mapped; reconstruct a surface first");
}

int checked_corner(const std::string& file, std::size_t face, double corner, std::size_t number_of_vertices)
{
  if(!(corner >= 0 && corner < static_cast<double>(number_of_vertices) && corner == std::floor(corner))) {
    std::ostringstream number;
    number.precision(15);
    number << corner;
    refuse_file(file, "face " + std::to_string(face) + " has the vertex " + number.str() +
                        ", which is not in the range 0.." + std::to_string(std::int64_t(number_of_vertices) - 1));
  }
  return static_cast<int>(corner);
}

Soup read_soup(const std::string& file, std::string bytes, Coordinates coordinates)
{
  bytes = decompressed(file, std::move(bytes));
  auto format = format_of_content(bytes, bytes.size());
  if(!format)
    format = format_of_name(file);
  if(!format)
    refuse_unknown(file);
  Soup soup = readers[static_cast<std::size_t>(*format)](file, std::move(bytes));
  number_equal_names(soup.data);
  cut_polygons(soup);
  if(soup.non_finite && coordinates == Coordinates::FINITE)
    throw Refusal(*soup.non_finite);
  return soup;
}

Soup read_triangles(const std::string& file, Coordinates coordinates)
{
  check_readable(file);
  if(!is_format_known(file)) // before it costs memory
    refuse_unknown(file);
  return read_soup(file, read_file(file), coordinates);
}

Input_mesh read_mesh(const std::string& file, Polygons polygons, const std::string& how_to_mend,
                     const std::string& how_to_cut)
{
  Soup soup = read_triangles(file);
  if(polygons == Polygons::REFUSE)
    check_triangles(file, soup, how_to_cut);
  try {
    return {Mesh(CGAL::Parallel_if_available_tag(), std::move(soup.points), std::move(soup.triangles)),
            soup.polygons.size(), std::move(soup.annotations), std::move(soup.data)};
  } catch(const SP::Error& error) {
    const bool has_mesh = error.code() != Error_code::EMPTY_MESH && error.code() != Error_code::TOO_LARGE;
    throw Refusal(error.code(), file, "has " + error.detail(), has_mesh ? how_to_mend : "");
  }
}

} // namespace tool
