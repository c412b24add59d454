// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SPRING_LENGTHS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SPRING_LENGTHS_H

#include <CGAL/Spherical_parameterization/internal/backend/Weighted_graph.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// The lengths of conformal springs inside the surface. Most are edges of the mesh, whose ends tell their lengths: only
/// the others are listed, since few methods need lengths at all.
struct Spring_lengths {
  double slack = 0;           ///< by which all edges are longer than their ends are apart
  std::vector<int> spring;    ///< the others, in ascending order: each by its entry in the row of its smaller end
  std::vector<double> length; ///< of these

  static double of_edge(vec3 p, vec3 q, double slack) { return norm(sub(q, p)) + slack; }

  /// By entry of the graph. `point` has the ends.
  Host_array<double> of_all(const Weighted_graph& graph, const Host_array<vec3>& point) const
  {
    Host_array<double> result(graph.target.size());
    for(int i = 0; i < graph.size(); ++i)
      for(int k = graph.offset[i]; k < graph.offset[i + 1]; ++k)
        result[k] = of_edge(point[i], point[graph.target[k]], slack);
    int i = 0; // whose row it is
    for(std::size_t s = 0; s < spring.size(); ++s) {
      const int k = spring[s];
      while(k >= graph.offset[i + 1])
        ++i;
      const auto row = graph.target.begin() + graph.offset[graph.target[k]];
      const auto end = graph.target.begin() + graph.offset[graph.target[k] + 1];
      result[k] = result[std::lower_bound(row, end, i) - graph.target.begin()] = length[s];
    }
    return result;
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_SPRING_LENGTHS_H
