// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/write_mesh.h"

#include "input/files.h"
#include "output/quantile.h"
#include "output/text_writer.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

namespace tool {
namespace {

using Colour = std::array<int, 3>;

/// What rows of a PLY file have behind coordinates or vertex indices.
struct Columns {
  std::string properties;                 ///< lines of the header
  std::function<void(std::size_t)> write; ///< of row i, each with a space before it
};

void write_faces(Text_writer& write, const Mesh& mesh, const Columns& columns = {})
{
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    write("3 ", mesh.triangle(f));
    if(columns.write)
      columns.write(f);
    write('\n');
  }
}

void write_ply(Text_writer& write, const Mesh& mesh, const std::vector<Point>& points, const std::string& comment = "",
               const Columns& of_vertices = {}, const Columns& of_faces = {})
{
  write("ply\nformat ascii 1.0\n", comment, "element vertex ", points.size(),
        "\nproperty double x\nproperty double y\nproperty double z\n", of_vertices.properties, "element face ",
        mesh.number_of_faces(), "\nproperty list uchar int vertex_indices\n", of_faces.properties, "end_header\n");
  for(std::size_t v = 0; v < points.size(); ++v) {
    write(points[v]);
    if(of_vertices.write)
      of_vertices.write(v);
    write('\n');
  }
  write_faces(write, mesh, of_faces);
}

/// A diverging scale of even lightness (K. Moreland, "Diverging color maps for scientific visualization", 2009),
/// `t` from -1 (blue) over 0 (white) to 1 (red).
Colour diverging(double t)
{
  constexpr std::array<Colour, 5> scale = {
    {{59, 76, 192}, {141, 176, 254}, {221, 221, 221}, {244, 154, 123}, {180, 4, 38}}};
  const double place = 2 * (std::clamp(t, -1., 1.) + 1);
  const auto below = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double share = place - static_cast<double>(below);
  Colour colour;
  for(std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<int>(std::lround((1 - share) * scale[below][i] + share * scale[below + 1][i]));
  return colour;
}

/// Hues by the golden ratio: every new one falls into the largest gap. Lightness alternates, so that hues that have
/// come close by then still differ.
Colour colour_of_segment(std::size_t segment)
{
  const double hue = std::fmod(0.58 + 0.61803398874989485 * static_cast<double>(segment), 1.);
  const double light = segment % 3 == 0 ? 0.95 : segment % 3 == 1 ? 0.75 : 0.55;
  const double saturation = segment % 2 == 0 ? 0.55 : 0.8;
  Colour colour;
  for(std::size_t i = 0; i < 3; ++i) {
    const double phase = std::abs(std::remainder(hue - static_cast<double>(i) / 3, 1.)); // 0 to 1/2
    const double pure = std::clamp(2 - 6 * phase, 0., 1.);
    colour[i] = static_cast<int>(std::lround(255 * light * (1 - saturation * (1 - pure))));
  }
  return colour;
}

} // namespace

void write_mesh(std::ostream& out, const std::string& file, const Mesh& mesh, const std::vector<Point>& points)
{
  Text_writer write(out);
  const std::string extension = lower_case_extension(file);
  if(extension == ".ply")
    write_ply(write, mesh, points);
  else if(extension == ".off") {
    write("OFF\n", points.size(), ' ', mesh.number_of_faces(), " 0\n");
    for(const Point& p : points)
      write(p, '\n');
    write_faces(write, mesh);
  } else {
    for(const Point& p : points)
      write("v ", p, '\n');
    for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
      const auto [a, b, c] = mesh.triangle(f);
      write("f ", a + 1, ' ', b + 1, ' ', c + 1, '\n');
    }
  }
}

void write_stretch_ply(std::ostream& out, const Mesh& mesh, const Sphere& sphere)
{
  std::vector<double> stretch(mesh.number_of_vertices());
  CGAL::Spherical_parameterization::log_area_stretch(mesh, as_map(sphere), as_map<Mesh::Vertex_index>(stretch));

  // The scale ends at quantiles, or a few vertices at the tips of limbs would leave everything else white. Either side
  // has its own, since limbs can shrink by many orders of magnitude while nothing grows by more than a few.
  std::vector<double> sorted = stretch;
  const double low = std::min(quantile(sorted, 0.02), -std::numeric_limits<double>::min());
  const double high = std::max(quantile(sorted, 0.98), std::numeric_limits<double>::min());
  std::ostringstream comment;
  comment.precision(std::numeric_limits<double>::max_digits10);
  comment << "comment colours by log_area_stretch: blue at " << low << ", white at 0, red at " << high << '\n';

  Text_writer write(out);
  write_ply(
    write, mesh, mesh.points(), comment.str(),
    {"property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double log_area_stretch\n",
     [&](std::size_t v) { write(' ', diverging(stretch[v] / (stretch[v] < 0 ? -low : high)), ' ', stretch[v]); }});
}

void write_segments_ply(std::ostream& out, const Mesh& mesh, const std::vector<std::size_t>& segments,
                        std::size_t number_of_segments)
{
  Text_writer write(out);
  write_ply(write, mesh, mesh.points(), "comment " + std::to_string(number_of_segments) + " segments\n", {},
            {"property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int segment\n",
             [&](std::size_t f) { write(' ', colour_of_segment(segments[f]), ' ', segments[f]); }});
}

} // namespace tool
