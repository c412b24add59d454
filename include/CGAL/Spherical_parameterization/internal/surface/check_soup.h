// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SOUP_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SOUP_H

#include <CGAL/Spherical_parameterization/values/Error.h>
#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/surface/Corner_table.h>

#include <cstddef>
#include <functional>
#include <string>

namespace CGAL::Spherical_parameterization::internal {

/// Why triangles form no sphere.
struct Soup_trouble {
  Error_code code = Error_code::OK;
  std::string wrong;  ///< what and where: "3 boundary edges (first: between vertices 0 and 5)", ...
  std::string remedy; ///< what to do: "close the holes", ...

  void add(Error_code its_code, const std::string& what, const std::string& what_to_do)
  {
    if(code == Error_code::OK) {
      code = its_code;
      remedy = what_to_do;
    } else
      wrong += ", ";
    wrong += what;
  }
};

/// A soup that has been checked. The arrays are of use if there is no trouble.
struct Checked_soup {
  Soup_trouble trouble;
  Host_array<int> last_corner;   ///< at every vertex
  Host_array<int> breadth_first; ///< the vertices in this order
};

/// Looks for all that keeps the triangles table.face, whose corners are below n, from being a closed, connected,
/// oriented surface without handles: triangles with a repeated vertex, vertices without triangles, edges with more than
/// two triangles, neighbouring triangles of opposite orientation, boundary edges, non-manifold vertices, several
/// components, handles. The first trouble gives the code and the remedy; the code is `OK` if there is none, and then
/// table.twin is filled.
///
/// `number_of_different_points()` is asked for where there is a boundary: vertices at the same place are a common
/// cause.
CGAL_SP_CORE Checked_soup check_soup(const Host_loop& loop, Corner_table& table, int n,
                                     const std::function<std::size_t()>& number_of_different_points);

} // namespace CGAL::Spherical_parameterization::internal

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_COMPILED
#include <CGAL/Spherical_parameterization/internal/surface/check_soup_impl.h>
#endif

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SURFACE_CHECK_SOUP_H
