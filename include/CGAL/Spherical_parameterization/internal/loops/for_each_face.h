// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_FOR_EACH_FACE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_LOOPS_FOR_EACH_FACE_H

#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// Calls f(i, corners...) for the faces begin <= i < end, with the values of its three corners in every one of the
/// arrays `at`. They are fetched for some faces at a time: the processor waits for many of them at once, and no longer
/// than for one. Faces whose corners are far apart in memory are visited twice as fast.
template <class F, class... Arrays>
void for_each_face(const Host_array<std::array<int, 3>>& face, int begin, int end, F f, const Arrays&... at)
{
  constexpr int together = 32;
  typedef std::array<vec3, 3> Corners;
  std::array<std::array<Corners, sizeof...(at)>, together> fetched;
  for(int first = begin; first < end; first += together) {
    const int count = (std::min)(together, end - first);
    for(int i = 0; i < count; ++i) {
      const std::array<int, 3>& corner = face[first + i];
      fetched[i] = {Corners{at[corner[0]], at[corner[1]], at[corner[2]]}...};
    }
    for(int i = 0; i < count; ++i)
      std::apply([&](const auto&... corners) { f(first + i, corners...); }, fetched[i]);
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
