// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_BREADTH_FIRST_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_BREADTH_FIRST_H

#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>

#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The neighbours of every vertex, in the order of a walk round it, in compressed rows.
struct Neighbours {
  Host_array<int> offset, target;
};

/// The vertices in breadth-first order, one component after the other. Sets the number of components.
inline Host_array<int> breadth_first_order(const Neighbours& neighbours, std::size_t& number_of_components)
{
  const int n = static_cast<int>(neighbours.offset.size()) - 1;
  std::vector<char> is_visited(n, 0);
  Host_array<int> order;
  order.reserve(n);
  const auto visit = [&](int v) {
    if(!is_visited[v]) {
      is_visited[v] = 1;
      order.push_back(v);
    }
  };
  number_of_components = 0;
  for(int seed = 0; seed < n; ++seed) {
    if(is_visited[seed])
      continue;
    ++number_of_components;
    std::size_t head = order.size();
    visit(seed);
    for(; head < order.size(); ++head)
      for(int k = neighbours.offset[order[head]]; k < neighbours.offset[order[head] + 1]; ++k)
        visit(neighbours.target[k]);
  }
  return order;
}

/// The place of every number in a permutation.
inline Host_array<int> inverse_permutation(const Host_loop& loop, const Host_array<int>& order)
{
  const int n = static_cast<int>(order.size());
  Host_array<int> place(n);
  for_each_index(loop, n, [&](int i) { place[order[i]] = i; });
  return place;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_BREADTH_FIRST_H
