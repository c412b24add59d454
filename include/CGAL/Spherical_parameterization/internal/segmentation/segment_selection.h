// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENT_SELECTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENT_SELECTION_H

#include <CGAL/Spherical_parameterization/internal/segmentation/Region_graph.h>
#include <CGAL/Spherical_parameterization/internal/segmentation/Segmentation_mesh.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The length of every side: what borders are measured with where nothing else is known.
inline Side_costs side_lengths(const Segmentation_mesh& mesh)
{
  Side_costs length(mesh.face.size());
  for(int f = 0; f < mesh.number_of_faces(); ++f)
    for(int k = 0; k < 3; ++k)
      length[f][k] = mesh.side_length(f, k);
  return length;
}

/// Merges regions below `minimum_area`, the smallest first, into that neighbour for which `key(region, border)` is
/// smallest. `merged(a, b, union)` is called after each.
template <class Key, class Merged>
void absorb_small_regions(Region_graph& regions, double minimum_area, Key key, Merged merged)
{
  typedef std::pair<double, int> Entry; // area, region
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto push = [&](int r) {
    if(regions.area(r) < minimum_area)
      queue.emplace(regions.area(r), r);
  };
  for(int r = 0; r < regions.capacity(); ++r)
    if(regions.is_region(r))
      push(r);
  while(!queue.empty() && regions.number_of_regions() > 1) {
    const auto [area, r] = queue.top();
    queue.pop();
    if(!regions.is_region(r) || regions.area(r) != area)
      continue;
    const auto& borders = regions.borders(r);
    std::size_t best = 0;
    double best_key = key(r, borders[0]);
    for(std::size_t i = 1; i < borders.size(); ++i) {
      const double candidate = key(r, borders[i]);
      if(candidate < best_key) {
        best = i;
        best_key = candidate;
      }
    }
    const int other = borders[best].region;
    const int c = regions.merge(r, other);
    merged(r, other, c);
    push(c);
  }
}

/// Connected segments from labels: parts below `minimum_area` go to the neighbour with the longest common border, and
/// while there are more than `number_of_segments` (0: any number), the least significant cut is taken back: that of the
/// smallest area over its squared length.
inline std::vector<int> selected_segments(const Segmentation_mesh& mesh, const std::vector<int>& label,
                                          double minimum_area, std::size_t number_of_segments)
{
  Region_graph regions(mesh, connected_components(mesh, label), side_lengths(mesh));
  const auto ignore = [](int, int, int) {};
  absorb_small_regions(
    regions, minimum_area, [](int, const Region_graph::Border& border) { return -border.cost; }, ignore);
  if(number_of_segments > 0)
    merge_in_order(
      regions,
      [&](int a, const Region_graph::Border& border) {
        return (std::min)(regions.area(a), regions.area(border.region)) / (border.cost * border.cost);
      },
      [&](double) { return static_cast<std::size_t>(regions.number_of_regions()) > number_of_segments; }, ignore);
  return regions.labels();
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SEGMENTATION_SEGMENT_SELECTION_H
