// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_DISTORTION_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_DISTORTION_H

#include <CGAL/Spherical_parameterization/internal/backend/formulas/power.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rounded.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// The distortion of a linear map with singular values s, t and determinant J = s t > 0, per source area:
///   D = 4 E_c E_a^theta,  E_c = (s^2 + t^2) / (2 J),  E_a = (J + 1/J) / 2,
/// the angle and the area distortion of P. Degener, J. Meseth, R. Klein, "An adaptable surface parametrization method",
/// IMR 2003. theta = 0 is the conformal energy MIPS; theta = 1 the symmetric Dirichlet energy s^2 + t^2 + 1/s^2 + 1/t^2
/// of J. Smith and S. Schaefer, "Bijective parameterization with free boundaries", SIGGRAPH 2015; as theta grows, maps
/// become authalic. At least 4, which is isometric; infinite where the map degenerates.
///
/// Written as D = (s^2 + t^2) psi(J).
class Distortion {
public:
  struct Psi {
    double value, first, second; ///< psi and its derivatives
  };

  explicit Distortion(double theta) : theta_(theta) {}

  /// With so much of the exponent of the area
  Distortion with_share_of_area(double share) const { return Distortion(share * theta_); }

  double value(double ratio) const
  {
    const double inverse = 1 / ratio;
    if(theta_ == 0)
      return 2 * inverse;
    if(theta_ == 1)
      return 1 + inverse * inverse;
    const double area = (ratio + inverse) / 2; // E_a
    return 2 * inverse * (std::isfinite(area) ? power(area, theta_) : area);
  }

  Psi psi(double ratio) const
  {
    const double inverse = 1 / ratio, inverse2 = inverse * inverse;
    if(theta_ == 0)
      return {2 * inverse, -2 * inverse2, 4 * inverse * inverse2};
    if(theta_ == 1)
      return {1 + inverse2, -2 * inverse * inverse2, 6 * inverse2 * inverse2};
    const double area = ratio + inverse;            // 2 E_a
    const double log_slope = (1 - inverse2) / area; // (log E_a)'
    const double log_bend = 2 * inverse2 * inverse / area - log_slope * log_slope;
    const double slope = theta_ * log_slope - inverse; // (log psi)'
    const double bend = theta_ * log_bend + inverse2;  // (log psi)''
    const double psi = value(ratio);
    return {psi, slope * psi, (slope * slope + bend) * psi};
  }

  Psi phi(double, const Psi&) const { return {0, 0, 0}; } ///< of the areas alone: nothing

private:
  double theta_;
};

/// The shape and the size of a source triangle.
struct Face_metric {
  double cotangent[3]; ///< of the angle at each corner
  double twice_area;
};

/// Triangles of the source count as at least this good: what a map could gain on degenerate ones is not worth what it
/// would do to their neighbours.
struct Metric_bounds {
  double aspect; ///< largest ratio of the principal stretches from an equilateral triangle
  double area;   ///< smallest area
};

/// The metric of the triangle p q r, after improving it to meet the bounds: the smaller principal stretch is raised to
/// the bound of the aspect ratio, then both to that of the area.
inline Face_metric face_metric(vec3 p, vec3 q, vec3 r, const Metric_bounds& bounds)
{
  constexpr double root3 = 1.7320508075688772;
  const vec3 a = sub(q, p), b = sub(r, p);
  double aa = inner(a, a), ab = inner(a, b), bb = inner(b, b);
  // The metric in the frame of an equilateral triangle of side 1.
  double xx = aa, xy = (2 * ab - aa) / root3, yy = (aa - 4 * ab + 4 * bb) / 3;
  const double split = std::sqrt((xx - yy) * (xx - yy) + 4 * xy * xy);
  double large = (xx + yy + split) / 2;
  double small = large > 0 ? (std::max)(0., (xx * yy - xy * xy) / large) : 0;
  const double least_area2 = bounds.area * bounds.area * 16 / 3; // of large * small
  bool is_changed = false;
  if(!(large > 1e-4 * bounds.area)) { // a point, for all that matters
    xx = yy = large = small = std::sqrt(least_area2);
    xy = 0;
    is_changed = true;
  }
  const double least = large / (bounds.aspect * bounds.aspect);
  if(small < least) {
    // the principal direction of the smaller stretch
    double x = xy, y = small - xx;
    if(std::abs(x) + std::abs(y) < 1e-8 * large) {
      x = small - yy;
      y = xy;
    }
    const double norm2 = x * x + y * y;
    const double gain = norm2 > 0 ? (least - small) / norm2 : 0;
    xx += gain * x * x;
    xy += gain * x * y;
    yy += gain * y * y;
    small = least;
    is_changed = true;
  }
  if(large * small < least_area2) {
    const double gain = std::sqrt(least_area2 / (large * small));
    large *= gain;
    small *= gain;
    xx *= gain;
    xy *= gain;
    yy *= gain;
    is_changed = true;
  }
  if(is_changed) {
    aa = xx;
    ab = (root3 * xy + xx) / 2;
    bb = (3 * yy - aa + 4 * ab) / 4;
  }
  const double twice_area = root3 / 2 * std::sqrt(large * small);
  return {{ab / twice_area, (aa - ab) / twice_area, (bb - ab) / twice_area}, twice_area};
}

/// The metric in six decimal digits: that of a triangle of the same area, to as many digits. A triangle that is turned
/// or moved has the same one, bit for bit, but for the exceptions of `rounded()`.
inline Face_metric in_six_digits(const Face_metric& metric)
{
  constexpr int digits = 20; // binary ones
  constexpr double root3 = 1.7320508075688772;
  const auto [x, j, k] = metric.cotangent;
  // (mean + half, off; off, mean - half) is the metric by twice the area, in the frame of an equilateral triangle.
  const double size = (x + j + k) * 2 / 3;
  const double half = rounded<digits>((x + j - 2 * k) / 3, size), off = rounded<digits>((x - j) / root3, size);
  const double mean = std::sqrt(half * half + off * off + 4. / 3);
  const double x_and_j = mean + half;
  return {{(x_and_j + root3 * off) / 2, (x_and_j - root3 * off) / 2, mean / 2 - half},
          rounded<digits>(metric.twice_area, metric.twice_area)};
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_RELAXATION_DISTORTION_H
