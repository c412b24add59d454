// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_PERSISTENCE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_PERSISTENCE_H

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A minimum of a function on a graph, and its basin.
struct Basin {
  int minimum;
  double persistence; ///< how far the function rises from there until the basin meets one with a deeper minimum
  double mass;        ///< the smaller one of the two masses below that level; of the deepest minimum, all mass
};

/// The basins of f, by falling persistence. The deepest one comes first, with the range of f as its persistence.
/// H. Edelsbrunner, D. Letscher, A. Zomorodian, "Topological persistence and simplification", Discrete & Computational
/// Geometry 28 (2002). O(n log n).
///
/// \param for_each_neighbour  calls its second argument with every neighbour of the vertex that is its first one
template <class Values, class ForEachNeighbour>
std::vector<Basin> basins(const Values& f, const Values& mass, ForEachNeighbour for_each_neighbour)
{
  const int n = static_cast<int>(f.size());
  std::vector<int> order(n), parent(n, -1); // -1: above the water
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int i, int j) { return std::pair(f[i], i) < std::pair(f[j], j); });

  std::vector<int> lowest(n); // of a root: its minimum
  std::vector<double> flooded(n);
  const auto root = [&](int i) {
    for(; parent[i] != i; i = parent[i])
      parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<Basin> result;
  double total = 0;
  for(int v : order) {
    parent[v] = v;
    lowest[v] = v;
    flooded[v] = mass[v];
    total += mass[v];
    for_each_neighbour(v, [&](int w) {
      if(parent[w] < 0)
        return;
      int deep = root(w), shallow = root(v);
      if(deep == shallow)
        return;
      if(std::pair(f[lowest[shallow]], lowest[shallow]) < std::pair(f[lowest[deep]], lowest[deep]))
        std::swap(deep, shallow);
      if(f[lowest[shallow]] < f[v])
        result.push_back({lowest[shallow], f[v] - f[lowest[shallow]], (std::min)(flooded[deep], flooded[shallow])});
      parent[shallow] = deep;
      flooded[deep] += flooded[shallow];
    });
  }
  if(n > 0)
    result.push_back({order.front(), f[order.back()] - f[order.front()], total});
  std::sort(result.begin(), result.end(), [](const Basin& a, const Basin& b) {
    return std::pair(a.persistence, a.mass) > std::pair(b.persistence, b.mass);
  });
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_PERSISTENCE_H
