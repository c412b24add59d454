// SPDX-License-Identifier: LGPL-3.0-or-later

#include "output/write_mesh.h"

#include "output/quantile.h"
#include "output/text_writer.h"
#include "system/refusal.h"

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>

namespace tool {
namespace {

void write_off(std::ostream& out, const Mesh& mesh, const std::vector<Point>& points)
{
  Text_writer write(out);
  write("OFF\n", points.size(), ' ', mesh.number_of_faces(), " 0\n");
  for(const Point& p : points)
    write(p, '\n');
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f)
    write("3 ", mesh.triangle(f), '\n');
}

void write_obj(std::ostream& out, const Mesh& mesh, const std::vector<Point>& points)
{
  Text_writer write(out);
  for(const Point& p : points)
    write("v ", p, '\n');
  for(std::size_t f = 0; f < mesh.number_of_faces(); ++f) {
    const auto [a, b, c] = mesh.triangle(f);
    write("f ", a + 1, ' ', b + 1, ' ', c + 1, '\n');
  }
}

/// A diverging scale of even lightness (K. Moreland, "Diverging color maps for scientific visualization", 2009),
/// `t` from -1 (blue) over 0 (light grey) to 1 (red).
Colour diverging(double t)
{
  constexpr std::array<Colour, 5> scale = {
    {{59, 76, 192}, {141, 176, 254}, {221, 221, 221}, {244, 154, 123}, {180, 4, 38}}};
  const double place = 2 * (std::clamp(t, -1., 1.) + 1);
  const auto below = std::min(static_cast<std::size_t>(place), scale.size() - 2);
  const double share = place - static_cast<double>(below);
  Colour colour;
  for(std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint8_t>(std::lround((1 - share) * scale[below][i] + share * scale[below + 1][i]));
  return colour;
}

Point rounded_to_floats(Point point)
{
  for(double& x : point) {
    const volatile float rounded = static_cast<float>(x); // g++ 12.2 -O3 would not round in all lanes
    x = rounded;
  }
  return point;
}

} // namespace

void write_mesh(std::ostream& out, const Output_format& format, const Mesh& mesh, const std::vector<Point>& points,
                Surface surface, const Annotations& annotations, const Vertex_data& data)
{
  check_floats(format, points);
  switch(format.format) {
  case Mesh_format::OFF: return write_off(out, mesh, points);
  case Mesh_format::OBJ: return write_obj(out, mesh, points);
  case Mesh_format::PLY: return write_ply(out, format.ascii, mesh, points, {"", ply_columns(data), {}});
  case Mesh_format::GIFTI: return write_gifti(out, mesh, points, surface, annotations);
  case Mesh_format::FREESURFER: return write_freesurfer(out, mesh, points, surface, annotations);
  case Mesh_format::VTK: return write_vtk(out, format.ascii, mesh, points, data);
  case Mesh_format::VTP: return write_vtp(out, format.ascii, mesh, points, data);
  case Mesh_format::GLB:
  case Mesh_format::GLTF: return write_gltf(out, format.format, mesh, points);
  case Mesh_format::STL:
  case Mesh_format::VTU:
  case Mesh_format::MNI: break; // no option takes them
  }
}

void check_float_range(const std::string& file, const std::vector<Point>& points)
{
  double largest = 0;
  for(const Point& p : points)
    largest = std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(p[2])});
  using Float = std::numeric_limits<float>;
  const bool is_too_large = largest > Float::max();
  if(!is_too_large && (largest == 0 || largest >= Float::min()))
    return;
  std::ostringstream wrong;
  wrong.precision(3);
  wrong << "the format holds floats, and the largest coordinate, " << largest << ", is "
        << (is_too_large ? "above" : "below") << " their range";
  throw Refusal(Error_code::NON_FINITE_COORDINATE, file, wrong.str(), "write .ply, .off or .obj");
}

void check_floats(const Output_format& format, const std::vector<Point>& points)
{
  if(!stores_floats(format.format))
    return;
  check_float_range(format.name, points);
  double rounding = 0;
  CGAL::Bbox_3 box;
  for(const Point& p : points) {
    const Point q = rounded_to_floats(p);
    rounding = std::max({rounding, std::abs(q[0] - p[0]), std::abs(q[1] - p[1]), std::abs(q[2] - p[2])});
    box += CGAL::Bbox_3(p[0], p[1], p[2], p[0], p[1], p[2]);
  }
  constexpr double most_of_size = 1e-3;
  const double size = points.empty() ? 0 : std::hypot(box.x_span(), box.y_span(), box.z_span());
  if(rounding <= most_of_size * size)
    return;
  std::ostringstream wrong;
  wrong.precision(3);
  wrong << "the format holds floats, which move vertices by up to " << rounding << ", where the mesh has the size "
        << size << ", since it is far from the origin";
  throw Refusal(unwritable_data, format.name, wrong.str(), "write .ply, .off or .obj, or move the mesh");
}

Point as_stored(Mesh_format format, Surface surface, Point point)
{
  const double radius = surface == Surface::SPHERE ? radius_of_spheres(format) : 1;
  return stores_floats(format) ? rounded_to_floats({radius * point[0], radius * point[1], radius * point[2]}) : point;
}

void write_coloured_ply(std::ostream& out, bool ascii, const Mesh& mesh, const std::vector<Point>& points,
                        const std::string& name, const std::vector<double>& values)
{
  // The scale ends at quantiles, or a few vertices at the tips of limbs would leave everything else grey. Either side
  // has its own, since limbs can shrink by many orders of magnitude while nothing grows by more than a few.
  constexpr double least = std::numeric_limits<double>::min();
  std::vector<double> sorted = values;
  const double low = std::min(quantile(sorted, 0.02), -least), high = std::max(quantile(sorted, 0.98), least);
  std::ostringstream comment;
  comment.precision(std::numeric_limits<double>::max_digits10);
  comment << "colours by " << name << ": ";
  if(low < -least)
    comment << "blue at " << low << ", ";
  comment << "grey at 0, red at " << high;
  std::vector<Colour> colours;
  for(const double x : values)
    colours.push_back(diverging(x / (x < 0 ? -low : high)));
  Ply_extras extras = {comment.str(), colour_columns(colours), {}};
  extras.of_vertices.push_back({Ply_column::Type::DOUBLE, name, [&values](std::size_t v) { return values[v]; }});
  write_ply(out, ascii, mesh, points, extras);
}

void write_segments_ply(std::ostream& out, bool ascii, const Mesh& mesh, const std::vector<std::size_t>& segments,
                        std::size_t number_of_segments, const Vertex_data& data)
{
  std::vector<Colour> colours;
  colours.reserve(segments.size());
  for(const std::size_t segment : segments)
    colours.push_back(distinct_colour(segment));
  Ply_extras extras = {std::to_string(number_of_segments) + " segments", ply_columns(data), colour_columns(colours)};
  extras.of_faces.push_back(
    {Ply_column::Type::INT, "segment", [&segments](std::size_t f) { return double(segments[f]); }});
  write_ply(out, ascii, mesh, mesh.points(), extras);
}

} // namespace tool
