// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SPHERICAL_TRIANGLES_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SPHERICAL_TRIANGLES_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/predicates/degree.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/backend/vertex_formulas.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Spherical_parameterization {
namespace internal {

/// Signed area of the spherical triangle (a, b, c) of unit vectors, positive if it is seen counter-clockwise from
/// outside; in (-2 pi, 2 pi). Triangles far below the resolution of the coordinates keep a meaningful size.
inline double spherical_area(vec3 a, vec3 b, vec3 c)
{
  const double volume = inner(a, outer(sub(b, a), sub(c, a)));
  const double denominator = 1 + inner(a, b) + inner(b, c) + inner(c, a);
  const double tangent = volume / denominator;
  if(denominator > 0 && std::abs(tangent) < 1e-3) // small triangles are many, and two terms are exact to 1e-12
    return 2 * (tangent - tangent * tangent * tangent / 3);
  return 2 * std::atan2(volume, denominator);
}

/// Whether (a, b, c) is positively oriented as seen from outside: the sign of det(a, b, c), exactly.
///
/// The filter: det(a, b, c) = a . ((b - a) x (c - a)), which rounding changes by at most 16 u |a| |b - a| |c - a|,
/// u = 2^-53, far from underflow. It decides about all but the thinnest triangles, however small they are.
inline bool is_positively_oriented(vec3 a, vec3 b, vec3 c)
{
  constexpr double rounding2 = 256 * 1.2325951644078310e-32; // (16 u)^2
  constexpr double underflow = 1e-100;
  const vec3 ab = sub(b, a), ac = sub(c, a);
  const double determinant = inner(a, outer(ab, ac));
  if(std::abs(determinant) > underflow &&
     determinant * determinant > 1.01 * rounding2 * inner(a, a) * inner(ab, ab) * inner(ac, ac))
    return determinant > 0;
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  const auto point = [](vec3 p) { return Kernel::Point_3(p.x, p.y, p.z); };
  return Kernel().orientation_3_object()(Kernel::Point_3(0, 0, 0), point(a), point(b), point(c)) == CGAL::POSITIVE;
}

inline bool is_finite(vec3 a) { return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z); }
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
template <class Loop>
Certificate certify(const Loop& loop, const Host_array<std::array<int, 3>>& faces, const Host_array<vec3>& v)
{
  struct Part {
    Certificate certificate;
    double shortest2 = std::numeric_limits<double>::infinity();
  };
  const std::vector<Part> parts = results_of_parts(loop, static_cast<int>(faces.size()), [&](int begin, int end) {
    Part part;
    for(int f = begin; f < end; ++f) {
      const vec3 a = v[faces[f][0]], b = v[faces[f][1]], c = v[faces[f][2]];
      if(!is_finite(a, b, c)) {
        ++part.certificate.flipped_faces;
        continue;
      }
      if(!is_positively_oriented(a, b, c))
        ++part.certificate.flipped_faces;
      part.certificate.smallest_area = (std::min)(part.certificate.smallest_area, std::abs(spherical_area(a, b, c)));
      for(vec3 edge : {sub(b, a), sub(c, b), sub(a, c)})
        part.shortest2 = (std::min)(part.shortest2, inner(edge, edge));
    }
    part.certificate.smallest_edge = std::sqrt(part.shortest2);
    return part;
  });

  Certificate result;
  for(const Part& part : parts) {
    result.flipped_faces += part.certificate.flipped_faces;
    result.smallest_area = (std::min)(result.smallest_area, part.certificate.smallest_area);
    result.smallest_edge = (std::min)(result.smallest_edge, part.certificate.smallest_edge);
  }
  result.degree = degree([&](vec3 q) {
    return sum_by_parts(loop, static_cast<int>(faces.size()), [&](int f) {
      const vec3 a = v[faces[f][0]], b = v[faces[f][1]], c = v[faces[f][2]];
      return is_finite(a, b, c) ? covering(a, b, c, q) : 0;
    });
  });
  return result;
}

} // namespace internal
} // namespace Spherical_parameterization
} // namespace CGAL

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_SPHERICAL_TRIANGLES_H
