// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_FOR_EACH_FACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_FOR_EACH_FACE_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <array>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Calls f(i, corners...) for the faces begin <= i < end, with the values of its three corners in every one of the
/// arrays `at`. Those of later faces are asked for meanwhile: corners may be far apart in memory.
template <class F, class... Arrays>
void for_each_face(const Host_array<std::array<int, 3>>& face, int begin, int end, F f, const Arrays&... at)
{
  constexpr int faces_ahead = 32;
  for(int i = begin; i < end; ++i) {
    if(i < end - faces_ahead)
      for([[maybe_unused]] const int corner : face[i + faces_ahead])
        (__builtin_prefetch(&at[corner]), ...);
    const std::array<int, 3>& corner = face[i];
    f(i, std::array<vec3, 3>{at[corner[0]], at[corner[1]], at[corner[2]]}...);
  }
}

/// The faces f, in their order, for which `holds(f, corners...)`, given their corners in every one of the arrays `at`.
template <class Loop, class Holds, class... Arrays>
std::vector<int> faces_where(const Loop& loop, const Host_array<std::array<int, 3>>& face, Holds holds,
                             const Arrays&... at)
{
  std::vector<int> result;
  for(const std::vector<int>&part : results_of_parts(loop, static_cast<int>(face.size()), [&](int begin, int end) {
        std::vector<int> of_part;
        for_each_face(
          face, begin, end,
          [&](int f, const auto&... corners) {
            if(holds(f, corners...))
              of_part.push_back(f);
          },
          at...);
        return of_part;
      }))
    result.insert(result.end(), part.begin(), part.end());
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_FOR_EACH_FACE_H
