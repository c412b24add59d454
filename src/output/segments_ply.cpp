// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/segments_ply.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace tool {
namespace {

/// Hues by the golden ratio: every new one falls into the largest gap. Lightness alternates, so that hues that have
/// come close by then still differ.
std::array<int, 3> colour_of_segment(std::size_t segment)
{
  const double hue = std::fmod(0.58 + 0.61803398874989485 * static_cast<double>(segment), 1.);
  const double light = segment % 3 == 0   ? 0.95
                       : segment % 3 == 1 ? 0.75
                                          : 0.55,
               saturation = segment % 2 == 0 ? 0.55 : 0.8;
  std::array<int, 3> colour;
  for(std::size_t i = 0; i < 3; ++i) {
    const double phase = std::abs(std::remainder(hue - static_cast<double>(i) / 3, 1.)); // 0 to 1/2
    const double pure = std::clamp(2 - 6 * phase, 0., 1.);
    colour[i] = static_cast<int>(std::lround(255 * light * (1 - saturation * (1 - pure))));
  }
  return colour;
}

} // namespace

void write_segments_ply(std::ostream& out, const Mesh& mesh, Segment_map segments, std::size_t number_of_segments)
{
  std::vector<std::array<int, 3>> colours;
  for(std::size_t i = 0; i < number_of_segments; ++i)
    colours.push_back(colour_of_segment(i));

  out.precision(std::numeric_limits<double>::max_digits10);
  out << "ply\nformat ascii 1.0\ncomment " << number_of_segments << " segments\nelement vertex "
      << mesh.number_of_vertices() << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.number_of_faces()
      << "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
         "property int segment\nend_header\n";
  for(const Mesh::Vertex_index v : mesh.vertices())
    out << mesh.point(v) << '\n';
  for(const Mesh::Face_index f : mesh.faces()) {
    out << '3';
    for(const Mesh::Vertex_index v : mesh.vertices_around_face(mesh.halfedge(f)))
      out << ' ' << v.idx();
    for(const int channel : colours[segments[f]])
      out << ' ' << channel;
    out << ' ' << segments[f] << '\n';
  }
}

} // namespace tool
