// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_CERTIFICATE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_CERTIFICATE_H

#include <CGAL/Spherical_parameterization/internal/base/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/predicates/degree.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>
#include <CGAL/Spherical_parameterization/internal/predicates/spherical_area.h>
#include <CGAL/Spherical_parameterization/internal/base/host_loops.h>
#include <CGAL/Spherical_parameterization/internal/base/vec3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

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

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_PREDICATES_CERTIFICATE_H
