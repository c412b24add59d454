// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_UV_GRID_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_UV_GRID_H

#include <CGAL/Spherical_parameterization/internal/base/plane.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

typedef std::array<vec2, 3> Uv_triangle;

/// By the exact predicate, one dimension up: seen from the origin, the plane z = 1 keeps its orientation.
inline bool is_counterclockwise(const Uv_triangle& t)
{
  const auto lifted = [](vec2 p) { return make_vec3(p.x, p.y, 1); };
  return is_positively_oriented(lifted(t[0]), lifted(t[1]), lifted(t[2]));
}

/// The multiples of 2^-bits: between -2 and 2 all of them are doubles for bits = 52, and floats for bits = 23. What is
/// decided about points of the grid stays true when they are stored as such.
class Uv_grid {
public:
  explicit Uv_grid(int bits) : cell_(std::ldexp(1., -bits)) {}

  double cell() const { return cell_; }

  double rounded(double x) const { return std::nearbyint(x / cell_) * cell_; }
  vec2 rounded(vec2 p) const { return {rounded(p.x), rounded(p.y)}; }
  Uv_triangle rounded(const Uv_triangle& t) const { return {rounded(t[0]), rounded(t[1]), rounded(t[2])}; }

  /// A counter-clockwise triangle of the grid close to `t`, for triangles that rounding, or the curvature of the chart,
  /// has flipped: the corner opposite to the longest edge moves to its proper side, as far as `area` (that of the
  /// triangle before it was flipped) says, but at least by one cell.
  Uv_triangle turned_over(const Uv_triangle& t, double area) const
  {
    Uv_triangle r = rounded(t);
    int apex = 0;
    for(int k = 1; k < 3; ++k)
      if(distance(r[(k + 1) % 3], r[(k + 2) % 3]) > distance(r[(apex + 1) % 3], r[(apex + 2) % 3]))
        apex = k;
    vec2& p = r[(apex + 1) % 3];
    vec2& q = r[(apex + 2) % 3];
    if(p.x == q.x && p.y == q.y) // all in one point
      q = {p.x + cell_, p.y};
    const double length = distance(p, q);
    const vec2 along = scale(1 / length, sub(q, p)), left = {-along.y, along.x};
    const double place = std::clamp(inner(sub(r[apex], p), along), 0., length);
    const vec2 foot = add(p, scale(place, along));
    double height = std::clamp(2 * area / length, cell_, (std::max)(cell_, 0.25));
    do {
      r[apex] = rounded(add(foot, scale(height, left)));
      height *= 2; // twice at most: rounding moves a point by less than a cell
    } while(!is_counterclockwise(r));
    return r;
  }

private:
  double cell_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_UV_GRID_H
