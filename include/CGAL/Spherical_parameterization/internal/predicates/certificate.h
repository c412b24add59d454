// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_CERTIFICATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_CERTIFICATE_H

#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/loops/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// What covering() says of a direction on the border of a face: more than all other faces together can add up to.
constexpr double on_border = 1e15;

/// The share of a face in the degree, seen in direction q: its orientation if it contains q, else 0; `on_border` if q
/// is on its border. Exact.
inline double covering(vec3 a, vec3 b, vec3 c, vec3 q)
{
  // Where the line along q meets the plane of the face, it is no farther from the corner a than the other corners: this
  // is not so for nearly all faces, and by far more than rounding.
  const vec3 ab = sub(b, a), ac = sub(c, a);
  const double aa = inner(a, a), aq = inner(a, q), qq = inner(q, q);
  const double longest2 = (std::max)(inner(ab, ab), inner(ac, ac));
  if(aa * qq - aq * aq > (1.0001 * longest2 + 1e-12 * aa) * qq)
    return 0;

  const std::array<vec3, 4> corner = {a, b, c, a};
  int least = 1, largest = -1;
  for(int k = 0; k < 3; ++k) {
    const int side = orientation(corner[k], corner[k + 1], q);
    least = (std::min)(least, side);
    largest = (std::max)(largest, side);
    if(least < 0 && largest > 0)
      return 0;
  }
  const int of_face = orientation(a, b, c);
  if(of_face == 0 || (of_face > 0 ? least < 0 : largest > 0))
    return 0;
  return least == largest ? of_face : on_border;
}

/// Directions in which the degree may be counted. No great circle meets (1, t, t^2) in more than two points, so some of
/// them is on no border.
inline vec3 direction_of_degree(int k)
{
  const double t = k + 773. / 1024;
  return make_vec3(1, t, t * t);
}

/// The degree of a map: how many faces lie over a direction, counted with orientation. It is the same for all
/// directions that are on no border, and exact, which the sum of the areas is not: of a face with all corners near one
/// great circle rounding cannot tell whether it is half a sphere or nothing.
/// \param sum_of_coverings  given a direction q, the sum of `covering()` over all faces; it is asked for
///                          `direction_of_degree(0)` first
template <class Sum_of_coverings>
int degree(Sum_of_coverings sum_of_coverings)
{
  for(int k = 0;; ++k) {
    const double sum = sum_of_coverings(direction_of_degree(k));
    if(std::abs(sum) < on_border / 2)
      return static_cast<int>(sum);
  }
}

inline bool is_finite(vec3 a, vec3 b, vec3 c) { return is_finite(a) && is_finite(b) && is_finite(c); }

/// What the certificate consists of.
struct Certificate {
  std::size_t flipped_faces = 0; ///< faces that are not positively oriented, or have a coordinate that is not finite
  int degree = 0;                ///< how often the faces with finite coordinates cover the sphere
  double smallest_area = std::numeric_limits<double>::infinity(); ///< without sign
  double smallest_edge = std::numeric_limits<double>::infinity(); ///< chord

  bool is_valid() const { return flipped_faces == 0 && degree == 1; }
};

/// Examines a map given by unit vectors: without flipped faces and with degree 1 it is a bijection, since it then is a
/// covering of the sphere, and the sphere is simply connected.
CGAL_SP_INLINE Certificate certify(const Host_loop& loop, const Host_array<std::array<int, 3>>& faces,
                                   const Host_array<vec3>& v)
{
  struct Part : Certificate { // edges squared
    double coverings = 0;     // in the first direction
  };
  const vec3 direction = direction_of_degree(0);
  const std::vector<Part> parts = results_of_parts(loop, static_cast<int>(faces.size()), [&](int begin, int end) {
    Part part;
    for_each_face(
      faces, begin, end,
      [&](int, const std::array<vec3, 3>& corners) {
        const auto& [a, b, c] = corners;
        if(!is_finite(a, b, c)) {
          ++part.flipped_faces;
          return;
        }
        if(!is_positively_oriented(a, b, c))
          ++part.flipped_faces;
        part.smallest_area = (std::min)(part.smallest_area, std::abs(spherical_area(a, b, c)));
        for(vec3 edge : {sub(b, a), sub(c, b), sub(a, c)})
          part.smallest_edge = (std::min)(part.smallest_edge, inner(edge, edge));
        part.coverings += covering(a, b, c, direction);
      },
      v);
    return part;
  });

  Certificate result;
  double coverings = 0; // exact: a sum of integers
  for(const Part& part : parts) {
    coverings += part.coverings;
    result.flipped_faces += part.flipped_faces;
    result.smallest_area = (std::min)(result.smallest_area, part.smallest_area);
    result.smallest_edge = (std::min)(result.smallest_edge, part.smallest_edge);
  }
  result.smallest_edge = std::sqrt(result.smallest_edge);
  result.degree = degree([&, is_first = true](vec3 q) mutable {
    if(std::exchange(is_first, false))
      return coverings;
    return sum_by_parts(loop, static_cast<int>(faces.size()), [&](int f) {
      const vec3 a = v[faces[f][0]], b = v[faces[f][1]], c = v[faces[f][2]];
      return is_finite(a, b, c) ? covering(a, b, c, q) : 0;
    });
  });
  return result;
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_CERTIFICATE_H
