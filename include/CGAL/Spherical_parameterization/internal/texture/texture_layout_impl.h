// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_LAYOUT_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_LAYOUT_IMPL_H

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/api/precondition.h>
#include <CGAL/Spherical_parameterization/internal/algebra/point_coordinates.h>
#include <CGAL/Spherical_parameterization/internal/texture/least_harmful_poles.h>
#include <CGAL/Spherical_parameterization/internal/texture/texture_layout.h>

#include <algorithm>

namespace CGAL::Spherical_parameterization::internal {

/// If a vertex is at a pole to a few roundings, its direction is that of the pole, to the last bit: there u has a value
/// by itself.
CGAL_SP_INLINE Frame frame_of(const Texture_axes& axes, const Host_array<vec3>& image)
{
  const vec3 north = {axes.north[0], axes.north[1], axes.north[2]};
  const vec3 meridian = {axes.meridian[0], axes.meridian[1], axes.meridian[2]};
  const vec3 normal = outer(scaled_to_unit_box(north), scaled_to_unit_box(meridian));
  CGAL_SP_PRECONDITION(is_finite(north) && is_finite(meridian) && inner(normal, normal) > 1e-20,
                       "the axes of a texture are two directions that are not parallel");
  const vec3 direction = direction_of(north);
  vec3 pole = direction;
  double nearest = 4e-30; // the square of a few roundings
  for(const vec3 p : image) {
    const vec3 at = direction_of(p), same_side = inner(at, direction) < 0 ? scale(-1, at) : at;
    if(const double d = squared_distance(same_side, direction); d < nearest) {
      nearest = d;
      pole = same_side;
    }
  }
  return Frame(pole, scaled_to_unit_box(meridian));
}

/// Any meridian will do: that of the coordinate axis farthest from the pole.
CGAL_SP_INLINE Texture_axes axes_with_south_pole(vec3 south)
{
  const double x = std::abs(south.x), y = std::abs(south.y), z = std::abs(south.z);
  Texture_axes axes = {{-south.x, -south.y, -south.z}, {0, 0, 0}};
  axes.meridian[x <= y && x <= z ? 0 : y <= z ? 1 : 2] = 1;
  return axes;
}

template <class Loop, class Chart>
void lay_out_faces(const Loop& loop, const Valid_map& map, const Chart& chart, const Uv_grid& grid,
                   Texture_layout& layout)
{
  layout.uv.resize(map.face.size());
  const auto lay_out_part = [&](int begin, int end) {
    Texture_report report{};
    for(int f = begin; f < end; ++f) {
      const Charted_face face = chart(map.of_unit_image(f));
      Uv_triangle& uv = layout.uv[f] = grid.rounded(face.uv);
      report.pole_faces += face.is_at_pole;
      if(!is_counterclockwise(uv)) {
        uv = grid.turned_over(face.uv, face.area);
        const double move =
          (std::max)({distance(uv[0], face.uv[0]), distance(uv[1], face.uv[1]), distance(uv[2], face.uv[2])});
        chart.into_range(uv);
        ++report.moved_faces;
        report.unresolved_faces += move <= 2 * grid.cell();
        report.largest_move = (std::max)(report.largest_move, move);
      }
      report.seam_faces += is_beyond_square(uv);
    }
    return report;
  };
  for(const Texture_report& part : results_of_parts(loop, map.number_of_faces(), lay_out_part)) {
    layout.report.seam_faces += part.seam_faces;
    layout.report.pole_faces += part.pole_faces;
    layout.report.moved_faces += part.moved_faces;
    layout.report.unresolved_faces += part.unresolved_faces;
    layout.report.largest_move = (std::max)(layout.report.largest_move, part.largest_move);
  }
}

template <class Loop>
Texture_layout texture_layout(const Loop& loop, const Valid_map& map, const Texture_options& options)
{
  Texture_layout layout;
  layout.report.axes = options.axes ? *options.axes : axes_with_south_pole(least_harmful_south_pole(loop, map));
  const Frame frame = frame_of(layout.report.axes, map.image);
  const Uv_grid grid(options.bits);
  if(options.chart == Texture_chart::LATITUDE_LONGITUDE)
    lay_out_faces(loop, map, Latitude_longitude_chart{frame}, grid, layout);
  else
    lay_out_faces(loop, map, Octahedral_chart{frame}, grid, layout);
  return layout;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_LAYOUT_IMPL_H
