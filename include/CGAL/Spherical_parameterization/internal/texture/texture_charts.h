// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_CHARTS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_CHARTS_H

#include <CGAL/Spherical_parameterization/internal/api/compiled.h>
#include <CGAL/Spherical_parameterization/internal/algebra/vec3.h>
#include <CGAL/Spherical_parameterization/internal/predicates/orientation.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace CGAL::Spherical_parameterization::internal {

/// A point or vector of the plane.
struct vec2 {
  double x, y;
};
inline vec2 add(vec2 a, vec2 b) { return {a.x + b.x, a.y + b.y}; }
inline vec2 sub(vec2 a, vec2 b) { return {a.x - b.x, a.y - b.y}; }
inline vec2 scale(double s, vec2 a) { return {s * a.x, s * a.y}; }
inline double inner(vec2 a, vec2 b) { return a.x * b.x + a.y * b.y; }
inline double distance(vec2 a, vec2 b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// An orthonormal frame with z to the north pole.
struct Frame {
  vec3 x, y, z;

  /// \pre `north` is a unit vector to which `meridian` is not parallel
  Frame(vec3 north, vec3 meridian) : z(north)
  {
    x = unit(tangent(meridian, z));
    y = outer(z, x);
  }

  /// Coordinates in the frame. The offset from the nearer pole is taken first, which is exact near it: a limb with the
  /// pole in its tip keeps all its digits.
  vec3 operator()(vec3 p) const
  {
    const double height = inner(p, z);
    const vec3 offset = height < 0 ? add(p, z) : sub(p, z);
    return {inner(offset, x), inner(offset, y), height};
  }
};

typedef std::array<vec2, 3> Uv_triangle;

/// What a chart makes of a face.
struct Charted_face {
  Uv_triangle uv;
  double area = 0;         ///< on the chart, to first order; positive
  bool is_at_pole = false; ///< contains one, in its interior or as a corner
};

/// to - from, brought to [-1/2, 1/2] by whole turns
CGAL_SP_INLINE double shortest_turn(double from, double to)
{
  const double d = to - from;
  return d - std::nearbyint(d);
}

/// u = longitude / 2 pi, v = 1/2 + latitude / pi. Corners are continued past u = 1 from the westernmost one, which is
/// in [0, 1). A corner at a pole has the mean u of the two others. A face round a pole leaves out the edge nearest to
/// the pole: what is north of it is no triangle on the chart.
struct Latitude_longitude_chart {
  Frame frame;

  Charted_face operator()(const std::array<vec3, 3>& p) const
  {
    Charted_face face;
    std::array<double, 3> longitude;
    int pole = -1; // the corner that is one
    for(int k = 0; k < 3; ++k) {
      const vec3 q = frame(p[k]);
      const double to_axis = std::hypot(q.x, q.y);
      longitude[k] = std::atan2(q.y, q.x) / (2 * pi);
      longitude[k] -= std::floor(longitude[k]);
      const double to_pole = std::atan2(to_axis, std::abs(q.z)) / pi;
      face.uv[k].y = q.z < 0 ? to_pole : 1 - to_pole;
      if(to_axis == 0)
        pole = k;
    }
    int middle = 0; // the corner to start unwrapping from
    if(pole >= 0) {
      const int i = (pole + 1) % 3, j = (pole + 2) % 3;
      longitude[pole] = longitude[i] + shortest_turn(longitude[i], longitude[j]) / 2;
      middle = pole;
    } else {
      const double winding = shortest_turn(longitude[0], longitude[1]) + shortest_turn(longitude[1], longitude[2]) +
                             shortest_turn(longitude[2], longitude[0]);
      const int sign = static_cast<int>(std::lround(winding));
      face.is_at_pole = sign != 0;
      for(int k = 1; k < 3; ++k)
        if(sign * face.uv[k].y < sign * face.uv[middle].y)
          middle = k; // farthest from the pole
    }
    face.is_at_pole = face.is_at_pole || pole >= 0;
    for(int k = 0; k < 3; ++k) // by whole turns: a vertex off the seam has the same u in all faces that do not cross it
      face.uv[k].x = longitude[k] - std::nearbyint(longitude[k] - longitude[middle]);
    into_range(face.uv);

    const vec3 centre = unit(add(p[0], add(p[1], p[2])));
    const vec3 c = frame(centre);
    face.area = spherical_area(p[0], p[1], p[2]) / (2 * pi * pi * (std::max)(std::hypot(c.x, c.y), 1e-3));
    return face;
  }

  /// Moves a triangle by whole turns, and back between v = 0 and v = 1.
  static void into_range(Uv_triangle& t)
  {
    const double turns = std::floor((std::min)({t[0].x, t[1].x, t[2].x}));
    const double below = (std::min)({t[0].y, t[1].y, t[2].y, 0.}), above = (std::max)({t[0].y, t[1].y, t[2].y, 1.}) - 1;
    for(vec2& p : t)
      p = {p.x - turns, p.y - below - above};
  }
};

/// The octahedral map: central projection to the octahedron |x| + |y| + |z| = 1, whose northern half becomes the
/// diamond in the middle of the square and whose southern faces are unfolded to its corners. Each octant is mapped
/// projectively: faces inside of one cannot flip. The sides of the square are glued to themselves by half-turns about
/// their midpoints; corners are continued across them.
struct Octahedral_chart {
  Frame frame;

  Charted_face operator()(const std::array<vec3, 3>& p) const
  {
    Charted_face face;
    const vec3 centre = unit(add(p[0], add(p[1], p[2])));
    const vec2 home = in_square(centre);
    for(int k = 0; k < 3; ++k)
      face.uv[k] = nearest_image(in_square(p[k]), home);
    const vec3 c = frame(centre);
    const double s = std::abs(c.x) + std::abs(c.y) + std::abs(c.z);
    face.area = spherical_area(p[0], p[1], p[2]) / (4 * s * s * s);
    return face;
  }

  static void into_range(Uv_triangle&) {}

private:
  vec2 in_square(vec3 p) const
  {
    const vec3 q = frame(p);
    const double s = std::abs(q.x) + std::abs(q.y) + std::abs(q.z), x = q.x / s, y = q.y / s;
    if(q.z >= 0)
      return {(1 + x) / 2, (1 + y) / 2};
    return {(1 + std::copysign(1 - std::abs(y), x)) / 2, (1 + std::copysign(1 - std::abs(x), y)) / 2};
  }

  /// Of the copies of q in the square and in the eight squares round it the one that is nearest to `home`.
  static vec2 nearest_image(vec2 q, vec2 home)
  {
    vec2 best = q;
    for(int i = -1; i <= 1; ++i)
      for(int j = -1; j <= 1; ++j) {
        const bool is_turned = (i + j) % 2 != 0;
        const vec2 image = is_turned ? vec2{i + (1 - q.x), j + (1 - q.y)} : vec2{i + q.x, j + q.y};
        if(distance(image, home) < distance(best, home))
          best = image;
      }
    return best;
  }
};

/// Across a seam.
CGAL_SP_INLINE bool is_beyond_square(const Uv_triangle& t)
{
  return std::any_of(t.begin(), t.end(), [](vec2 p) { return p.x < 0 || p.x > 1 || p.y < 0 || p.y > 1; });
}

/// By the exact predicate, one dimension up: seen from the origin, the plane z = 1 keeps its orientation.
CGAL_SP_INLINE bool is_counterclockwise(const Uv_triangle& t)
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

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_TEXTURE_TEXTURE_CHARTS_H
