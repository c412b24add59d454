// SPDX-License-Identifier: GPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#include "output/stretch_ply.h"

#include "output/quantile.h"
#include "output/write_mesh.h"

#include <CGAL/Spherical_parameterization/measure_distortion.h>

#include <boost/property_map/vector_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace tool {
namespace {

using Colour = std::array<double, 3>;

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
    colour[i] = (1 - share) * scale[below][i] + share * scale[below + 1][i];
  return colour;
}

} // namespace

void write_stretch_ply(std::ostream& out, const Mesh& mesh, Sphere_map sphere)
{
  std::vector<double> stretch(mesh.number_of_vertices());
  CGAL::Spherical_parameterization::log_area_stretch(
    mesh, sphere, boost::make_iterator_property_map(stretch.begin(), get(boost::vertex_index, mesh)));

  // The scale ends at quantiles, or a few vertices at the tips of limbs would leave everything else white. Either side
  // has its own, since limbs can shrink by many orders of magnitude while nothing grows by more than a few.
  std::vector<double> sorted = stretch;
  const double low = std::min(quantile(sorted, 0.02), -std::numeric_limits<double>::min());
  const double high = std::max(quantile(sorted, 0.98), std::numeric_limits<double>::min());

  out.precision(std::numeric_limits<double>::max_digits10);
  out << "ply\nformat ascii 1.0\ncomment colours by log_area_stretch: blue at " << low << ", white at 0, red at "
      << high << "\nelement vertex " << mesh.number_of_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z"
         "\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nproperty double log_area_stretch"
         "\nelement face "
      << mesh.number_of_faces() << "\nproperty list uchar int vertex_indices\nend_header\n";
  for(const Mesh::Vertex_index v : mesh.vertices()) {
    out << mesh.point(v);
    for(const double channel : diverging(stretch[v] / (stretch[v] < 0 ? -low : high)))
      out << ' ' << std::lround(channel);
    out << ' ' << stretch[v] << '\n';
  }
  write_faces(out, mesh);
}

} // namespace tool
