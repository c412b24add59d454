// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_FACE_QUADRATURE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_FACE_QUADRATURE_H

#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/spherical_harmonics/grids.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

/// A point of a face on the sphere, with the area that it stands for.
struct Quadrature_point {
  std::array<double, 3> barycentric; ///< between the corners, in space
  vec3 direction;
  double weight; ///< steradians
};

/// Integrals over spherical triangles of harmonics times what is smooth on the triangle: products of Gauss rules in
/// collapsed coordinates (A. Stroud, "Approximate Calculation of Multiple Integrals", 1971). Triangles that would need
/// more than eight points in each direction are cut into four.
template <class...>
class Face_quadrature {
public:
  Face_quadrature(int degree, double accuracy)
    : frequency_(degree + margin), accuracy_((std::max)(accuracy, least_accuracy))
  {
    for(int n = 1; n <= most_points; ++n)
      rule_.push_back(gauss_rule(n));
  }

  /// Calls f(point) for the points of the triangle of the unit vectors `corner`.
  template <class F>
  void for_each_point(const std::array<vec3, 3>& corner, F f) const
  {
    typedef std::array<double, 3> Barycentric;
    struct Part {
      std::array<Barycentric, 3> corner;
      double share;
    };
    const double determinant = inner(corner[0], outer(sub(corner[1], corner[0]), sub(corner[2], corner[0])));
    const auto in_space = [&](const Barycentric& b) {
      return add_scaled(add_scaled(scale(b[0], corner[0]), b[1], corner[1]), b[2], corner[2]);
    };
    std::vector<Part> parts = {{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 1}};
    while(!parts.empty()) {
      const Part part = parts.back();
      parts.pop_back();
      std::array<vec3, 3> p;
      for(int k = 0; k < 3; ++k)
        p[k] = in_space(part.corner[k]);
      const int n = points_needed(p);
      if(n > most_points && part.share > smallest_share) {
        std::array<Barycentric, 3> middle;
        for(int k = 0; k < 3; ++k)
          for(int i = 0; i < 3; ++i)
            middle[k][i] = (part.corner[(k + 1) % 3][i] + part.corner[(k + 2) % 3][i]) / 2;
        for(int k = 0; k < 3; ++k)
          parts.push_back({{part.corner[k], middle[(k + 2) % 3], middle[(k + 1) % 3]}, part.share / 4});
        parts.push_back({middle, part.share / 4});
        continue;
      }
      const auto& rule = rule_[(std::min)(n, most_points) - 1];
      for(const auto& [x, wx] : rule)
        for(const auto& [y, wy] : rule) {
          const double s = (1 + x) / 2, t = (1 - s) * (1 + y) / 2;
          Quadrature_point point;
          for(int i = 0; i < 3; ++i)
            point.barycentric[i] = (1 - s - t) * part.corner[0][i] + s * part.corner[1][i] + t * part.corner[2][i];
          point.direction = in_space(point.barycentric);
          const double length = norm(point.direction);
          point.weight = determinant * part.share * (1 - s) * wx * wy / 4 / (length * length * length);
          f(point);
        }
    }
  }

private:
  static constexpr int most_points = 8;
  static constexpr int margin = 6;                ///< the field and the Jacobian vary, too
  static constexpr double least_accuracy = 1e-15; ///< rounding errors are larger
  static constexpr double smallest_share = 1e-12; ///< beyond which a triangle is a great circle rather than a face

  /// In each direction, or more than `most_points`. The remainder of the rule of n points on an interval of length d is
  /// d^(2n + 1) (n!)^4 / ((2n + 1) (2n)!^3) times the derivative 2n, which is k^(2n) at most for a frequency k (S.
  /// Bernstein's inequality).
  int points_needed(const std::array<vec3, 3>& p) const
  {
    double longest = 0, least = inner(p[0], p[0]), largest = least;
    for(int k = 0; k < 3; ++k) {
      const vec3 a = p[k], b = p[(k + 1) % 3];
      longest = (std::max)(longest, std::atan2(norm(outer(a, b)), inner(a, b)));
      least = (std::min)(least, inner(a, a));
      largest = (std::max)(largest, inner(a, a));
    }
    constexpr double most_uneven = 1.5, longest_edge = 0.5; // of squared lengths; radians
    if(!(largest < most_uneven * least && longest < longest_edge))
      return most_points + 1;
    const double z = frequency_ * longest;
    double factor = 1; // z^(2n) n!^4 / (2n)!^3
    for(int n = 1; n <= most_points; ++n) {
      const double a = 2. * n * (2. * n - 1);
      factor *= z * z * (static_cast<double>(n) * n * n * n) / (a * a * a);
      if(factor / (2 * n + 1) < accuracy_)
        return n;
    }
    return most_points + 1;
  }

  double frequency_, accuracy_;
  std::vector<std::vector<std::pair<double, double>>> rule_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_SPHERICAL_HARMONICS_FACE_QUADRATURE_H
