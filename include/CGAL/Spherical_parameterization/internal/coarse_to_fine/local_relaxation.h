// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_LOCAL_RELAXATION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_LOCAL_RELAXATION_H

#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Distortion.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Map_level.h>
#include <CGAL/Spherical_parameterization/internal/coarse_to_fine/Star.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <algorithm>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// One Newton step for vertex i alone. Keeps a valid map valid.
inline void relax_vertex(const Distortion& distortion, Map_level& level, int i)
{
  Star star;
  level.gather(i, star);
  vec3 x = level.position()[i];
  double energy = star_energy(distortion, star, x);
  if(relax_centre(distortion, star, x, energy) > 0)
    level.position()[i] = x;
}

/// One step for every vertex: a Gauss-Seidel sweep.
template <class Loop>
void relax_all(const Loop& loop, const Distortion& distortion, Map_level& level)
{
  level.for_each_vertex(loop, [&](int i) { relax_vertex(distortion, level, i); });
}

/// The vertices whose stars are distorted more than `factor` times as much as the map in the mean, and those up to
/// `rings` edges away; in ascending order, hence by colour.
template <class Loop>
std::vector<int> distorted_regions(const Loop& loop, const Distortion& distortion, const Map_level& level,
                                   double factor, int rings)
{
  const double bound = factor * level.energy(loop, distortion);
  std::vector<char> is_distorted(level.size());
  level.for_each_vertex(loop, [&](int i) {
    Star star;
    level.gather(i, star);
    double area = 0;
    for(const Star_face& f : star)
      area += f.twice_area / 2;
    is_distorted[i] = star_energy(distortion, star, level.position()[i]) > bound * area;
  });
  std::vector<int> region;
  for(int i = 0; i < level.size(); ++i)
    if(is_distorted[i])
      region.push_back(i);
  for(std::size_t ring = 0, begin = 0; ring < static_cast<std::size_t>(rings); ++ring) {
    const std::size_t end = region.size();
    for(; begin < end; ++begin)
      for(int c = level.offset(region[begin]); c < level.offset(region[begin] + 1); ++c)
        if(!is_distorted[level.corner(c).j]) {
          is_distorted[level.corner(c).j] = true;
          region.push_back(level.corner(c).j);
        }
  }
  std::sort(region.begin(), region.end());
  return region;
}

/// One step for every vertex of a region, colour by colour.
template <class Loop>
void relax_region(const Loop& loop, const Distortion& distortion, const std::vector<int>& region, Map_level& level)
{
  auto begin = region.begin();
  for(int colour = 0; colour < level.number_of_colours(); ++colour) {
    const auto end = std::lower_bound(begin, region.end(), level.colour_begin(colour + 1));
    const int first = static_cast<int>(begin - region.begin()), last = static_cast<int>(end - region.begin());
    for_each_of_level(loop, first, last, [&](int k) { relax_vertex(distortion, level, region[k]); });
    begin = end;
  }
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_COARSE_TO_FINE_LOCAL_RELAXATION_H
