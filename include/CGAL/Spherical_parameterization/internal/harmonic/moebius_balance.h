// SPDX-License-Identifier: LGPL-3.0-or-later
// Part of CGAL Spherical Parameterization.

#ifndef CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_MOEBIUS_BALANCE_H
#define CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_MOEBIUS_BALANCE_H

#include <CGAL/Spherical_parameterization/internal/backend/Host_backend.h>
#include <CGAL/Spherical_parameterization/internal/base/symmetric_solver.h>

#include <array>
#include <cmath>
#include <utility>

namespace CGAL::Spherical_parameterization::internal {

inline vec3 first_moment(const Moments& m) { return {m.first[0], m.first[1], m.first[2]}; }

/// sum m_i, since the v_i are unit vectors
inline double total_mass(const Moments& m) { return m.second[0] + m.second[3] + m.second[5]; }

/// N = sum m_i P_i, the 3x3 matrix that turns a boost into the motion of the weighted centroid.
inline Symmetric_solver<3> boost_matrix(const Moments& m)
{
  const std::array<double, 6>& s = m.second;
  return Symmetric_solver<3>({{{s[3] + s[5], -s[1], -s[2]}, {-s[1], s[0] + s[5], -s[4]}, {-s[2], -s[4], s[0] + s[3]}}});
}

inline vec3 solve(const Symmetric_solver<3>& matrix, vec3 b)
{
  const std::array<double, 3> x = matrix.solve({b.x, b.y, b.z});
  return {x[0], x[1], x[2]};
}

/// Boosts v until |sum m_i v_i| <= tolerance sum m_i, by at most so many steps of Newton's method in the ball, with
/// backtracking. `scratch` has the size of v; `moments` are those of v, on entry and on return.
template <class Backend>
void balance(const Backend& backend, const typename Backend::Scalars& mass, double tolerance, int maximum_steps,
             typename Backend::Vectors& v, typename Backend::Vectors& scratch, Moments& moments)
{
  constexpr int maximum_halvings = 30;
  constexpr double maximum_step = 0.9; // the ball ends at 1
  for(int it = 0; it < maximum_steps; ++it) {
    const double distance = norm(first_moment(moments));
    if(!(distance > tolerance * total_mass(moments)))
      return;
    vec3 c = scale(0.5, solve(boost_matrix(moments), first_moment(moments)));
    if(norm(c) > maximum_step)
      c = scale(maximum_step / norm(c), c);
    bool is_nearer = false;
    for(int h = 0; !is_nearer && h < maximum_halvings; ++h, c = scale(0.5, c)) {
      const Moments next = backend.transform(mass, c, v, scratch);
      is_nearer = norm(first_moment(next)) < distance;
      if(is_nearer) {
        std::swap(v, scratch);
        moments = next;
      }
    }
    if(!is_nearer)
      return;
  }
}

/// Boosts v, unit vectors, until the centroid of `area` is at the centre of the sphere. `scratch` has the size of v.
template <class Backend>
void centre(const Backend& backend, const typename Backend::Scalars& area, typename Backend::Vectors& v,
            typename Backend::Vectors& scratch)
{
  constexpr int maximum_steps = 50;
  constexpr double tolerance = 1e-5;
  Moments moments = backend.moments(area, v);
  balance(backend, area, tolerance, maximum_steps, v, scratch, moments);
}

} // namespace CGAL::Spherical_parameterization::internal

#endif // CGAL_SPHERICAL_PARAMETERIZATION_INTERNAL_HARMONIC_MOEBIUS_BALANCE_H
