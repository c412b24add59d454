// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_MOEBIUS_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_MOEBIUS_H

#include <CGAL/Spherical_parameterization/internal/backend/Verbs.h>
#include <CGAL/Spherical_parameterization/internal/loops/Host_array.h>
#include <CGAL/Spherical_parameterization/internal/algebra/rotations.h>
#include <CGAL/Spherical_parameterization/internal/algebra/symmetric_solver.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Spherical_parameterization::internal {

inline vec3 first_moment(const Moments& m) { return {m[0], m[1], m[2]}; }

/// sum m_i, since the v_i are unit vectors
inline double total_mass(const Moments& m) { return m[3] + m[6] + m[8]; }

/// N = sum m_i P_i, the 3x3 matrix that turns a boost into the motion of the weighted centroid.
inline Symmetric_solver<3> boost_matrix(const Moments& m)
{
  return Symmetric_solver<3>({{{m[6] + m[8], -m[4], -m[5]}, {-m[4], m[3] + m[8], -m[7]}, {-m[5], -m[7], m[3] + m[6]}}});
}

inline vec3 solve(const Symmetric_solver<3>& matrix, vec3 b)
{
  const std::array<double, 3> x = matrix.solve({b.x, b.y, b.z});
  return {x[0], x[1], x[2]};
}

/// The vector t with sum m_i (1 + t . v_i) v_i = 0; 0 where some of these masses may be negative.
inline vec3 balancing_tilt(const Moments& m)
{
  const Symmetric_solver<3> second_moment({{{m[3], m[4], m[5]}, {m[4], m[6], m[7]}, {m[5], m[7], m[8]}}});
  const vec3 tilt = solve(second_moment, scale(-1, first_moment(m)));
  return norm(tilt) < 1 ? tilt : make_vec3(0, 0, 0);
}

/// Boosts v until |sum m_i v_i| <= tolerance sum m_i, by at most so many steps of Newton's method in the ball, with
/// backtracking. `scratch` has the size of v; `moments` are those of v, on entry and on return. Returns the centres of
/// the boosts, one after the other.
template <class Backend>
std::vector<vec3> balance(const Backend& backend, const typename Backend::Scalars& mass, double tolerance,
                          int maximum_steps, typename Backend::Vectors& v, typename Backend::Vectors& scratch,
                          Moments& moments)
{
  std::vector<vec3> boosts;
  constexpr int maximum_halvings = 30;
  constexpr double maximum_step = 0.9; // the ball ends at 1
  for(int it = 0; it < maximum_steps; ++it) {
    const double distance = norm(first_moment(moments));
    if(!(distance > tolerance * total_mass(moments)))
      break;
    vec3 c = scale(0.5, solve(boost_matrix(moments), first_moment(moments)));
    if(norm(c) > maximum_step)
      c = scale(maximum_step / norm(c), c);
    bool is_nearer = false;
    for(int h = 0; !is_nearer && h < maximum_halvings; ++h, c = scale(0.5, c)) {
      const Moments next = backend.transform(mass, c, v, scratch);
      is_nearer = norm(first_moment(next)) < distance;
      if(is_nearer) {
        boosts.push_back(c);
        std::swap(v, scratch);
        moments = next;
      }
    }
    if(!is_nearer)
      break;
  }
  return boosts;
}

/// Boosts v, unit vectors, until the centroid of `area` is so near to the centre of the sphere, or as near as rounding
/// allows. `scratch` has the size of v.
template <class Backend>
void centre(const Backend& backend, const typename Backend::Scalars& area, double tolerance,
            typename Backend::Vectors& v, typename Backend::Vectors& scratch)
{
  constexpr int maximum_steps = 50;
  tolerance = (std::max)(tolerance, backend.rounding());
  Moments moments = backend.moments(area, v);
  balance(backend, area, tolerance, maximum_steps, v, scratch, moments);
}

/// The Moebius transformation of orientation 1 (boosts and rotations) that brings `from` closest to `to` in the sense
/// of least squares, by the Gauss-Newton method from the best rotation: a local minimum, which need not be 0 for three
/// points that have to be moved far. Returned as a sequence of boosts, each followed by a rotation.
class Moebius_alignment {
public:
  Moebius_alignment(Host_array<vec3> from, const Host_array<vec3>& to)
  {
    steps_.push_back({make_vec3(0, 0, 0), best_rotation(from, to)});
    from = moved(steps_.back(), from);
    constexpr int maximum_iterations = 100;
    constexpr double longest_boost = 0.9; // the ball ends at 1
    double error = distance2(from, to);
    for(int it = 0; it < maximum_iterations && error > 1e-30 * static_cast<double>(from.size()); ++it) {
      const std::array<double, 6> step = gauss_newton_step(from, to);
      bool is_nearer = false;
      for(double t = 1; !is_nearer && t > 1e-9; t /= 2) {
        const Step candidate = {{t * step[3], t * step[4], t * step[5]},
                                rotation_about({t * step[0], t * step[1], t * step[2]})};
        if(inner(candidate.centre, candidate.centre) >= longest_boost * longest_boost)
          continue;
        Host_array<vec3> nearer = moved(candidate, from);
        const double next = distance2(nearer, to);
        is_nearer = next < error;
        if(is_nearer) {
          steps_.push_back(candidate);
          from = std::move(nearer);
          error = next;
        }
      }
      if(!is_nearer)
        return;
    }
  }

  vec3 operator()(vec3 p) const
  {
    for(const Step& s : steps_)
      p = transformed(s, p);
    return p;
  }

private:
  struct Step {
    vec3 centre;
    Matrix_3 rotation;
  };

  static vec3 transformed(const Step& s, vec3 p) { return unit(rotated(s.rotation, boost(p, s.centre))); }

  static Host_array<vec3> moved(const Step& s, Host_array<vec3> points)
  {
    for(vec3& p : points)
      p = transformed(s, p);
    return points;
  }

  static double distance2(const Host_array<vec3>& a, const Host_array<vec3>& b)
  {
    double sum = 0;
    for(std::size_t k = 0; k < a.size(); ++k)
      sum += squared_distance(a[k], b[k]);
    return sum;
  }

  /// Rotation vector and boost centre, from d x = r x x - 2 P_x c.
  static std::array<double, 6> gauss_newton_step(const Host_array<vec3>& from, const Host_array<vec3>& to)
  {
    Symmetric_solver<6>::Matrix normal = {};
    std::array<double, 6> right = {};
    for(std::size_t k = 0; k < from.size(); ++k) {
      const vec3 x = from[k], e = sub(to[k], x);
      const std::array<vec3, 3> axis = {vec3{1, 0, 0}, vec3{0, 1, 0}, vec3{0, 0, 1}};
      std::array<vec3, 6> column;
      for(int c = 0; c < 3; ++c) {
        column[c] = outer(axis[c], x);
        column[c + 3] = scale(-2, tangent(axis[c], x));
      }
      for(int i = 0; i < 6; ++i) {
        right[i] += inner(column[i], e);
        for(int j = 0; j < 6; ++j)
          normal[i][j] += inner(column[i], column[j]);
      }
    }
    double trace = 0;
    for(int i = 0; i < 6; ++i)
      trace += normal[i][i];
    for(int i = 0; i < 6; ++i)
      normal[i][i] += 1e-12 * trace;
    return Symmetric_solver<6>(normal).solve(right);
  }

  std::vector<Step> steps_;
};

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_MOEBIUS_MOEBIUS_H
