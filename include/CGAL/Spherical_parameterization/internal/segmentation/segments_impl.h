// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_IMPL_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_IMPL_H

#include <CGAL/Spherical_parameterization/internal/segmentation/concave_cuts.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/girth_profiles.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/inner_light.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/majority_vote.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/region_growing.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/segments.h>
#include <CGAL/Spherical_parameterization/values/segmentation_methods.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

template <class Method>
std::vector<int> segments_of(const Watched_loop<Host_loop>& loop, Mapped_surface surface, std::vector<double> stretch,
                             const Method& method)
{
  constexpr double least_share = 1e-36;
  constexpr double least_area = 1e-300;
  const Segmentation_mesh mesh(std::move(surface), loop.bare());
  for(std::size_t f = 0; f < stretch.size(); ++f) {
    if(!std::isfinite(stretch[f]))
      throw Input_error(Error_code::NON_FINITE_COORDINATE, "the stretch of face " + std::to_string(f));
    stretch[f] = (std::min)(stretch[f], std::log((std::max)(mesh.face_area[f], least_area) / least_share));
  }
  if constexpr(std::is_same_v<Method, Region_growing>)
    return selected_segments(loop, mesh, grown_labels(mesh, stretch, method.threshold), method);
  else if constexpr(std::is_same_v<Method, Girth_profiles>)
    return selected_segments(loop, mesh, girth_labels(loop, mesh, stretch), method);
  else {
    constexpr double girth_weight = 2.5;
    std::vector<Voter> voters = {
      {selected_segments(loop, mesh, girth_labels(loop, mesh, stretch), Girth_profiles()), girth_weight}};
    loop.advance(0.1);
    const Creases creases(loop, mesh);
    loop.advance(0.5);
    Crease_segments by_creases = crease_segments(loop, mesh, creases);
    loop.advance(0.8);
    voters.push_back({segments_of_light(loop, mesh, by_creases.patches), 1});
    for(std::vector<int>& label : by_creases.at_scale)
      voters.push_back({std::move(label), 1});
    const std::vector<int> segments = majority_segments(loop, mesh, voters, method);
    // A given number of segments has been reached by now.
    return method.number_of_segments > 0 ? segments : without_flat_borders(loop, mesh, creases, segments);
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENTS_IMPL_H
