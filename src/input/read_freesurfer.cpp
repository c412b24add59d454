// SPDX-License-Identifier: LGPL-3.0-or-later

#include "input/binary.h"
#include "input/mesh_readers.h"

#include <cstdint>

namespace tool {
namespace {

constexpr std::size_t magic_size = 3;

/// Where the second of the two lines ends that say who has written the file.
std::size_t end_of_comment(const std::string& file, const std::string& bytes)
{
  std::size_t end = magic_size;
  for(int line = 0; line < 2; ++line) {
    end = bytes.find('\n', end);
    if(end == std::string::npos)
      refuse_file(file, "cut short: the two lines of comment of a FreeSurfer surface have no end", "export it again");
    ++end;
  }
  return end;
}

} // namespace

/// The format of triangles, of B. Fischl and others: https://surfer.nmr.mgh.harvard.edu/fswiki/FileFormats
Soup read_freesurfer(const std::string& file, std::string bytes)
{
  if(bytes.compare(0, magic_size, "\xff\xff\xfe") != 0)
    refuse_file(file, "does not begin as a FreeSurfer surface of triangles", "convert it with mris_convert");
  const std::size_t counts = end_of_comment(file, bytes);
  if(bytes.size() < counts + 8)
    refuse_file(file, "cut short: the numbers of vertices and triangles are missing", "export it again");
  const auto vertices = number_at<std::int32_t>(&bytes[counts], Byte_order::BIG);
  const auto triangles = number_at<std::int32_t>(&bytes[counts + 4], Byte_order::BIG);
  const std::size_t begin = counts + 8;
  const std::string promise =
    "the header announces " + std::to_string(vertices) + " vertices and " + std::to_string(triangles) + " triangles";
  if(vertices < 0 || triangles < 0)
    refuse_file(file, promise);
  if(std::size_t(vertices) > largest_count || std::size_t(triangles) > largest_count)
    refuse_file(file, promise + ", more than this program can index", "simplify the mesh");
  const std::size_t row = 12; // bytes of a point, and of a triangle
  const std::size_t end = begin + row * (std::size_t(vertices) + std::size_t(triangles));
  if(bytes.size() < end)
    refuse_file(file,
                "cut short: " + promise + " in " + std::to_string(end) + " bytes, the file has " +
                  std::to_string(bytes.size()),
                "export it again");
  if(triangles == 0)
    refuse_point_cloud(file, static_cast<std::size_t>(vertices));

  Soup soup;
  soup.points.resize(static_cast<std::size_t>(vertices));
  soup.triangles.resize(static_cast<std::size_t>(triangles));
  soup.faces = soup.triangles.size();
  const char* at = &bytes[begin];
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    for(std::size_t k = 0; k < 3; ++k, at += 4)
      soup.set_coordinate(file, v, k, number_at<float>(at, Byte_order::BIG));
  for(std::size_t f = 0; f < soup.faces; ++f)
    for(int& corner : soup.triangles[f]) {
      corner = checked_corner(file, f, number_at<std::int32_t>(at, Byte_order::BIG), soup.points.size());
      at += 4;
    }
  soup.annotations.freesurfer = bytes.substr(end);
  return soup;
}

} // namespace tool
