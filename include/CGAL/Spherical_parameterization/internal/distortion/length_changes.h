// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_LENGTH_CHANGES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_LENGTH_CHANGES_H

#include <CGAL/Spherical_parameterization/internal/distortion/Face_measures.h>
#include <CGAL/Spherical_parameterization/internal/distortion/summarize.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>
#include <CGAL/Spherical_parameterization/values/Distortion_summary.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace CGAL::Spherical_parameterization::internal {

/// Of every face: max(sigma_1, 1 / sigma_2) of the affine map to its image, which need not be on a sphere, after both
/// surfaces have been scaled to the same area; 1 if the face has no area.
CGAL_SP_INLINE Host_array<double> length_changes(const Host_loop& loop, const Mapped_surface& map)
{
  const Host_array<double>& area = map.face_area(loop);
  const auto image_area = [&](int f) { return flat_area(map.of_image(f)); };
  const double scale = sum_by_parts(loop, map.number_of_faces(), [&](int f) { return area[f]; }) /
                       sum_by_parts(loop, map.number_of_faces(), image_area); // of squared lengths
  Host_array<double> change(map.face.size());
  for_each_index(loop, map.number_of_faces(), [&](int f) {
    change[f] = 1;
    if(!(area[f] > 0))
      return;
    const double half = scale * squared_singular_values(map.in_source(f), area[f], map.of_image(f)) / 2;
    const double product = scale * image_area(f) / area[f]; // of both singular values
    const double larger = half + std::sqrt((std::max)(0., (half - product) * (half + product))); // the square of one
    change[f] = product > 0 ? std::sqrt((std::max)({1., larger, larger / product / product}))
                            : std::numeric_limits<double>::infinity();
  });
  return change;
}

/// How they are spread over the surface.
CGAL_SP_INLINE Length_changes summarize_length_changes(const Host_loop& loop, const Host_array<double>& area,
                                                       const Host_array<double>& change)
{
  Length_changes result;
  result.factor = distribution(loop, change, area);
  const int n = static_cast<int>(area.size());
  const double whole = sum_by_parts(loop, n, [&](int f) { return area[f]; });
  const double large = sum_by_parts(loop, n, [&](int f) { return change[f] > Length_changes::large ? area[f] : 0; });
  result.share_of_large = large / whole;
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_DISTORTION_LENGTH_CHANGES_H
