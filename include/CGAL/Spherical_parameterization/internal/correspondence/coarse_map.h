// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_COARSE_MAP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_COARSE_MAP_H

#include <CGAL/Spherical_parameterization/internal/correspondence/Registered_surface.h>
#include <CGAL/Spherical_parameterization/internal/isometric/decimation.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Mapped_surface.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A valid map of some vertices of a surface, which is scaled to area 1.
struct Coarse_map : Mapped_surface {
  std::vector<int> vertex; ///< of the whole surface, by vertex of this one

  /// \param whole  a valid map
  /// \param kept   vertices that are among those of this one
  /// \param most   so many vertices, about, if there are more
  CGAL_SP_INLINE Coarse_map(const Watched_loop<Host_loop>& loop, const Registered_surface& whole,
                            const std::vector<int>& kept, int most)
  {
    const int n = static_cast<int>(whole.point.size());
    std::vector<int> number(n, 0);
    Progressive_mesh mesh(loop, whole.face, n);
    if(n > most) {
      std::vector<char> is_kept(n, 0);
      for(int v : kept)
        is_kept[v] = 1;
      Decimation<> decimation(loop, whole.point, mesh, std::move(is_kept), most, &whole.image);
      while(mesh.number_of_vertices() > most && !decimation.round().empty())
        loop.check();
    }
    for(int v = 0; v < n; ++v)
      if(!mesh.is_removed(v)) {
        number[v] = static_cast<int>(vertex.size());
        vertex.push_back(v);
        point.push_back(whole.point[v]);
        image.push_back(whole.image[v]);
      }
    number_of_vertices = static_cast<int>(vertex.size());
    for(int v : vertex)
      mesh.for_each_corner(v, [&](int c) {
        const int w = mesh.target(c), u = mesh.apex(c);
        if(v < w && v < u)
          face.push_back({number[v], number[w], number[u]});
      });
    double area = 0;
    for(const std::array<int, 3>& f : face)
      area += norm(normal(point, f)) / 2;
    for(vec3& p : point)
      p = scale(1 / std::sqrt(area), p);
  }

  /// The number here of a vertex that was kept.
  int number_of(int v) const
  {
    return static_cast<int>(std::lower_bound(vertex.begin(), vertex.end(), v) - vertex.begin());
  }
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_CORRESPONDENCE_COARSE_MAP_H
