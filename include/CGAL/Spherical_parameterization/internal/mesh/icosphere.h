// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_ICOSPHERE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_ICOSPHERE_H

#include <CGAL/Spherical_parameterization/internal/base/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// An icosahedron of which every triangle has been cut in four `level` times, on the unit sphere: 10 * 4^level + 2
/// points and 20 * 4^level triangles, counter-clockwise seen from outside. The first points are those of the lower
/// levels.
struct Icosphere {
  std::vector<vec3> points;
  std::vector<std::array<int, 3>> triangles;

  explicit Icosphere(int level)
  {
    const double golden = (1 + std::sqrt(5.)) / 2;
    for(const double a : {-1., 1.})
      for(const double b : {-golden, golden}) {
        points.push_back(unit({0, a, b}));
        points.push_back(unit({a, b, 0}));
        points.push_back(unit({b, 0, a}));
      }
    const int n = static_cast<int>(points.size());
    for(int i = 0; i < n; ++i) // neighbours have the inner product 1/sqrt(5), all others a negative one
      for(int j = i + 1; j < n; ++j)
        for(int k = j + 1; k < n; ++k)
          if(inner(points[i], points[j]) > 0 && inner(points[j], points[k]) > 0 && inner(points[k], points[i]) > 0) {
            const bool is_positive = inner(points[i], outer(points[j], points[k])) > 0;
            triangles.push_back(is_positive ? std::array<int, 3>{i, j, k} : std::array<int, 3>{i, k, j});
          }
    for(; level > 0; --level)
      subdivide();
  }

private:
  void subdivide()
  {
    // The midpoint of an edge is made by the first of its two triangles, and found by the other one in the list of the
    // smaller vertex, which has at most six entries.
    std::vector<std::vector<std::pair<int, int>>> midpoints(points.size());
    const auto midpoint = [&](int a, int b) {
      auto& list = midpoints[(std::min)(a, b)];
      for(const auto& [end, m] : list)
        if(end == (std::max)(a, b))
          return m;
      const int m = static_cast<int>(points.size());
      points.push_back(unit(add(points[a], points[b])));
      list.emplace_back((std::max)(a, b), m);
      return m;
    };
    std::vector<std::array<int, 3>> finer;
    finer.reserve(4 * triangles.size());
    for(const auto& [a, b, c] : triangles) {
      const int ab = midpoint(a, b), bc = midpoint(b, c), ca = midpoint(c, a);
      finer.push_back({a, ab, ca});
      finer.push_back({b, bc, ab});
      finer.push_back({c, ca, bc});
      finer.push_back({ab, bc, ca});
    }
    triangles.swap(finer);
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MESH_ICOSPHERE_H
